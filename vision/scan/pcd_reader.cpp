// Points of a PCD file: ascii, binary and binary_compressed.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <variant>

#include "vision/scan/cloud_reader.h"
#include "vision/scan/lzf.h"
#include "vision/scan/pcd_header.h"
#include "vision/scan/text_scanner.h"

namespace spool {
namespace {

// The fields of the point and, where all three are there, of the normal.
struct Wanted {
  std::array<const PcdField*, 3> point{};
  std::array<const PcdField*, 3> normal{};
  bool has_normals = false;
};

Wanted wanted_of(const PcdHeader& header) {
  Wanted wanted;
  wanted.point = {header.find("x"), header.find("y"), header.find("z")};
  wanted.normal = {header.find("normal_x"), header.find("normal_y"), header.find("normal_z")};
  wanted.has_normals = true;
  for (const PcdField* field : wanted.normal)
    wanted.has_normals = wanted.has_normals && field != nullptr && field->count == 1;
  return wanted;
}

RawCloud reserved(const PcdHeader& header, const Wanted& wanted) {
  RawCloud cloud;
  cloud.points.reserve(header.points);
  if (wanted.has_normals) cloud.normals.reserve(header.points);
  return cloud;
}

// Appends points whose numbers `number(field, i)` gives.
template <class Number>
RawCloud gather(const PcdHeader& header, const Number& number) {
  const Wanted wanted = wanted_of(header);
  RawCloud cloud = reserved(header, wanted);
  for (std::uint64_t i = 0; i < header.points; ++i) {
    cloud.points.emplace_back(number(*wanted.point[0], i), number(*wanted.point[1], i),
                              number(*wanted.point[2], i));
    if (wanted.has_normals)
      cloud.normals.emplace_back(Eigen::Vector3d(number(*wanted.normal[0], i),
                                                 number(*wanted.normal[1], i),
                                                 number(*wanted.normal[2], i))
                                     .cast<float>());
  }
  return cloud;
}

std::string cut_short(const PcdHeader& header) {
  return "is cut short: fewer than the promised " + std::to_string(header.points) +
         " points follow";
}

using Outcome = std::variant<RawCloud, std::string>;  // the points, or what is wrong

// Points one after the other.
Outcome read_binary(const PcdHeader& header) {
  if (header.points > header.body.size() / header.point_bytes) return cut_short(header);
  return gather(header, [&](const PcdField& field, std::uint64_t i) {
    return load_scalar(header.body.data() + i * header.point_bytes + field.offset, field.type,
                       ByteOrder::kLittle);
  });
}

// Two lengths, then all of the first field's numbers, all of the second's and so on, packed
// together.
Outcome read_compressed(const PcdHeader& header) {
  constexpr std::size_t kLengths = 8;
  if (header.body.size() < kLengths) return cut_short(header);
  const auto packed = load_as<std::uint32_t>(header.body.data(), ByteOrder::kLittle);
  const auto unpacked = load_as<std::uint32_t>(header.body.data() + 4, ByteOrder::kLittle);
  if (packed > header.body.size() - kLengths) return cut_short(header);
  if (header.points != unpacked / header.point_bytes || unpacked % header.point_bytes != 0)
    return "says two sizes: " + std::to_string(unpacked) + " bytes are not " +
           std::to_string(header.points) + " points of " + std::to_string(header.point_bytes);
  // A small file must not fill the memory: points hardly ever pack to a tenth, and 64 MiB hold the
  // largest frame of a camera even where nearly all of it packs away.
  constexpr std::size_t kAlways = std::size_t{64} << 20U, kTightest = 16;
  if (unpacked > kAlways && unpacked / kTightest > packed)
    return std::string("is packed more tightly than points can be");
  const auto bytes = unpack_lzf(header.body.substr(kLengths, packed), unpacked);
  if (!bytes) return std::string("is damaged: its packed points cannot be unpacked");
  return gather(header, [&](const PcdField& field, std::uint64_t i) {
    return load_scalar(bytes->data() + field.offset * header.points + i * bytes_of(field.type),
                       field.type, ByteOrder::kLittle);
  });
}

// One point a line.
Outcome read_ascii(const PcdHeader& header) {
  if (header.points > header.body.size() / (2 * header.point_words) + 1) return cut_short(header);
  const Wanted wanted = wanted_of(header);
  RawCloud cloud = reserved(header, wanted);
  LineScanner lines(header.body);
  std::vector<std::string_view> words;
  while (cloud.points.size() < header.points) {
    const auto line = lines.next();
    if (!line) return cut_short(header);
    words.clear();
    std::string_view rest = *line;
    for (std::string_view word = next_word(rest); !word.empty(); word = next_word(rest))
      words.push_back(word);
    if (words.empty()) continue;
    const std::string where = "line " + std::to_string(header.lines + lines.line_number());
    if (words.size() != header.point_words)
      return where + " has " + std::to_string(words.size()) +
             " numbers where the header promises " + std::to_string(header.point_words);
    bool good = true;
    const auto number = [&](const PcdField* field) {
      const auto value = parse_number(words[field->word]);
      good = good && value.has_value();
      return value.value_or(0);
    };
    const auto vector = [&](const std::array<const PcdField*, 3>& fields) {
      return Eigen::Vector3d(number(fields[0]), number(fields[1]), number(fields[2]));
    };
    cloud.points.push_back(vector(wanted.point));
    if (wanted.has_normals) cloud.normals.emplace_back(vector(wanted.normal).cast<float>());
    if (!good) return where + " has text where a number belongs";
  }
  return cloud;
}

Outcome read_body(const PcdHeader& header) {
  switch (header.data) {
    case PcdHeader::Data::kAscii:
      return read_ascii(header);
    case PcdHeader::Data::kBinary:
      return read_binary(header);
    case PcdHeader::Data::kCompressed:
      return read_compressed(header);
  }
  return std::string("holds a kind of DATA that is not known");
}

}  // namespace

Result<RawCloud> read_pcd(std::string_view bytes, const std::string& name) {
  const auto header = read_pcd_header(bytes, name);
  if (!header) return header.error();
  Outcome outcome = read_body(*header);
  if (const std::string* wrong = std::get_if<std::string>(&outcome))
    return Error{ErrorCode::kBadInput, name + ": " + *wrong + "; copy or export it again"};
  RawCloud cloud = std::get<RawCloud>(std::move(outcome));
  if (header->height > 1 && header->width > 1) {
    cloud.width = static_cast<int>(header->width);
    cloud.height = static_cast<int>(header->height);
  }
  return cloud;
}

}  // namespace spool
