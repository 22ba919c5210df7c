// What a frame says of one cell of the map: here, hidden, or gone.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "vision/scan/map_blocks.h"
#include "vision/scan/reading_noise.h"
#include "vision/scan/seen_frame.h"

namespace spool {

enum class CellSight {
  kUnknown,  // out of view, turned away, or nothing was measured there
  kAgrees,   // the reading lies on it
  kHidden,   // something nearer was measured
  kThrough   // the camera saw what lies behind it
};

struct CellReading {
  CellSight sight = CellSight::kUnknown;
  int u = 0, v = 0;                                  // px, where the cell is seen
  float z = 0;                                       // m, depth of the cell
  Eigen::Vector3f point = Eigen::Vector3f::Zero();   // m, map frame, of the reading
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();  // map frame, of the reading; zero: none
  float residual = 0;                                // m, along the cell's normal
  float variance = 0;                                // m^2, of the reading along it
};

// Looks cells up in a frame. Const from many threads; the frame and the noise must outlive it.
class MapReader {
 public:
  MapReader(const SeenFrame& frame, const ReadingNoise& noise, const Pose& T_map_camera);

  [[nodiscard]] CellReading read(const MapCell& cell) const;
  // False where no point of the box can be in view.
  [[nodiscard]] bool may_see(const Eigen::AlignedBox3f& box) const;

 private:
  [[nodiscard]] bool is_looked_through(const CellReading& reading, const Eigen::Vector3f& mean,
                                       const Eigen::Vector3f& normal, float gate) const;

  const SeenFrame& frame_;
  const ReadingNoise& noise_;
  Eigen::Matrix3f R_map_camera_, R_camera_map_;
  Eigen::Vector3f t_map_camera_;
  float fx_, fy_, cx_, cy_;
};

}  // namespace spool
