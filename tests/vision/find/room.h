// A room to find a spool in: floor, wall, table, boxes, and pipes of the spool's own sizes.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <random>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "tests/vision/align/synthetic_spool.h"
#include "vision/core/pose.h"
#include "vision/find/finder_model.h"

namespace spool::test {

struct Room {
  std::vector<Eigen::Vector3f> points;  // m, shuffled
  std::vector<Pose> T_scan_design;      // of each copy of the object
};

struct RoomOptions {
  int copies = 1;               // of the object, 1.3 m apart; 0: the room without it
  double noise_m = 0.002;       // m, along the normal
  double points_per_m2 = 9000;  // 10 mm apart
  bool with_pipes = true;       // straight ones of the object's sizes lie about
};

// Everything is seen from one side only, from above and in front. The object lies on the table,
// turned at random.
[[nodiscard]] Room make_room(const std::vector<Rod>& object, const RoomOptions& options,
                             std::mt19937& random);

// A rectangle of points, corner + a u + b v, with noise (m) across it.
void add_rectangle(std::vector<Eigen::Vector3f>& points, const Eigen::Vector3d& corner,
                   const Eigen::Vector3d& u, const Eigen::Vector3d& v, double points_per_m2,
                   double noise_m, std::mt19937& random);

// The design made ready to be found.
[[nodiscard]] FinderModel finder_of(const DesignModel& design, std::size_t samples = 6000);

// The largest distance (m) between where two poses (design from scan) put the design.
[[nodiscard]] double pose_distance(const FinderModel& model, const Pose& T_a, const Pose& T_b);

}  // namespace spool::test
