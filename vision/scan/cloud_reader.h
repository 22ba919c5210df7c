// The seam between read_cloud() and the formats: one function a format, listed in cloud_file.cpp.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "vision/core/result.h"

namespace spool {

// What a file holds, in its own unit and order. Coordinates may be anything a double can be.
struct RawCloud {
  std::vector<Eigen::Vector3d> points = {};
  std::vector<Eigen::Vector3f> normals = {};  // as the file has them, or empty
  int width = 0;                              // of an organised cloud, else 0
  int height = 0;
  std::vector<std::string> warnings = {};  // one sentence each
};

// Reads the file's bytes; `name` is for messages. kBadInput with one sentence for anything damaged,
// cut short or hostile. What it allocates is bounded by the number of bytes, never by what a header
// promises.
using CloudReader = Result<RawCloud> (*)(std::string_view bytes, const std::string& name);

[[nodiscard]] Result<RawCloud> read_ply(std::string_view bytes, const std::string& name);
[[nodiscard]] Result<RawCloud> read_pcd(std::string_view bytes, const std::string& name);
[[nodiscard]] Result<RawCloud> read_xyz(std::string_view bytes, const std::string& name);
[[nodiscard]] Result<RawCloud> read_obj_points(std::string_view bytes, const std::string& name);

}  // namespace spool
