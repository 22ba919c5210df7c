// Claims about which landmarks a frame has measured, on the bracket with holes in its depth.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/application/landmark_evidence.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/app/runner/simulated_scene.h"
#include "vision/scan/back_projection.h"

namespace spool {
namespace {

using test::prepared_bracket;
using test::small_camera;

// The bracket's landmarks that this camera sees, and the frame that it saw.
class LandmarkEvidence : public testing::Test {
 protected:
  void SetUp() override {
    frame_ = *test::render_frame(*prepared_bracket(), truth_, 0);
    for (const Landmark& landmark :
         propose_landmarks(prepared_bracket()->model, *prepared_bracket()->surface, 12).landmarks) {
      if (std::abs(depth_at(landmark) - at(landmark).z()) < 0.01) seen_.push_back(landmark);
    }
    ASSERT_GE(seen_.size(), 4U);
  }
  [[nodiscard]] Eigen::Vector3d at(const Landmark& landmark) const {
    return truth_.inverse() * landmark.position;
  }
  [[nodiscard]] double depth_at(const Landmark& landmark) const {
    const Eigen::Vector2d pixel = small_camera().project(at(landmark));
    const auto u = std::lround(pixel.x()), v = std::lround(pixel.y());
    if (u < 0 || v < 0 || u >= frame_.width || v >= frame_.height) return 0;
    return small_camera().depth_unit_m * frame_.depth[static_cast<std::size_t>(v * 160 + u)];
  }
  // Bright metal: no depth within `reach_m` of the point.
  void blind(const Landmark& landmark, double reach_m) {
    const Eigen::Vector2d pixel = small_camera().project(at(landmark));
    const double reach = small_camera().fx * reach_m / at(landmark).z();
    for (int v = 0; v < frame_.height; ++v) {
      for (int u = 0; u < frame_.width; ++u) {
        if (std::hypot(u - pixel.x(), v - pixel.y()) > reach) continue;
        frame_.depth[static_cast<std::size_t>(v * frame_.width + u)] = 0;
      }
    }
  }
  // Picked with an error of a finger's size.
  [[nodiscard]] PointPair pair(std::size_t i, const Eigen::Vector3d& error = {0, 0, 0}) const {
    return {seen_[i].position, at(seen_[i]) + error};
  }
  [[nodiscard]] std::vector<double> likelihood(const std::vector<PointPair>& pairs,
                                               std::optional<Pose> T_design_camera = {}) const {
    const auto cloud = back_project(frame_, small_camera());
    EXPECT_TRUE(cloud.has_value());
    return measured_likelihood(
        {*prepared_bracket(), camera_, frame_, cloud->points, T_design_camera}, seen_, pairs);
  }

  const Pose truth_ = test::T_design_camera();
  const Camera camera_ = small_camera();
  DepthFrame frame_;
  std::vector<Landmark> seen_;
};

TEST_F(LandmarkEvidence, HoldsAllForMeasuredWhileNothingIsKnown) {
  blind(seen_[0], 0.05);
  for (const double value : likelihood({})) EXPECT_EQ(value, 1);
}

TEST_F(LandmarkEvidence, AnEarlierPoseTellsWhatHasNoDepth) {
  for (const double value : likelihood({}, truth_)) EXPECT_GE(value, 0.5);
  blind(seen_[0], 0.05);
  const auto values = likelihood({}, truth_);
  EXPECT_LT(values[0], 0.1);
  for (std::size_t i = 1; i < values.size(); ++i) {
    const bool near = (seen_[i].position - seen_[0].position).norm() < 0.1;
    EXPECT_TRUE(near || values[i] >= 0.5) << seen_[i].text << " " << values[i];
  }
}

TEST_F(LandmarkEvidence, APoseThatTheFrameContradictsTellsNothing) {
  blind(seen_[0], 0.05);
  for (const double value : likelihood({}, test::T_design_camera(1.5, 0.2))) EXPECT_EQ(value, 1);
}

TEST_F(LandmarkEvidence, OnePickPutsAnEarlierPoseRight) {
  blind(seen_[0], 0.05);
  Pose aside = truth_;  // the camera went 5 cm aside since
  aside.translation() += Eigen::Vector3d(0.05, 0, 0);
  const auto values = likelihood({pair(1)}, aside);
  EXPECT_LT(values[0], 0.1);
  EXPECT_GE(values[2], 0.5);
}

TEST_F(LandmarkEvidence, OnePickAloneRulesOutWhatIsFurtherThanAllThatIsMeasured) {
  seen_.push_back({seen_[0].position + Eigen::Vector3d(40, 0, 0), 0, "out of the picture"});
  const auto values = likelihood({pair(0)});
  EXPECT_EQ(values.back(), 0);
  EXPECT_EQ(values[1], 1);
}

TEST_F(LandmarkEvidence, TwoPicksOfAFingersErrorTellWhatHasNoDepth) {
  blind(seen_[2], 0.06);
  const auto values = likelihood({pair(0, {0.006, -0.005, 0.004}), pair(1, {-0.005, 0.006, 0.0})});
  EXPECT_LT(values[2], 0.3);
  EXPECT_GE(values[3], 0.5) << seen_[3].text;
}

TEST_F(LandmarkEvidence, TwoPicksThatFitNothingTellNothing) {
  blind(seen_[2], 0.06);
  PointPair wrong = pair(1);
  wrong.scan = pair(0).scan + Eigen::Vector3d(0, 0, -0.4);  // in the air before the bracket
  for (const double value : likelihood({pair(0), wrong})) EXPECT_EQ(value, 1);
}

}  // namespace
}  // namespace spool
