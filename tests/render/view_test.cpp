// Views: the one place where camera and GL frames meet.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "render/view.h"

#include <cmath>
#include <random>

#include <glm/vec4.hpp>
#include <gtest/gtest.h>

namespace spool::render {
namespace {

// The pixel that GL would draw a point to, by the definition of the viewport transform (OpenGL
// ES 3.0.6, 2.12.1) with the picture's rows counted from the top.
Eigen::Vector3d drawn_at(const View& view, const Eigen::Vector3d& p_design) {
  const glm::vec4 clip =
      clip_from_eye(view) * eye_from_design(view) *
      glm::vec4(static_cast<float>(p_design.x()), static_cast<float>(p_design.y()),
                static_cast<float>(p_design.z()), 1.0F);
  const double x = 0.5 * (clip.x / clip.w + 1) * view.camera.width - 0.5;
  const double y = 0.5 * (1 - clip.y / clip.w) * view.camera.height - 0.5;
  return {x, y, clip.z / clip.w};
}

View kinect_view() {
  View view;
  view.camera.width = 640;
  view.camera.height = 480;
  view.camera.fx = 525;
  view.camera.fy = 520;
  view.camera.cx = 310.5;
  view.camera.cy = 251.25;
  view.near_m = 0.5;
  view.far_m = 5.0;
  return view;
}

// By hand: the axis lands on the principal point; 0.1 m right at 1 m is fx/10 px right; 0.1 m down
// (camera y) at 2 m is fy/20 px down.
TEST(View, ThreeKnownPointsLandOnTheirPixels) {
  const View view = kinect_view();
  const double tolerance = 1e-3;  // px; float matrices: 640 * 2^-24 * a few operations
  EXPECT_NEAR(drawn_at(view, {0, 0, 1}).x(), 310.5, tolerance);
  EXPECT_NEAR(drawn_at(view, {0, 0, 1}).y(), 251.25, tolerance);
  EXPECT_NEAR(drawn_at(view, {0.1, 0, 1}).x(), 363.0, tolerance);
  EXPECT_NEAR(drawn_at(view, {0.1, 0, 1}).y(), 251.25, tolerance);
  EXPECT_NEAR(drawn_at(view, {0, 0.1, 2}).x(), 310.5, tolerance);
  EXPECT_NEAR(drawn_at(view, {0, 0.1, 2}).y(), 277.25, tolerance);
}

TEST(View, EyeFrameIsXRightYUpZBackward) {
  View view = kinect_view();
  view.T_camera_design.translation() = Eigen::Vector3d(0, 0, 3);
  const glm::vec4 eye = eye_from_design(view) * glm::vec4(1, 2, 0, 1);
  EXPECT_FLOAT_EQ(eye.x, 1);
  EXPECT_FLOAT_EQ(eye.y, -2);
  EXPECT_FLOAT_EQ(eye.z, -3);
}

TEST(View, NearAndFarPlanesBoundTheDepthRange) {
  const View view = kinect_view();
  EXPECT_NEAR(drawn_at(view, {0, 0, 0.5}).z(), -1, 1e-5);
  EXPECT_NEAR(drawn_at(view, {0, 0, 5.0}).z(), 1, 1e-5);
}

TEST(View, ProjectAgreesWithTheMatricesAtAnyPose) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(-1, 1);
  View view = kinect_view();
  for (int i = 0; i < 200; ++i) {
    view.T_camera_design = Pose::Identity();
    view.T_camera_design.linear() =
        rotation_from_vector(3 * Eigen::Vector3d(unit(random), unit(random), unit(random)));
    view.T_camera_design.translation() = Eigen::Vector3d(unit(random), unit(random), unit(random));
    const Eigen::Vector3d p_camera(unit(random), unit(random), 1.5 + unit(random) / 2);
    const Eigen::Vector3d p = view.T_camera_design.inverse() * p_camera;
    const Projected projected = project(view, p);
    const Eigen::Vector3d drawn = drawn_at(view, p);
    EXPECT_NEAR(projected.x, drawn.x(), 5e-3);  // px; float matrices of positions up to 3 m
    EXPECT_NEAR(projected.y, drawn.y(), 5e-3);
    EXPECT_NEAR(projected.depth_m, p_camera.z(), 1e-12);
  }
}

TEST(View, DepthBehindTheCameraIsNegative) {
  EXPECT_LT(project(kinect_view(), {0.1, 0.1, -1}).depth_m, 0);
}

TEST(ViewOf, ShowsEveryCornerAndFillsThePicture) {
  const Eigen::AlignedBox3d box(Eigen::Vector3d(1, 2, 3), Eigen::Vector3d(1.6, 2.1, 3.4));
  for (const Eigen::Vector3d& direction :
       {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(-1, 1, -0.5), Eigen::Vector3d(0, 0, -1)}) {
    const View view = view_of(box, direction, Eigen::Vector3d::UnitZ(), 400, 300);
    ASSERT_TRUE(view.camera.is_valid());
    Eigen::AlignedBox2d seen;
    for (int corner = 0; corner < 8; ++corner) {
      const Projected p =
          project(view, box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner)));
      seen.extend(Eigen::Vector2d(p.x, p.y));
      EXPECT_GT(p.depth_m, view.near_m);
      EXPECT_LT(p.depth_m, view.far_m);
    }
    const Eigen::AlignedBox2d picture(Eigen::Vector2d(0, 0), Eigen::Vector2d(399, 299));
    EXPECT_TRUE(picture.contains(seen)) << direction.transpose();
    const Eigen::Vector2d share = seen.sizes().cwiseQuotient(picture.sizes());
    EXPECT_GT(share.maxCoeff(), 0.85) << direction.transpose();
    EXPECT_LT((seen.center() - picture.center()).norm(), 0.05 * 400) << direction.transpose();
  }
}

