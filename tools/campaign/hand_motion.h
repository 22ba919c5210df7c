// How a hand carries a camera about an object: a smooth way at a stated speed, and tremor on it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "tools/campaign/ray_world.h"

namespace spool::campaign {

enum class Way {
  kRound,  // swings about the object's middle, nearer and farther
  kAlong,  // from end to end of the object and back
  kAround  // along one side of the object, round its end and back along the other side
};

struct HandSettings {
  Way way = Way::kRound;
  double speed_m_s = 0.3;                      // at most, tremor not counted
  double turn_rad_s = 0.5236;                  // at most (30 degrees a second), tremor not counted
  double tremor_m = 0.003;                     // RMS of the camera's place, all three axes together
  double tremor_rad = 0.0087;                  // RMS of its rotation (half a degree)
  double nearest_m = 0.65, farthest_m = 1.35;  // from the eye to what it looks at
};

// A closed way round or along `object` that keeps clear of what stands there as far as it can, and
// always takes up the same time again. Scan frame, z up; camera frame x right, y down, z forward.
// Immutable.
class HandMotion {
 public:
  HandMotion(const RayWorld& world, const Eigen::AlignedBox3d& object, const HandSettings& settings,
             std::uint32_t seed);

  // Where the camera is after so many seconds.
  [[nodiscard]] Pose T_scan_camera(double seconds) const;
  // Time (s) for the whole way; of kAlong and kAround, half of it is the far end.
  [[nodiscard]] double period_s() const { return when_.back(); }

 private:
  struct Shape {
    Eigen::Vector3d middle, along;  // m; `along` reaches to the end
    double azimuth, azimuth_swing, elevation, elevation_swing, distance, distance_swing;
    std::array<double, 3> phase;
  };
  [[nodiscard]] Shape drawn(const Eigen::AlignedBox3d& object, double lift,
                            class Random& random) const;
  [[nodiscard]] Pose on_way(const Shape& shape, double share) const;
  [[nodiscard]] int obstructed(const RayWorld& world, const Shape& shape) const;
  void keep_to_speed();

  struct Wave {
    double hertz, phase, amplitude;
  };
  HandSettings settings_;
  Shape shape_ = {};
  std::vector<double> when_;                // s, at even shares of the way
  std::array<std::vector<Wave>, 6> waves_;  // m and rad
};

}  // namespace spool::campaign
