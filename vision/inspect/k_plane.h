// Algorithm 3 of thesis chapter 5: the plane of the best K over the sizes of scene and model.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include "vision/fit/regression.h"

namespace spool {

// The K found best for one scene.
struct KObservation {
  std::size_t scene_points = 0;  // S
  std::size_t model_points = 0;  // M
  double k = 0;
};

// Eq. 5.5: K = a1 S' + a2 M' + a0, where the sizes are standardised (mean off, divided by the n - 1
// standard deviation). Which slope belongs to which size: THESIS.md, A10.
struct KPlane {
  double scene_mean = 0, scene_deviation = 0;  // points
  double model_mean = 0, model_deviation = 0;
  Regression fit;  // coefficients: a0, the scene's slope, the model's

  [[nodiscard]] double predict(std::size_t scene_points, std::size_t model_points) const;
};

// Algorithm 3: standardises, regresses, and says how good the plane is. Not determined
// (fit.is_determined) with fewer than four observations, or where all scenes or all models are of
// one size.
[[nodiscard]] KPlane fit_k_plane(std::span<const KObservation> observations);

}  // namespace spool
