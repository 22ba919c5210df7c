// Clouds from and to files: PLY, PCD, XYZ text, OBJ points.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "vision/core/length_unit.h"
#include "vision/core/point_cloud.h"
#include "vision/core/result.h"

namespace spool {

struct CloudFile {
  PointCloud cloud;        // metres; every point of the file in its order, not finite ones as NaN
  std::size_t finite = 0;  // points with three finite coordinates
  LengthUnit unit = LengthUnit::kMetre;
  bool unit_inferred = false;  // nobody said the unit and it was guessed from the size
  std::string sha256;
  std::vector<std::string> warnings;  // one sentence each
};

// Reads .ply (ascii, both binaries), .pcd (ascii, binary, binary_compressed; padding fields),
// .xyz/.txt (x y z [nx ny nz] …), .obj (v lines). `unit` unset: inferred from the size with a
// warning. kBadInput with one sentence for anything missing, empty, cut short, hostile or without a
// finite point.
[[nodiscard]] Result<CloudFile> read_cloud(const std::filesystem::path& path,
                                           std::optional<LengthUnit> unit);

// The same of bytes at hand; `path` gives the ending and the name in messages, and is not opened.
[[nodiscard]] Result<CloudFile> read_cloud_bytes(std::string_view bytes,
                                                 const std::filesystem::path& path,
                                                 std::optional<LengthUnit> unit);

// True where read_cloud() knows the file's ending.
[[nodiscard]] bool is_cloud_file(const std::filesystem::path& path);

// A column of a PLY file that is written.
struct PlyColumn {
  std::string name;
  enum class Type { kFloat, kInt, kUchar } type = Type::kFloat;
  std::vector<float> floats;  // the one of the three that `type` names, as long as the cloud
  std::vector<std::int32_t> ints;
  std::vector<std::uint8_t> uchars;
};

// Binary little-endian PLY of x y z and the columns, written whole or not at all. NaN stays NaN.
// The cloud's origin is added in double before rounding to float.
[[nodiscard]] Status write_ply(const std::filesystem::path& path, const PointCloud& cloud,
                               const std::vector<PlyColumn>& columns = {});

}  // namespace spool
