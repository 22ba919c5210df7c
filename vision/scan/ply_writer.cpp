// Clouds to binary little-endian PLY, written whole or not at all.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <cassert>
#include <cstring>

#include "vision/core/file_io.h"
#include "vision/scan/cloud_file.h"
#include "vision/scan/scalar.h"

namespace spool {
namespace {

std::string_view ply_type(PlyColumn::Type type) {
  switch (type) {
    case PlyColumn::Type::kFloat:
      return "float";
    case PlyColumn::Type::kInt:
      return "int";
    case PlyColumn::Type::kUchar:
      return "uchar";
  }
  return "float";
}

[[maybe_unused]]  // by NDEBUG builds
std::size_t
length_of(const PlyColumn& column) {
  switch (column.type) {
    case PlyColumn::Type::kFloat:
      return column.floats.size();
    case PlyColumn::Type::kInt:
      return column.ints.size();
    case PlyColumn::Type::kUchar:
      return column.uchars.size();
  }
  return 0;
}

template <class T>
void append(std::string& bytes, T value) {
  static_assert(std::endian::native == std::endian::little, "ours are little-endian machines");
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  bytes.append(raw, sizeof(T));
}

}  // namespace

Status write_ply(const std::filesystem::path& path, const PointCloud& cloud,
                 const std::vector<PlyColumn>& columns) {
  std::string bytes = "ply\nformat binary_little_endian 1.0\ncomment metres\nelement vertex " +
                      std::to_string(cloud.size()) +
                      "\nproperty float x\nproperty float y\nproperty float z\n";
  std::size_t stride = 3 * sizeof(float);
  for (const PlyColumn& column : columns) {
    assert(length_of(column) == cloud.size() && "a number for every point");
    assert(!column.name.empty() && column.name.find_first_of(" \t\r\n") == std::string::npos &&
           "a name of one word");
    bytes.append("property ").append(ply_type(column.type)).append(" ").append(column.name) += '\n';
    stride += column.type == PlyColumn::Type::kUchar ? 1 : 4;
  }
  bytes += "end_header\n";
  bytes.reserve(bytes.size() + stride * cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3f point = (cloud.origin + cloud.points[i].cast<double>()).cast<float>();
    for (const float coordinate : point) append(bytes, coordinate);
    for (const PlyColumn& column : columns) {
      if (column.type == PlyColumn::Type::kFloat) append(bytes, column.floats[i]);
      if (column.type == PlyColumn::Type::kInt) append(bytes, column.ints[i]);
      if (column.type == PlyColumn::Type::kUchar) append(bytes, column.uchars[i]);
    }
  }
  return write_file_whole(path, bytes);
}

}  // namespace spool
