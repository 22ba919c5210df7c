// poses.csv: where the camera was in every frame (ARCHITECTURE, Command lines).
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "app/runner/vision_runner.h"
#include "vision/core/result.h"

namespace spool {

// One row a frame; an alignment made on a frame replaces that frame's row.
class PoseTable {
 public:
  // `origin`: the design's own (m); the file holds poses in the design file's coordinates.
  explicit PoseTable(const Eigen::Vector3d& origin) : origin_(origin) {}
  void add(const std::vector<TrackRow>& rows);
  // Forgets all but the newest rows.
  void keep_newest(std::size_t count);
  // The rows of these frames, by their place in the list.
  [[nodiscard]] PoseTable renumbered(std::span<const std::int64_t> frames) const;
  [[nodiscard]] std::string text() const;
  [[nodiscard]] Status write(const std::filesystem::path& path) const;  // whole or not at all

 private:
  Eigen::Vector3d origin_;
  std::map<std::int64_t, TrackRow> rows_;
};

}  // namespace spool
