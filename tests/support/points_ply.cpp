// points.ply of an inspection, read by code that shares nothing with its writer.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/support/points_ply.h"

#include <cstring>
#include <fstream>
#include <iterator>
#include <string>

namespace spool::test {

std::optional<std::vector<PointsRow>> read_points_ply(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  const std::string end = "end_header\n";
  const auto header = bytes.find(end);
  if (header == std::string::npos) return std::nullopt;
  const std::string columns =
      "property float x\nproperty float y\nproperty float z\nproperty uchar object\nproperty int "
      "part\n"
      "property float deviation\n";
  if (bytes.compare(0, 4, "ply\n") != 0 ||
      bytes.find("format binary_little_endian 1.0\n") > header || bytes.find(columns) > header)
    return std::nullopt;
  const auto element = bytes.find("element vertex ");
  if (element > header) return std::nullopt;
  const std::size_t count = std::stoul(bytes.substr(element + 15));
  constexpr std::size_t kRowBytes = 12 + 1 + 4 + 4;
  std::size_t at = header + end.size();
  if (bytes.size() != at + count * kRowBytes) return std::nullopt;
  std::vector<PointsRow> rows(count);
  const auto take = [&](void* to, std::size_t size) {
    std::memcpy(to, bytes.data() + at, size);
    at += size;
  };
  for (auto& row : rows) {
    take(row.position.data(), 12);
    take(&row.object, 1);
    take(&row.part, 4);
    take(&row.deviation, 4);
  }
  return rows;
}

}  // namespace spool::test
