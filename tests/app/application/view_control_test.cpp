// Laws of turning, panning and zooming an eye.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/application/view_control.h"

#include <numbers>

#include <gtest/gtest.h>

namespace spool {
namespace {

constexpr ui::Rect kRect{100, 50, 400, 300};

render::View start_view() {
  render::View view;
  view.camera = {.width = 400, .height = 300, .fx = 350, .fy = 350, .cx = 199.5, .cy = 149.5};
  return view;
}

ViewControl eye_at(double pivot_m) {
  ViewControl eye;
  eye.start(start_view(), pivot_m);
  return eye;
}

TEST(ViewControl, OrbitKeepsThePivotWhereItIs) {
  ViewControl eye = eye_at(2.0);
  ui::Gesture gesture;
  gesture.kind = ui::Gesture::Kind::kOrbit;
  gesture.dx = 37;
  gesture.dy = -21;
  eye.apply(gesture, kRect);
  const Eigen::Vector3d pivot = eye.view().T_camera_design * Eigen::Vector3d(0, 0, 2);
  EXPECT_LT((pivot - Eigen::Vector3d(0, 0, 2)).norm(), 1e-12);
}

TEST(ViewControl, TheNearSideFollowsTheFinger) {
  const Eigen::Vector3d near(0, 0, 1.5);  // before the pivot
  const auto before = render::project(start_view(), near);
  for (const auto& [dx, dy] : {std::pair(20.0, 0.0), std::pair(0.0, 20.0)}) {
    ViewControl eye = eye_at(2.0);
    ui::Gesture gesture;
    gesture.kind = ui::Gesture::Kind::kOrbit;
    gesture.dx = dx;
    gesture.dy = dy;
    eye.apply(gesture, kRect);
    const auto after = render::project(eye.view(), near);
    EXPECT_GT((after.x - before.x) * dx + (after.y - before.y) * dy, 0);
  }
}

TEST(ViewControl, PanMovesWhatIsAtThePivotByAsManyPixelsAsTheFingers) {
  ViewControl eye = eye_at(2.0);
  ui::Gesture gesture;
  gesture.kind = ui::Gesture::Kind::kMove;
  gesture.dx = 30;
  gesture.dy = -12;
  eye.apply(gesture, kRect);
  const Eigen::Vector3d pivot(0.1, 0.2, 2);
  const auto before = render::project(start_view(), pivot);
  const auto after = render::project(eye.view(), pivot);
  EXPECT_NEAR(after.x - before.x, 30, 1e-9);
  EXPECT_NEAR(after.y - before.y, -12, 1e-9);
}

TEST(ViewControl, ZoomAndRollKeepWhatIsUnderTheFingersAndMagnifyByTheFactor) {
  ViewControl eye = eye_at(2.0);
  ui::Gesture gesture;
  gesture.kind = ui::Gesture::Kind::kMove;
  gesture.x = 350;  // px of the window
  gesture.y = 120;
  gesture.factor = 1.6;
  gesture.roll_rad = 0.3;
  const Eigen::Vector3d held =
      start_view().camera.back_project(gesture.x - kRect.x, gesture.y - kRect.y, 2.0);
  eye.apply(gesture, kRect);
  const auto after = render::project(eye.view(), held);
  EXPECT_NEAR(after.x, gesture.x - kRect.x, 1e-9);
  EXPECT_NEAR(after.y, gesture.y - kRect.y, 1e-9);
  // A point 1 cm to the right at the pivot's distance: 1.6 times as far on the picture, turned
  // clockwise.
  const auto beside = render::project(eye.view(), held + Eigen::Vector3d(0.01, 0, 0));
  const double px = 0.01 * 350 / 2.0 * 1.6;
  EXPECT_NEAR(std::hypot(beside.x - after.x, beside.y - after.y), px, 1e-9);
  EXPECT_NEAR(std::atan2(beside.y - after.y, beside.x - after.x), 0.3, 1e-9);
}

TEST(ViewControl, ZoomEndsBeforeTheEyeIsInTheSteel) {
  ViewControl eye = eye_at(0.2);
  ui::Gesture gesture;
  gesture.kind = ui::Gesture::Kind::kMove;
  gesture.x = kRect.x + 199.5;
  gesture.y = kRect.y + 149.5;
  gesture.factor = 100;
  eye.apply(gesture, kRect);
  EXPECT_GT((eye.view().T_camera_design * Eigen::Vector3d(0, 0, 0.2)).z(), 0.04);
}

}  // namespace
}  // namespace spool
