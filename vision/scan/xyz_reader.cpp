// Points of a text file: x y z and perhaps a normal a line, parted by blanks, commas or semicolons.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "vision/scan/cloud_reader.h"
#include "vision/scan/text_scanner.h"

namespace spool {
namespace {

// The words of one line and what parts them: 0 for blanks only, ',' or ';'.
struct Row {
  std::vector<std::string_view> words;
  char separator = 0;
  bool is_mixed =
      false;  // parted here by one sign and there by another: a decimal comma would read so
};

constexpr bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\v' || c == '\f' || c == '\r';
}
constexpr bool is_sign(char c) { return c == ',' || c == ';'; }

void split(std::string_view line, Row& row) {
  row.words.clear();
  row.separator = 0;
  row.is_mixed = false;
  std::size_t at = 0;
  const auto skip_blanks = [&] {
    while (at < line.size() && is_blank(line[at])) ++at;
  };
  skip_blanks();
  while (at < line.size()) {
    const std::size_t begin = at;
    while (at < line.size() && !is_blank(line[at]) && !is_sign(line[at])) ++at;
    row.words.push_back(line.substr(begin, at - begin));
    skip_blanks();
    if (at == line.size()) return;
    const char separator = is_sign(line[at]) ? line[at++] : '\0';
    skip_blanks();
    if (at == line.size()) return;  // a sign at the line's end parts nothing
    if (row.words.size() == 1)
      row.separator = separator;
    else
      row.is_mixed = row.is_mixed || separator != row.separator;
  }
}

bool starts_comment(std::string_view line) {
  const std::size_t at = line.find_first_not_of(" \t");
  return at != std::string_view::npos && (line[at] == '#' || line.substr(at).starts_with("//"));
}

// A first line that names the columns, or holds nothing but the number of points.
bool is_heading(const Row& row) {
  if (row.words.size() == 1)
    return parse_count(row.words[0]).has_value() || !parse_number(row.words[0]);
  for (const std::string_view word : row.words)
    if (parse_number(word)) return false;
  return true;
}

// Columns four to six are a normal where every one of them is of unit length, or zero for none.
bool is_normal(const Eigen::Vector3d& vector) {
  const double length = vector.norm();
  return length == 0 || std::abs(length - 1) < 0.02;  // printed to two digits or more
}

}  // namespace

Result<RawCloud> read_xyz(std::string_view bytes, const std::string& name) {
  RawCloud cloud;
  LineScanner lines(bytes);
  Row row;
  std::size_t columns = 0;  // of the first line of numbers
  bool has_heading = false;
  bool normals_good = true;
  while (const auto line = lines.next()) {
    if (starts_comment(*line)) continue;
    split(*line, row);
    if (row.words.empty()) continue;
    const auto refused = [&](const std::string& why) {
      return Error{ErrorCode::kBadInput, name + ": line " + std::to_string(lines.line_number()) +
                                             " " + why +
                                             "; write x y z with decimal points, one point a line"};
    };
    if (columns == 0 && !has_heading && is_heading(row)) {
      has_heading = true;
      cloud.warnings.push_back(name + ": line " + std::to_string(lines.line_number()) +
                               " is taken for a heading and left out");
      continue;
    }
    if (row.is_mixed) return refused("is parted by blanks and signs in turn");
    if (columns == 0) columns = row.words.size();
    if (columns < 3) return refused("has fewer than three columns");
    if (row.words.size() != columns)
      return refused("has " + std::to_string(row.words.size()) + " columns where the first has " +
                     std::to_string(columns));
    const bool maybe_normal = columns >= 6 && normals_good;
    Eigen::Matrix<double, 6, 1> values = Eigen::Matrix<double, 6, 1>::Zero();
    for (Eigen::Index i = 0; i < (maybe_normal ? 6 : 3); ++i) {
      const auto value = parse_number(row.words[static_cast<std::size_t>(i)]);
      if (value) {
        values[i] = *value;
      } else if (i < 3) {
        return refused("has text where a number belongs");
      } else {
        normals_good = false;
      }
    }
    cloud.points.emplace_back(values.head<3>());
    if (!maybe_normal) continue;
    normals_good = normals_good && is_normal(values.tail<3>());
    cloud.normals.emplace_back(values.tail<3>().cast<float>());
  }
  if (columns >= 6 && !normals_good) {
    cloud.normals.clear();
    cloud.warnings.push_back(name + ": columns four to six are no unit normals and are left out");
  }
  return cloud;
}

}  // namespace spool
