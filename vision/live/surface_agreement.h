// Is the design where the frame says it is: expected surface against measured depth.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "vision/core/camera.h"
#include "vision/core/depth_frame.h"
#include "vision/core/pose.h"
#include "vision/design/design_surface.h"
#include "vision/design/sampling.h"

namespace spool {

// Counts of design samples that the camera should see: facing it, in the picture, not behind the
// design itself.
struct SurfaceAgreement {
  std::size_t seen = 0;          // measured within the gate of where the design has it
  std::size_t seen_through = 0;  // measured behind it: nothing is there
  std::size_t hidden = 0;        // measured in front of it: a hand, a clamp
  std::size_t unmeasured = 0;    // no depth there

  // Of what could be told, the share that agrees; 0 where nothing could.
  [[nodiscard]] double share() const {
    const std::size_t told = seen + seen_through;
    return told == 0 ? 0.0 : static_cast<double>(seen) / static_cast<double>(told);
  }
  // Of what was measured in its directions, the share that is not hidden by something in front.
  [[nodiscard]] double share_told() const {
    const std::size_t told = seen + seen_through;
    return told == 0 ? 0.0 : static_cast<double>(told) / static_cast<double>(told + hidden);
  }
  // Of what was measured in its directions, the share that is the design.
  [[nodiscard]] double share_in_sight() const {
    const std::size_t all = seen + seen_through + hidden;
    return all == 0 ? 0.0 : static_cast<double>(seen) / static_cast<double>(all);
  }
};

// Some 1500 samples at most. Each with an outward normal towards the camera is projected into the
// frame and compared with the depth at its pixel. `gate_m`: m along the optical axis. `counts`: one
// a part, zero for those that are not asked about; empty: all are.
[[nodiscard]] SurfaceAgreement surface_agreement(const SurfaceSamples& samples,
                                                 const DesignSurface& surface,
                                                 const DepthFrame& frame, const Camera& camera,
                                                 const Pose& T_design_camera, double gate_m,
                                                 std::span<const std::uint8_t> counts = {});

}  // namespace spool
