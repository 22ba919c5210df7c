// The scan map: what all frames together say of the surfaces that stand still.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "vision/core/point_cloud.h"
#include "vision/core/pose.h"
#include "vision/core/result.h"
#include "vision/scan/map_blocks.h"
#include "vision/scan/seen_frame.h"

namespace spool {

struct ScanMapOptions {
  double cell_m = 0.008;             // m; the finest cells, some two pixels of 640 at 1.5 m
  std::size_t most_cells = 400'000;  // about 50 MB; beyond it what was out of view longest goes
  // A mean moves on for ever with the newest of so many readings: it can always be mended.
  float most_count = 60;
  // Random noise of a camera that stands still is spent after so many frames (ARCHITECTURE, The
  // sensor); more of them would only make its biases look certain.
  float parked_count = 30;
  float settled_count = 5;  // readings that make a cell one to rely on
  double unsettled_s = 1;   // s; a cell that did not get there by then was something passing
};

[[nodiscard]] std::optional<Error> validate(const ScanMapOptions& options);

// What one frame did to the map.
struct FuseReport {
  std::size_t agreed = 0;     // cells that the frame saw where they are
  std::size_t through = 0;    // cells that it looked through
  std::size_t restarted = 0;  // cells whose surface has moved a little
  std::size_t added = 0, removed = 0;
  bool parked = false;  // the camera stands where it stood
};

// Surfels (Keller et al., 3DV 2013) in voxel blocks (Niessner et al. 2013). A frame corrects each
// cell by the reading that the cell is seen at, so that noise that reaches over a voxel's edge does
// not split a surface in two. Cells that frames look through fade, whatever their age. A mean never
// gets surer than `most_count` readings, and a parked camera adds nothing after `parked_count`.
// Deterministic on any number of threads; use from one thread at a time.
class ScanMap {
 public:
  explicit ScanMap(const ScanMapOptions& options = {});

  // Takes in a frame; the cells that it starts move with `keyframe` from then on (move()).
  // `frame` must be usable; its seconds must not go back.
  FuseReport fuse(const SeenFrame& frame, const Pose& T_map_camera, KeyframeId keyframe = 0);
  // Where a loop was closed: each keyframe's cells move by `motions[keyframe]`, in the map frame.
  void move(std::span<const Pose> motions);
  // Cells of keyframe `from` hang on `to` now, and stay where they are.
  void rehang(KeyframeId from, KeyframeId to) { blocks_.rehang(from, to); }

  [[nodiscard]] bool empty() const { return blocks_.cell_count() == 0; }
  [[nodiscard]] std::size_t size() const { return blocks_.cell_count(); }
  [[nodiscard]] const std::vector<MapBlock>& blocks() const { return blocks_.blocks(); }
  // Of few frames nothing has settled yet, and what all of them saw has to do.
  [[nodiscard]] bool is_settled(const MapCell& cell) const {
    return cell.count >= std::min(options_.settled_count, static_cast<float>(frames_));
  }
  [[nodiscard]] std::size_t frames() const { return frames_; }
  [[nodiscard]] const ScanMapOptions& options() const { return options_; }

  // The settled cells: means (m, map frame) and normals, in no order that means anything.
  [[nodiscard]] PointCloud cloud() const;
  void clear();

 private:
  struct Look;  // what one frame is read by
  void correct_cells(Look& look, FuseReport& report);
  void drop_faded(const Look& look, FuseReport& report);
  void start_cells(const Look& look, KeyframeId keyframe, FuseReport& report);

  ScanMapOptions options_;
  MapBlocks blocks_;
  std::size_t frames_ = 0;
  std::optional<Pose> T_map_anchor_;  // where the camera is parked
};

}  // namespace spool
