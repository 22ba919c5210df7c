// Round pipes made twice: as a meshed design, and as scan points straight from the formulas.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <random>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "vision/core/point_cloud.h"
#include "vision/design/design_model.h"

namespace spool::test {

// A solid cylinder, closed at both ends, along `direction` from `base`.
struct Rod {
  Eigen::Vector3d base = Eigen::Vector3d::Zero();        // m
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();  // unit
  double radius = 0.05;                                  // m
  double length = 1.0;                                   // m
};

// Distance (m) to one rod, negative inside: the formula, no mesh.
[[nodiscard]] double distance_to(const Rod& rod, const Eigen::Vector3d& p);

// A meshed design with one part a rod.
[[nodiscard]] DesignModel design_of(const std::vector<Rod>& rods, int segments = 96);

// Points with outward normals, evenly over what shows of the union, moved by T_scan_design, with
// noise (m) along the normal. Seen only where the normal is within `view_angle` of `towards`
// (design frame; zero: from everywhere).
struct ScanOptions {
  std::size_t points = 8000;
  double noise_m = 0.0;
  Eigen::Vector3d towards = Eigen::Vector3d::Zero();
  double min_facing = 0.2;  // cosine
  bool with_ends = true;
};
[[nodiscard]] PointCloud scan_of(const std::vector<Rod>& rods,
                                 const Eigen::Isometry3d& T_scan_design, const ScanOptions& options,
                                 std::mt19937& random);

// A flanged tee: 0.8 m of pipe along z, a branch along x, discs at three ends. No symmetry is left
// but the mirror across y.
[[nodiscard]] std::vector<Rod> tee_spool();

// A rigid motion of the given size in a random direction.
[[nodiscard]] Eigen::Isometry3d random_motion(double translation_m, double rotation_rad,
                                              std::mt19937& random);

// The largest displacement (m) between two poses (design from scan) over the corners of the
// design's box.
[[nodiscard]] double displacement_at(const Eigen::AlignedBox3d& box, const Eigen::Isometry3d& a,
                                     const Eigen::Isometry3d& b);

}  // namespace spool::test
