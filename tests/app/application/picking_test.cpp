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
      at(83, 60, 1.0),   // the steel, 3 px off
      at(85, 60, 1.01),  // the steel too, 5 px off
      at(80, 60, -1.0),  // behind the eye
      {nan, nan, nan},
  };
  EXPECT_EQ(pick_point(points, view, 80, 60, 9), 1U);
  EXPECT_EQ(pick_point(points, view, 80, 60, 2), 0U) << "nothing nearer within the slop";
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

TEST(Picking, ALandmarkWithinTheSlopIsMeantItself) {
  const auto design = test::prepared_bracket();
  const render::View view = view_at(test::T_design_camera());
  const std::vector<Landmark> landmarks{{{0.36, 0.12, 0.14}, 2, "post, outermost point"}};
  const auto spot = render::project(view, landmarks[0].position);
  const auto hit =
      pick_design(design->model, *design->surface, landmarks, view, spot.x + 4, spot.y, 9);
  ASSERT_TRUE(hit.has_value());
  EXPECT_EQ(hit->text, "post, outermost point");
}

}  // namespace
}  // namespace spool
