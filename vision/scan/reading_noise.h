// What a reading's noise is worth along the normal of the surface it fell on.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "vision/core/camera.h"
#include "vision/scan/noise_model.h"

namespace spool {

// The sensor's noise by depth and incidence from tables: a frame asks a hundred thousand times.
// Depth in steps of 2 cm to 8 m (beyond: as at 8 m), the cosine of the incidence in 32 steps;
// nothing is read between them, where the model moves by a few percent. Immutable.
class ReadingNoise {
 public:
  ReadingNoise(const NoiseModel& model, const Camera& camera);

  // Variance (m^2) along the surface's normal of a reading at depth `z_m` (m) whose ray meets the
  // normal at an angle of that cosine (0 to 1): axial noise along the ray, lateral noise across it
  // (Nguyen, Izadi & Lovell 2012), never under the rounding of a depth count.
  [[nodiscard]] float variance(float z_m, float cosine) const {
    const auto row = static_cast<int>(z_m / kStep);
    const auto column = static_cast<int>(cosine * kCosines);
    return table_(row < 0         ? 0
                  : row < kDepths ? row
                                  : kDepths - 1,
                  column < 0          ? 0
                  : column < kCosines ? column
                                      : kCosines - 1);
  }
  // Of a reading (m, camera frame) on a surface with that unit normal, which faces the camera.
  [[nodiscard]] float variance(const Eigen::Vector3f& point, const Eigen::Vector3f& normal) const {
    const float facing = -normal.dot(point) / point.norm();
    return variance(point.z(), facing < 0 ? 0.0F : facing > 1 ? 1.0F : facing);
  }

 private:
  static constexpr int kDepths = 400, kCosines = 32;
  static constexpr float kStep = 0.02F;  // m
  Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> table_;
};

// How many readings, of every `step`-th pixel in u and v, share one correlation window of the
// sensor (ARCHITECTURE, The sensor) and so are worth one; 1 at least.
[[nodiscard]] double correlated_readings(const Camera& camera, double step_px);

}  // namespace spool
