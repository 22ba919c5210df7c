// Where the holes of a flange's bolt circle let the camera see through.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "vision/core/camera.h"
#include "vision/core/depth_frame.h"
#include "vision/core/pose.h"
#include "vision/design/design_model.h"
#include "vision/inspect/hole_harmonic.h"
#include "vision/scan/noise_model.h"

namespace spool {

// What one frame shows of the ring, by the angle about the flange's axis: x of the part's frame at
// 0, right-handed about z.
struct BoltLook {
  std::vector<RingBin> bins;  // readings on the face or behind it, and those behind it
  double pixel_m = 0;         // across, on the face
};

// The ring of a flange's face in which the holes lie.
class BoltRing {
 public:
  // Nothing for a part that has no holes, or whose mesh has no flat face round them.
  [[nodiscard]] static std::optional<BoltRing> of(const DesignModel& design, int part);

  [[nodiscard]] const BoltHoles& holes() const { return holes_; }
  // The ring reaches so far to either side of the bolt circle: about a hole's radius.
  [[nodiscard]] double half_width_m() const { return half_width_m_; }
  // m, along z of the part's frame: the flat round the holes that looks along z (side 1) or against
  // it (-1).
  [[nodiscard]] std::optional<double> face_height_m(double side) const;

  // The flange is within millimetres of where the pose has it, along its axis and aside. Nothing
  // where its face is turned away, outside the picture or hidden.
  [[nodiscard]] std::optional<BoltLook> read(const DepthFrame& frame, const Camera& camera,
                                             const NoiseModel& noise,
                                             const Pose& T_design_camera) const;

 private:
  struct Face {
    double z_m = 0;   // in the part's frame
    double side = 0;  // where it looks, along z: -1 or 1; 0: there is none
  };

  BoltHoles holes_;
  double half_width_m_ = 0;  // of the ring
  Pose T_design_part_ = Pose::Identity();
  std::array<Face, 2> faces_;
};

}  // namespace spool
