// The header of a PLY file: what elements follow and what each is made of.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/scan/ply_header.h"

#include <algorithm>
#include <array>

#include "vision/scan/text_scanner.h"

namespace spool {
namespace {

std::optional<Scalar> scalar_of(std::string_view word) {
  struct Row {
    std::string_view old_name, new_name;
    Scalar type;
  };
  static constexpr std::array<Row, 8> kTypes = {{{"char", "int8", Scalar::kInt8},
                                                 {"uchar", "uint8", Scalar::kUint8},
                                                 {"short", "int16", Scalar::kInt16},
                                                 {"ushort", "uint16", Scalar::kUint16},
                                                 {"int", "int32", Scalar::kInt32},
                                                 {"uint", "uint32", Scalar::kUint32},
                                                 {"float", "float32", Scalar::kFloat},
                                                 {"double", "float64", Scalar::kDouble}}};
  for (const Row& row : kTypes)
    if (word == row.old_name || word == row.new_name) return row.type;
  return std::nullopt;
}

// "property float x" or "property list uchar int vertex_indices", the first word cut off already.
std::optional<PlyProperty> property_of(std::string_view rest) {
  PlyProperty property;
  std::string_view word = next_word(rest);
  if (word == "list") {
    property.list_length_type = scalar_of(next_word(rest));
    if (!property.list_length_type || *property.list_length_type == Scalar::kFloat ||
        *property.list_length_type == Scalar::kDouble)
      return std::nullopt;
    word = next_word(rest);
  }
  const auto type = scalar_of(word);
  property.name = next_word(rest);
  if (!type || property.name.empty() || !next_word(rest).empty()) return std::nullopt;
  property.type = *type;
  return property;
}

// "ascii 1.0" and the two binaries.
bool set_format(PlyHeader& header, std::string_view rest) {
  const std::string_view format = next_word(rest);
  if (next_word(rest) != "1.0") return false;
  if (format == "ascii") {
    header.format = PlyHeader::Format::kAscii;
    return true;
  }
  header.format = PlyHeader::Format::kBinary;
  header.order = format == "binary_big_endian" ? ByteOrder::kBig : ByteOrder::kLittle;
  return format == "binary_big_endian" || format == "binary_little_endian";
}

}  // namespace

bool PlyElement::has_lists() const {
  return std::any_of(properties.begin(), properties.end(),
                     [](const PlyProperty& p) { return p.list_length_type.has_value(); });
}

std::size_t PlyElement::stride() const {
  std::size_t bytes = 0;
  for (const PlyProperty& property : properties)
    bytes += bytes_of(property.list_length_type.value_or(property.type));
  return bytes;
}

Result<PlyHeader> read_ply_header(std::string_view bytes, const std::string& name) {
  const auto refused = [&](const std::string& why) {
    return Error{ErrorCode::kBadInput, name + ": " + why + "; export it again"};
  };
  LineScanner lines(bytes);
  auto line = lines.next();
  if (!line || *line != "ply") return refused("is not a PLY file (it does not begin with \"ply\")");
  PlyHeader header;
  bool has_format = false;
  while ((line = lines.next())) {
    const auto bad = [&](const std::string& what) {
      return refused("header line " + std::to_string(lines.line_number()) + " is no " + what);
    };
    std::string_view rest = *line;
    const std::string_view key = next_word(rest);
    if (key.empty() || key == "comment" || key == "obj_info") continue;
    if (key == "format") {
      if (!set_format(header, rest))
        return bad("PLY format that is known (ascii or binary, version 1.0)");
      has_format = true;
    } else if (key == "element") {
      PlyElement element;
      element.name = next_word(rest);
      const auto count = parse_count(next_word(rest));
      if (element.name.empty() || !count) return bad("element with a count");
      element.count = *count;
      header.elements.push_back(std::move(element));
    } else if (key == "property") {
      auto property = property_of(rest);
      if (!property || header.elements.empty()) return bad("property that is known");
      header.elements.back().properties.push_back(std::move(*property));
    } else if (key == "end_header") {
      if (!has_format) return refused("its header has no format line");
      header.body = lines.rest();
      header.lines = lines.line_number();
      return header;
    } else {
      return bad("line of a PLY header");
    }
  }
  return refused("is cut short: its header has no end");
}

}  // namespace spool
