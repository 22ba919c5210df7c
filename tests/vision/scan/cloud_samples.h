// One small cloud in every format that is read, built byte by byte.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace spool::test {

// Four points, the third without a measurement, and their normals (none for the third).
[[nodiscard]] std::vector<Eigen::Vector3f> sample_points();
[[nodiscard]] std::vector<Eigen::Vector3f> sample_normals();

struct CloudSample {
  std::string name;    // for messages
  std::string ending;  // ".ply"
  std::string bytes;
  bool has_normals = false;
  int width = 0;  // of an organised one
  int height = 0;
};

[[nodiscard]] std::vector<CloudSample> cloud_samples();

// Packs bytes as LZF by the simplest means: literal runs, and a repeat where the last byte goes on.
// The control bytes are those of the format's definition.
[[nodiscard]] std::string pack_lzf(const std::string& bytes);

// A binary_compressed PCD of x y z floats with the given numbers in its header.
[[nodiscard]] std::string compressed_pcd(const std::string& packed, std::uint32_t packed_size,
                                         std::uint32_t unpacked_size, const std::string& points);

// Writes `bytes` into the folder and gives the path.
std::filesystem::path write_sample(const std::filesystem::path& folder, const std::string& ending,
                                   const std::string& bytes);

}  // namespace spool::test
