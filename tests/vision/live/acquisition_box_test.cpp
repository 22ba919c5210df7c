// What lies outside the acquisition box is not used, and nothing inside is lost.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/live/acquisition_box.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/app/runner/simulated_scene.h"
#include "vision/live/frame_processor.h"

namespace spool {
namespace {

VisionStatePtr workshop() {
  FrameProcessor vision(test::prepared_bracket(), test::small_camera(), {.constant_m = 0.0008},
                        {.stride_px = 1});
  return *vision.process(test::render_in_workshop(test::prepared_bracket().get(), Pose::Identity(),
                                                  test::T_design_camera(), 0));
}

// A point of the floor, from the bracket's middle: to the right and away as the camera looks.
Eigen::Vector3f on_floor(double right, double away) {
  const Eigen::Vector3d middle(0.2, 0.1, -0.1);
  const Eigen::Vector3d a(-std::cos(-1.0), -std::sin(-1.0), 0), r(a.y(), -a.x(), 0);
  return (test::T_design_camera().inverse() * (middle + right * r + away * a)).cast<float>();
}

AcquisitionBox about_the_bracket(const VisionState& state) {
  return box_between(on_floor(-0.24, -0.21), on_floor(0.24, 0.21), state.scan,
                     test::bracket_design());
}

TEST(AcquisitionBox, StandsUprightOnTheFloorAboutItsCorners) {
  const auto state = workshop();
  const AcquisitionBox box = about_the_bracket(*state);
  const Pose T_box_design = box.T_box_scene * test::T_design_camera().inverse();
  // The design's z is up, and so is the box's: to two degrees of a coarse camera.
  EXPECT_GT(T_box_design.linear()(2, 2), std::cos(2 * 0.01745));
  EXPECT_NEAR(T_box_design.linear().determinant(), 1, 1e-6);
  // Half of 0.20 m, the bracket's least extent, and upright 0.40 m, its largest.
  EXPECT_NEAR(box.bounds.sizes().x(), 0.48 + 0.2, 0.03);
  EXPECT_NEAR(box.bounds.sizes().y(), 0.42 + 0.2, 0.03);
  EXPECT_NEAR(box.bounds.sizes().z(), 0.8, 0.03);
  for (const Eigen::Vector3f& sample : test::prepared_bracket()->samples.cloud.points)
    ASSERT_TRUE(box.contains(test::T_design_camera().inverse().cast<float>() * sample));
}

TEST(AcquisitionBox, IsSquareToACameraThatSeesNoPlane) {
  PointCloud ball;
  for (int i = 0; i < 2000; ++i) {
    const double a = 2.4 * i, z = (i + 0.5) / 1000 - 1, r = std::sqrt(1 - z * z);
    ball.normals.emplace_back(Eigen::Vector3d(r * std::cos(a), r * std::sin(a), z).cast<float>());
    ball.points.push_back(0.2F * ball.normals.back() + Eigen::Vector3f(0, 0, 1));
  }
  const AcquisitionBox box = box_between({-0.1F, 0, 1}, {0.1F, 0, 1}, ball, test::bracket_design());
  EXPECT_TRUE(box.T_box_scene.isApprox(Pose::Identity()));
}

TEST(AcquisitionBox, LeavesOutEveryPointAndPixelOutsideAndNoneInside) {
  const auto state = workshop();
  const AcquisitionBox box = about_the_bracket(*state);
  const auto inside = only_inside(*state, box, test::small_camera(), 77);
  EXPECT_EQ(inside->revision, 77U);
  std::size_t expected = 0;
  for (const Eigen::Vector3f& point : state->scan.points) expected += box.contains(point) ? 1U : 0U;
  EXPECT_EQ(inside->scan.size(), expected);
  EXPECT_GT(expected, 1000U);
  EXPECT_LT(expected, state->scan.size() * 4 / 5) << "most of crate, shelf and floor is out";
  for (const Eigen::Vector3f& point : inside->scan.points) ASSERT_TRUE(box.contains(point));
  // Every pixel is a point here.
  std::size_t pixels = 0;
  for (const std::uint16_t count : inside->frame->depth) pixels += count != 0 ? 1U : 0U;
  EXPECT_EQ(pixels, expected);
  EXPECT_EQ(inside->scan.normals.size(), inside->scan.size());
  EXPECT_EQ(state->scan.size(), workshop()->scan.size()) << "the picture itself is left as it is";
}

TEST(AcquisitionBox, OfAnAlignedDesignCostsNoPointThatWouldBeMeasured) {
  FrameProcessor vision(test::prepared_bracket(), test::small_camera(), {.constant_m = 0.0008},
                        {.stride_px = 1});
  const Pose T = test::T_design_camera();
  const auto held = *vision.process(
      test::render_in_workshop(test::prepared_bracket().get(), Pose::Identity(), T, 0));
  const auto state = vision.align(*held, T);
  ASSERT_TRUE(state->is_tracked());
  std::size_t measured = 0, outside = 0;
  const Eigen::AlignedBox3f box = box_about(test::bracket_design(), 0.03);
  for (std::size_t i = 0; i < state->scan_design.size(); ++i) {
    const Eigen::Vector3f& point = state->scan_design.points[i];
    const auto nearest = test::prepared_bracket()->surface->closest(point, 0.03F);
    const bool is_object = state->classes[i] == PointClass::kObject;
    measured += is_object ? 1U : 0U;
    // Nearer than three standard deviations no reading is dropped for facing away.
    if (nearest && std::abs(nearest->distance) < 0.002F) {
      EXPECT_TRUE(is_object) << point.transpose();
    }
    if (box.contains(point)) continue;
    ++outside;
    EXPECT_FALSE(nearest.has_value());
    EXPECT_FALSE(is_object);
    EXPECT_TRUE(std::isnan(state->deviations.distance_m[i]));
    EXPECT_EQ(state->deviations.part[i], -1);
  }
  EXPECT_GT(measured, 2000U);
  EXPECT_GT(outside, 4000U);
}

}  // namespace
}  // namespace spool
