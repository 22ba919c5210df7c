// Triangles from loops of points: strips between loops of equal length, seams between any two.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "vision/core/pose.h"
#include "vision/core/triangle_mesh.h"

namespace spool::campaign {

using Loop = std::vector<Eigen::Vector3d>;  // closed; the last point is not the first

class MeshBuilder {
 public:
  // Everything that follows is given in this frame and turned over where `inward`.
  void in_frame(const Pose& T_mesh_frame, bool inward);

  void triangle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c);
  void quad(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
            const Eigen::Vector3d& d);
  // Between loops of equal length; outward on the right of `lower` seen along it with `upper`
  // above: for loops counter-clockwise about z and `upper` above, away from the axis.
  void strip(const Loop& lower, const Loop& upper);
  // Between two loops in a plane round `centre`, both counter-clockwise about `up`, seen from `up`.
  void ring(const Loop& inner, const Loop& outer, const Eigen::Vector3d& centre,
            const Eigen::Vector3d& up);

  // Points nearer than a tenth of a micrometre are one; triangles without area are dropped.
  [[nodiscard]] TriangleMesh welded() const;

 private:
  Pose T_mesh_frame_ = Pose::Identity();
  bool inward_ = false;
  std::vector<Eigen::Vector3d> corners_;  // three a triangle
};

}  // namespace spool::campaign
