// JSON from files of strangers: size and depth bounded, every error a sentence with the file's name.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <vector>

#include "vision/align/three_point.h"
#include "vision/core/camera.h"
#include "vision/core/pose.h"
#include "vision/core/result.h"

namespace spool {

[[nodiscard]] Result<nlohmann::json> read_json(const std::filesystem::path& path);
[[nodiscard]] Result<nlohmann::json> parse_json(std::string_view text, const std::string& name);

// pairs.json, pose.json, camera.json and calibration files of DESIGN 4.1 and 4.3.
[[nodiscard]] Result<std::vector<PointPair>> read_pairs(const std::filesystem::path& path);
[[nodiscard]] Result<Pose> read_pose(const std::filesystem::path& path);
[[nodiscard]] Result<Camera> read_camera(const std::filesystem::path& path);
[[nodiscard]] nlohmann::json camera_to_json(const Camera& camera);

}  // namespace spool
