// Algorithm 3 of thesis chapter 5: the plane of the best K over the sizes of scene and model.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/inspect/k_plane.h"

#include <cmath>

namespace spool {
namespace {

// Takes the mean off and divides by the n - 1 standard deviation, which are returned.
void standardise(Eigen::Ref<Eigen::VectorXd> values, double& mean, double& deviation) {
  const auto n = static_cast<double>(values.size());
  mean = values.mean();
  deviation = std::sqrt((values.array() - mean).square().sum() / (n - 1));
  values = (values.array() - mean) / deviation;
}

}  // namespace

double KPlane::predict(std::size_t scene_points, std::size_t model_points) const {
  return fit.predict(
      Eigen::Vector2d((static_cast<double>(scene_points) - scene_mean) / scene_deviation,
                      (static_cast<double>(model_points) - model_mean) / model_deviation));
}

KPlane fit_k_plane(std::span<const KObservation> observations) {
  const auto n = static_cast<Eigen::Index>(observations.size());
  Eigen::MatrixXd sizes(n, 2);
  Eigen::VectorXd k(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const KObservation& observation = observations[static_cast<std::size_t>(i)];
    sizes.row(i) << static_cast<double>(observation.scene_points),
        static_cast<double>(observation.model_points);
    k[i] = observation.k;
  }
  KPlane plane;
  if (n > 1) {
    standardise(sizes.col(0), plane.scene_mean, plane.scene_deviation);
    standardise(sizes.col(1), plane.model_mean, plane.model_deviation);
  }
  plane.fit = regress(sizes, k);
  return plane;
}

}  // namespace spool
