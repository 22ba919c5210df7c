// Tests of Algorithm 3's plane of K.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/inspect/k_plane.h"

#include <vector>

#include <gtest/gtest.h>

namespace spool {
namespace {

TEST(KPlane, StandardisesAndFindsThePlaneThatKsLieOn) {
  std::vector<KObservation> observations;
  for (const std::size_t scene : {20000U, 50000U, 80000U})
    for (const std::size_t model : {5000U, 11000U})
      observations.push_back(
          {scene, model,
           3 + 1e-4 * static_cast<double>(scene) - 2e-4 * static_cast<double>(model)});
  const KPlane plane = fit_k_plane(observations);
  ASSERT_TRUE(plane.fit.is_determined);
  EXPECT_DOUBLE_EQ(plane.scene_mean, 50000);
  EXPECT_DOUBLE_EQ(plane.model_mean, 8000);
  // Twice -30000, 0, 30000 over five degrees of freedom; three times each of -3000, 3000.
  EXPECT_NEAR(plane.scene_deviation, 26832.8157, 1e-3);
  EXPECT_NEAR(plane.model_deviation, 3286.3353, 1e-3);
  EXPECT_NEAR(plane.fit.coefficients[0], 3 + 5 - 1.6, 1e-9);
  EXPECT_NEAR(plane.fit.coefficients[1], 1e-4 * plane.scene_deviation, 1e-9);
  EXPECT_NEAR(plane.fit.coefficients[2], -2e-4 * plane.model_deviation, 1e-9);
  EXPECT_NEAR(plane.predict(100000, 10000), 3 + 10 - 2, 1e-9);
}

TEST(KPlane, IsNotDeterminedByTooFewScenesOrScenesOfOneSize) {
  EXPECT_FALSE(fit_k_plane({}).fit.is_determined);
  const std::vector<KObservation> three = {{1000, 100, 3}, {2000, 200, 4}, {3000, 100, 5}};
  EXPECT_FALSE(fit_k_plane(three).fit.is_determined);
  const std::vector<KObservation> one_size = {
      {1000, 100, 3}, {1000, 200, 4}, {1000, 300, 5}, {1000, 150, 2}};
  EXPECT_FALSE(fit_k_plane(one_size).fit.is_determined);
}

}  // namespace
}  // namespace spool