TEST(ViewOf, PutsUpUpwards) {
  const Eigen::AlignedBox3d box(Eigen::Vector3d(-1, -1, -1), Eigen::Vector3d(1, 1, 1));
  const View view = view_of(box, {0, 1, -0.3}, Eigen::Vector3d::UnitZ(), 300, 300);
  EXPECT_LT(project(view, {0, 0, 0.5}).y, project(view, {0, 0, 0}).y - 10);
  EXPECT_NEAR(project(view, {0, 0, 0.5}).x, project(view, {0, 0, 0}).x, 1e-6);
  EXPECT_GT(project(view, {0.5, 0, 0}).x, project(view, {0, 0, 0}).x + 10);
}

TEST(ViewOf, LooksAlongUpAndAtNothingWithoutFailing) {
  const View down = view_of({}, -Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitZ(), 320, 240);
  EXPECT_TRUE(down.camera.is_valid());
  EXPECT_TRUE(down.T_camera_design.matrix().allFinite());
  EXPECT_NEAR(down.T_camera_design.linear().determinant(), 1, 1e-12);
}

TEST(CameraInPicture, KeepsRaysAndTheWholeImage) {
  const Camera camera = kinect_view().camera;
  for (const auto& [width, height] : {std::pair{1280, 960}, {1280, 800}, {200, 480}, {320, 240}}) {
    const Camera scaled = camera_in_picture(camera, width, height);
    EXPECT_EQ(scaled.width, width);
    EXPECT_EQ(scaled.height, height);
    // The image's corners (half a pixel outside the outer pixels' centres) stay inside the picture,
    // and two opposite sides touch it.
    const double w = camera.width - 0.5;
    const double h = camera.height - 0.5;
    const Eigen::Vector2d low = scaled.project(camera.back_project(-0.5, -0.5, 1));
    const Eigen::Vector2d high = scaled.project(camera.back_project(w, h, 1));
    EXPECT_GT(low.minCoeff(), -0.5 - 1e-9);
    EXPECT_LT(high.x(), width - 0.5 + 1e-9);
    EXPECT_LT(high.y(), height - 0.5 + 1e-9);
    EXPECT_NEAR(std::min(low.x(), low.y()), -0.5, 1e-9);
    EXPECT_NEAR((high - low).x() / (high - low).y(), 640.0 / 480.0, 1e-9);
    EXPECT_NEAR(low.x() + high.x(), width - 1, 1e-9);  // letter-boxed evenly
    EXPECT_NEAR(low.y() + high.y(), height - 1, 1e-9);
  }
}

}  // namespace
}  // namespace spool::render
