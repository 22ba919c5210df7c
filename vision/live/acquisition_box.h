// The acquisition box: the upright box that is looked into; what lies outside costs nothing
// further.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include <Eigen/Geometry>

#include "vision/core/camera.h"
#include "vision/core/point_cloud.h"
#include "vision/core/pose.h"
#include "vision/design/design_model.h"
#include "vision/live/vision_state.h"

namespace spool {

// Thesis 3.3.1: the sensor scans within a boundary box. Lengths in m.
struct AcquisitionBox {
  Pose T_box_scene = Pose::Identity();  // from the frame of the points that are asked about
  Eigen::AlignedBox3f bounds;

  [[nodiscard]] bool contains(const Eigen::Vector3f& p_scene) const {
    return bounds.contains(T_box_scene.cast<float>() * p_scene);
  }
};

// Of an aligned design, in the design's frame: its bounds and `margin_m` about them.
[[nodiscard]] Eigen::AlignedBox3f box_about(const DesignModel& design, double margin_m);

// Before an alignment: the box of which `corner` and `opposite` (camera frame) are two opposite
// corners as the camera sees them. It stands upright on the plane that most of the picture shows,
// turned as the camera looks along it; where no plane does, it is square to the camera. Along the
// plane the margin is half the least extent of the design: who taps the middle of a pipe means all
// of it. Upright it is the largest extent, for two taps do not say how high a thing is.
[[nodiscard]] AcquisitionBox box_between(const Eigen::Vector3f& corner,
                                         const Eigen::Vector3f& opposite, const PointCloud& scan,
                                         const DesignModel& design);

// The state as if the camera had seen nothing outside: its frame's other pixels have no depth, its
// scan no other points. `box` is in the state's camera frame. `revision`: of the new state.
[[nodiscard]] VisionStatePtr only_inside(const VisionState& state, const AcquisitionBox& box,
                                         const Camera& camera, std::uint64_t revision);

}  // namespace spool
