// Numbers as Piping Component Files write them: points, bores in inch fractions, angles.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/piping/pcf_numbers.h"

#include <array>
#include <charconv>
#include <cmath>
#include <system_error>
#include <utility>
#include <vector>

#include "vision/piping/pcf_text.h"

namespace spool::piping {
namespace {

// A number at the start of `text`, which is moved past it.
std::optional<double> take_number(std::string_view& text) {
  std::string_view digits = text;
  if (!digits.empty() && digits.front() == '+') digits.remove_prefix(1);  // from_chars takes none
  double value = 0;
  const auto [end, failed] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (failed != std::errc{} || !std::isfinite(value)) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return value;
}

bool is_word(std::string_view text) {
  return !text.empty() && text.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ") == std::string::npos;
}

// Words between blanks, semicolons and those commas that end a word.
std::vector<std::string_view> fields_of(std::string_view value) {
  std::vector<std::string_view> fields;
  for (std::string_view word : words_of(value)) {
    std::size_t at = 0;
    // "1,2,3": commas that separate. "1234,5": one comma, a decimal one.
    const bool separates = word.find(',') != word.rfind(',') ||
                           word.find(';') != std::string_view::npos || word.back() == ',';
    while (separates && at < word.size()) {
      const std::size_t end = std::min(word.find_first_of(",;", at), word.size());
      if (end > at) fields.push_back(word.substr(at, end - at));
      at = end + 1;
    }
    if (!separates) fields.push_back(word);
  }
  return fields;
}

}  // namespace

std::optional<double> number_of(std::string_view word) {
  std::string point(word);
  const std::size_t comma = point.find(',');
  if (comma != std::string::npos && point.find('.') == std::string::npos) point[comma] = '.';
  std::string_view rest = point;
  const std::optional<double> value = take_number(rest);
  if (!value || !rest.empty()) return std::nullopt;
  return value;
}

std::optional<double> bore_of(std::string_view word) {
  std::string text = to_capitals(word);
  for (const std::string_view unit : {"\"", "MM", "IN", "NB", "''"}) {
    if (text.size() > unit.size() &&
        text.compare(text.size() - unit.size(), unit.size(), unit) == 0)
      text.resize(text.size() - unit.size());
  }
  if (const std::optional<double> plain = number_of(text)) return *plain > 0 ? plain : std::nullopt;
  std::string_view rest = text;
  std::optional<double> whole = take_number(rest);
  if (!whole || rest.empty()) return std::nullopt;
  double value = 0;
  std::optional<double> over = whole;
  if (rest.front() == '-') {  // 1-1/2
    value = *whole;
    rest.remove_prefix(1);
    over = take_number(rest);
  }
  if (!over || rest.empty() || rest.front() != '/') return std::nullopt;
  rest.remove_prefix(1);
  const std::optional<double> under = take_number(rest);
  if (!under || !rest.empty() || !(*under > 0)) return std::nullopt;
  value += *over / *under;
  if (!(value > 0) || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::optional<RawPoint> point_of(std::string_view value) {
  const std::vector<std::string_view> fields = fields_of(value);
  if (fields.size() < 3) return std::nullopt;
  RawPoint point;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::optional<double> coordinate = number_of(fields[i]);
    if (!coordinate) return std::nullopt;
    point.position[static_cast<Eigen::Index>(i)] = *coordinate;
  }
  std::size_t at = 3;
  if (at < fields.size()) {
    if (const std::optional<double> bore = bore_of(fields[at])) {
      point.bore = bore;
      ++at;
      // "1 1/2": the fraction is a word of its own.
      const bool is_fraction = at < fields.size() && fields[at].find('/') != std::string_view::npos;
      if (is_fraction) {
        if (const std::optional<double> more = bore_of(fields[at])) point.bore = *bore + *more;
        ++at;
      }
    } else if (number_of(fields[at])) {
      ++at;  // zero: no bore given
    } else if (!is_word(to_capitals(fields[at]))) {
      point.trouble = "the bore '" + std::string(fields[at]) + "' is no size";
      ++at;
    }
  }
  if (at < fields.size()) {
    const std::string end = to_capitals(fields[at]);
    if (is_word(end) && end.size() <= 4) {
      point.end = end;
    } else {
      point.trouble = "'" + std::string(fields[at]) + "' is no type of end";
    }
  }
  return point;
}

double angle_nearest(double written, double drawn) {
  return std::abs(written - drawn) <= std::abs(written / 100 - drawn) ? written : written / 100;
}

std::optional<Eigen::Vector3d> direction_of(std::string_view value) {
  const std::string text = to_capitals(value);
  constexpr std::array<std::pair<std::string_view, std::array<double, 3>>, 18> kNames{{
      {"UP", {0, 0, 1}},
      {"U", {0, 0, 1}},
      {"DOWN", {0, 0, -1}},
      {"D", {0, 0, -1}},
      {"NORTH", {0, 1, 0}},
      {"N", {0, 1, 0}},
      {"SOUTH", {0, -1, 0}},
      {"S", {0, -1, 0}},
      {"EAST", {1, 0, 0}},
      {"E", {1, 0, 0}},
      {"WEST", {-1, 0, 0}},
      {"W", {-1, 0, 0}},
      {"NE", {1, 1, 0}},
      {"NW", {-1, 1, 0}},
      {"SE", {1, -1, 0}},
      {"SW", {-1, -1, 0}},
      {"TOP", {0, 0, 1}},
      {"BOTTOM", {0, 0, -1}},
  }};
  for (const auto& [word, to] : kNames) {
    if (text == word) return Eigen::Vector3d(to[0], to[1], to[2]).normalized();
  }
  const std::optional<RawPoint> numbers = point_of(text);
  if (!numbers || !(numbers->position.norm() > 1e-9) || !(numbers->position.norm() < 1e9))
    return std::nullopt;
  return numbers->position.normalized();
}

}  // namespace spool::piping
