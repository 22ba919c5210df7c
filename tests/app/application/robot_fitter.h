// Taps as a fitter would: finds the same points in the drawing and in the camera picture.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/ui/touch_event.h"
#include "vision/core/camera.h"
#include "vision/core/depth_frame.h"
#include "vision/inspector.h"

namespace spool::test {

// A point of the window, px.
struct Spot {
  double x = 0, y = 0;
};
struct SpotPair {
  Spot design, scan;
};

// Three points of the design that are in sight in both pictures of the Align screen and far apart;
// the line of --print-targets says where the pictures are. Fewer where there are none.
[[nodiscard]] std::vector<SpotPair> choose_three(const nlohmann::json& screen,
                                                 const PreparedDesign& design, const Camera& camera,
                                                 const DepthFrame& frame,
                                                 const Pose& T_design_camera);

// Where a point of a picture's world stands on the screen: of "scan_view" (camera frame) or
// "design_view". Nothing where it is out of the picture.
[[nodiscard]] std::optional<Spot> spot_in(const nlohmann::json& view,
                                          const Eigen::Vector3d& p_world);

// The middle of the target of that name; nothing where it is not on the screen.
[[nodiscard]] std::optional<Spot> target(const nlohmann::json& screen, const std::string& name);

// Press and release at one moment, which is the hardest case.
[[nodiscard]] std::vector<ui::TouchEvent> tap(const Spot& spot);

}  // namespace spool::test
