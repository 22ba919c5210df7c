// States of the bracket whose deviations are measured at a pose that is simply said.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/vision/live/placed_states.h"

#include <cmath>

#include "vision/scan/back_projection.h"
#include "vision/scan/normals.h"

namespace spool::test {

VisionState placed_state(const Pose& T_true, const Pose& T_said, int index,
                         const ChangeFrame& change) {
  VisionState state;
  auto frame =
      std::make_shared<DepthFrame>(*render_frame(*prepared_bracket(), T_true, index, 0.001));
  if (change) change(*frame);
  state.frame = frame;
  auto cloud = back_project(*frame, small_camera());
  if (!cloud) return state;
  estimate_organised_normals(*cloud, small_camera(), millimetre_noise());
  state.scan = measured_points(*cloud);
  state.T_design_camera = T_said;
  state.quality = TrackQuality::kGood;
  state.scan_design = moved(state.scan, T_said);
  state.classes.assign(state.scan.size(), PointClass::kObject);
  state.deviations =
      measure_deviations(state.scan_design, state.classes, *prepared_bracket()->surface, 0.03F);
  return state;
}

Pose walking(int index) {
  return T_design_camera(0.3 * std::sin(0.06 * index), 0.05 * std::sin(0.15 * index));
}

}  // namespace spool::test
