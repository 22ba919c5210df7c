// Claims about what a tap means.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/application/picking.h"

#include <limits>

#include <gtest/gtest.h>

#include "tests/app/runner/simulated_scene.h"

namespace spool {
namespace {

render::View view_at(const Pose& T_design_camera) {
  render::View view;
  view.camera = test::small_camera();
  view.T_camera_design = T_design_camera.inverse();
  return view;
}

TEST(Picking, SlopIsOneAndAHalfMillimetresOfGlass) { EXPECT_NEAR(tap_slop_px(254), 15, 1e-9); }

TEST(Picking, TakesTheNearestPointOfTheForemostSurface) {
  render::View view;
  view.camera = test::small_camera();
  const auto at = [&](double u, double v, double z) {
    return Eigen::Vector3f(view.camera.back_project(u, v, z).cast<float>());
  };
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const std::vector<Eigen::Vector3f> points{
      at(80, 60, 2.0),   // exactly under the finger, but the floor behind
      at(82, 60, 1.0),   // the steel, 2 px off
      at(85, 60, 1.01),  // the steel too, 5 px off
      at(80, 60, -1.0),  // behind the eye
      {nan, nan, nan},
  };
  EXPECT_EQ(pick_point(points, view, 80, 60, 9), 1U);
  EXPECT_EQ(pick_point(points, view, 80, 60, 1.5), 0U) << "nothing nearer within the slop";
  EXPECT_EQ(pick_point(points, view, 86, 60, 3), 2U) << "what is right under the finger";
  EXPECT_EQ(pick_point(points, view, 20, 20, 9), std::nullopt);
}

TEST(Picking, ATapOnTheDrawingIsThePointOfItsSurface) {
  const auto design = test::prepared_bracket();
  const render::View view = view_at(test::T_design_camera());
  const Eigen::Vector3d top(0.2, 0.1, 0.05);  // on the base's upper face
  const auto spot = render::project(view, top);
  const auto hit = pick_design(design->model, *design->surface, {}, view, spot.x, spot.y, 3);
  ASSERT_TRUE(hit.has_value());
  EXPECT_LT((hit->position - top).norm(), 1e-5);  // float rays
  EXPECT_EQ(hit->part, 0);
  EXPECT_EQ(hit->text, "base, where you tapped");
  EXPECT_FALSE(pick_design(design->model, *design->surface, {}, view, 2, 2, 3).has_value());
}

TEST(Picking, ATapJustBesideTheDrawingMeansTheLandmarkThere) {
  const auto design = test::prepared_bracket();
  const render::View view = view_at(test::T_design_camera());
  const std::vector<Landmark> landmarks{{{0.0, 0.2, 0.2}, 1, "arm, outermost point"}};
  const auto spot = render::project(view, landmarks[0].position);
  int beside = 0;
  for (const auto& [dx, dy] :
       {std::pair(4, 0), std::pair(-4, 0), std::pair(0, 4), std::pair(0, -4)}) {
    const auto pick = [&](std::span<const Landmark> known) {
      return pick_design(design->model, *design->surface, known, view, spot.x + dx, spot.y + dy, 9);
    };
    const auto plain = pick({});
    const auto hit = pick(landmarks);
    ASSERT_TRUE(hit.has_value());
    EXPECT_EQ(hit->text, plain ? "arm, where you tapped" : "arm, outermost point");
    beside += !plain;
  }
  EXPECT_GT(beside, 0) << "the landmark is on the outline";
}

}  // namespace
}  // namespace spool
