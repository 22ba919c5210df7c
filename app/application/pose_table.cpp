// poses.csv.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/application/pose_table.h"

#include <iterator>

#include <fmt/format.h>

#include "vision/core/file_io.h"

namespace spool {

void PoseTable::add(const std::vector<TrackRow>& rows) {
  for (const TrackRow& row : rows) rows_[row.frame] = row;
}

void PoseTable::keep_newest(std::size_t count) {
  while (rows_.size() > count) rows_.erase(rows_.begin());
}

PoseTable PoseTable::renumbered(std::span<const std::int64_t> frames) const {
  PoseTable out(origin_);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const auto row = rows_.find(frames[i]);
    if (row == rows_.end()) continue;  // it went by while vision was busy
    TrackRow renumbered = row->second;
    renumbered.frame = static_cast<std::int64_t>(i);
    out.rows_[renumbered.frame] = renumbered;
  }
  return out;
}

std::string PoseTable::text() const {
  std::string out = "frame,seconds,quality";
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) out += fmt::format(",t{}{}", row, column);
  }
  out += '\n';
  for (const auto& [frame, row] : rows_) {
    Pose T = row.T_design_camera;
    T.translation() += origin_;
    fmt::format_to(std::back_inserter(out), "{},{:.6f},{}", frame, row.seconds, name(row.quality));
    for (const double number : row_major(T))
      fmt::format_to(std::back_inserter(out), ",{:.9g}", number);
    out += '\n';
  }
  return out;
}

Status PoseTable::write(const std::filesystem::path& path) const {
  return write_file_whole(path, text());
}

}  // namespace spool
