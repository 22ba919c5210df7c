// The header of a PCD file: its fields, size and kind of data.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/scan/pcd_header.h"

#include <optional>

#include "vision/scan/text_scanner.h"

namespace spool {
namespace {

std::optional<Scalar> scalar_of(std::string_view type, std::uint64_t size) {
  struct Row {
    char type;
    std::uint64_t size;
    Scalar scalar;
  };
  static constexpr Row kTypes[] = {{'I', 1, Scalar::kInt8},  {'U', 1, Scalar::kUint8},
                                   {'I', 2, Scalar::kInt16}, {'U', 2, Scalar::kUint16},
                                   {'I', 4, Scalar::kInt32}, {'U', 4, Scalar::kUint32},
                                   {'I', 8, Scalar::kInt64}, {'U', 8, Scalar::kUint64},
                                   {'F', 4, Scalar::kFloat}, {'F', 8, Scalar::kDouble}};
  for (const Row& row : kTypes)
    if (type.size() == 1 && type[0] == row.type && size == row.size) return row.scalar;
  return std::nullopt;
}

std::vector<std::string> words_of(std::string_view text) {
  std::vector<std::string> words;
  for (std::string_view word = next_word(text); !word.empty(); word = next_word(text))
    words.emplace_back(word);
  return words;
}

// The header's lines as words, before they are understood together.
struct Lines {
  std::vector<std::string> fields, sizes, types, counts, width, height, points, viewpoint, data;

  std::vector<std::string>* find(std::string_view key) {
    if (key == "FIELDS" || key == "COLUMNS") return &fields;
    if (key == "SIZE") return &sizes;
    if (key == "TYPE") return &types;
    if (key == "COUNT") return &counts;
    if (key == "WIDTH") return &width;
    if (key == "HEIGHT") return &height;
    if (key == "POINTS") return &points;
    if (key == "VIEWPOINT") return &viewpoint;  // not applied: the points stand as they are
    if (key == "DATA") return &data;
    return nullptr;
  }
};

// The single count of a line; `otherwise` where the line is not there.
std::optional<std::uint64_t> count_of(const std::vector<std::string>& line,
                                      std::uint64_t otherwise) {
  if (line.empty()) return otherwise;
  return line.size() == 1 ? parse_count(line[0]) : std::nullopt;
}

// Fills the fields; the sentence that says what is wrong, or nothing. No field may be longer than
// the file can be (`limit`), so that no sum or product below overflows.
std::optional<std::string> set_fields(PcdHeader& header, const Lines& lines, std::uint64_t limit) {
  const std::size_t n = lines.fields.size();
  if (n == 0) return "its header has no FIELDS";
  if (lines.sizes.size() != n || lines.types.size() != n ||
      (!lines.counts.empty() && lines.counts.size() != n))
    return "its header has not one SIZE, TYPE and COUNT for each of its " + std::to_string(n) +
           " fields";
  for (std::size_t i = 0; i < n; ++i) {
    PcdField field;
    field.name = lines.fields[i];
    const auto size = parse_count(lines.sizes[i]);
    const auto type = size ? scalar_of(lines.types[i], *size) : std::nullopt;
    const auto count =
        lines.counts.empty() ? std::optional<std::uint64_t>(1) : parse_count(lines.counts[i]);
    if (!type || !count || *count > limit)
      return "its field \"" + field.name + "\" has a SIZE, TYPE or COUNT that does not exist";
    field.type = *type;
    field.count = *count;
    field.offset = header.point_bytes;
    field.word = header.point_words;
    header.point_bytes += field.bytes();
    header.point_words += field.count;
    if (header.point_bytes > limit) return "its points are larger than the whole file";
    header.fields.push_back(std::move(field));
  }
  for (const char* axis : {"x", "y", "z"}) {
    const PcdField* field = header.find(axis);
    if (field == nullptr || field->count != 1) return "its points have no x, y and z";
  }
  return std::nullopt;
}

std::optional<std::string> set_size(PcdHeader& header, const Lines& lines) {
  const auto points = count_of(lines.points, 0);
  const auto width = count_of(lines.width, points.value_or(0));
  const auto height = count_of(lines.height, 1);
  if (!points || !width || !height)
    return "its WIDTH, HEIGHT or POINTS is no count (a whole number, not negative)";
  if (*height > 0 && *width > UINT64_MAX / *height) return "its WIDTH times HEIGHT is impossible";
  header.width = *width;
  header.height = *height;
  header.points = lines.points.empty() ? *width * *height : *points;
  if (header.points != *width * *height)
    return "its POINTS (" + std::to_string(header.points) + ") are not its WIDTH times HEIGHT (" +
           std::to_string(*width * *height) + ")";
  return std::nullopt;
}

}  // namespace

const PcdField* PcdHeader::find(std::string_view name) const {
  for (const PcdField& field : fields)
    if (field.name == name) return &field;
  return nullptr;
}

Result<PcdHeader> read_pcd_header(std::string_view bytes, const std::string& name) {
  const auto refused = [&](const std::string& why) {
    return Error{ErrorCode::kBadInput, name + ": " + why + "; copy or export it again"};
  };
  Lines lines;
  LineScanner scanner(bytes);
  bool has_version = false;
  while (lines.data.empty()) {
    const auto line = scanner.next();
    if (!line)
      return refused(has_version ? "is cut short: its header has no DATA line"
                                 : "is not a PCD file (it has no PCD header)");
    constexpr std::size_t kLongestLine = 65536;
    if (line->size() > kLongestLine)
      return refused("is not a PCD file (its header has an endless line)");
    std::string_view rest = *line;
    const std::string_view key = next_word(rest);
    if (key.empty() || key.starts_with('#')) continue;
    if (key == "VERSION") {
      has_version = true;
      continue;
    }
    std::vector<std::string>* const kept = lines.find(key);
    if (kept == nullptr)
      return refused(has_version ? "header line " + std::to_string(scanner.line_number()) +
                                       " is no line of a PCD header"
                                 : "is not a PCD file (it has no PCD header)");
    *kept = words_of(rest);
    if (key == "DATA" && kept->empty()) return refused("does not say what kind of DATA it holds");
    if (key == "FIELDS") has_version = true;  // enough to know what it is
  }
  PcdHeader header;
  header.body = scanner.rest();
  header.lines = scanner.line_number();
  if (lines.data[0] == "ascii")
    header.data = PcdHeader::Data::kAscii;
  else if (lines.data[0] == "binary")
    header.data = PcdHeader::Data::kBinary;
  else if (lines.data[0] == "binary_compressed")
    header.data = PcdHeader::Data::kCompressed;
  else
    return refused(
        "holds a kind of DATA that is not known (ascii, binary and binary_compressed are)");
  // Packed bytes can stand for 88 times as many, text takes at least a character a number.
  const std::uint64_t limit = 88 * static_cast<std::uint64_t>(bytes.size());
  if (const auto wrong = set_fields(header, lines, limit)) return refused(*wrong);
  if (const auto wrong = set_size(header, lines)) return refused(*wrong);
  return header;
}

}  // namespace spool
