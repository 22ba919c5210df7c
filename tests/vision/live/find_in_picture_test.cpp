// Claims about a search in one picture: the pose, no pose, and poses that the picture cannot tell
// apart.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/live/find_in_picture.h"

#include <algorithm>
#include <map>
#include <memory>

#include <gtest/gtest.h>

#include "tests/app/runner/simulated_scene.h"
#include "vision/live/frame_processor.h"

namespace spool {
namespace {

NoiseModel noise() {
  NoiseModel model;
  model.constant_m = 0.0008;
  return model;
}

// Prepared once a design: most of the time goes there.
const FinderModel& finder_of(const std::shared_ptr<const PreparedDesign>& design) {
  static std::map<std::shared_ptr<const PreparedDesign>, FinderModel> ready;
  auto found = ready.find(design);
  if (found == ready.end())
    found = ready
                .emplace(design,
                         FinderModel::prepare(design->exterior, *design->surface, design->samples))
                .first;
  return found->second;
}

FindAnswer find_in(const std::shared_ptr<const PreparedDesign>& design,
                   const std::shared_ptr<const DepthFrame>& frame, const Watch& watch = {}) {
  FrameProcessor vision(design, test::small_camera(), noise(), {.stride_px = 1});
  const auto state = vision.process(frame);
  EXPECT_TRUE(state.has_value());
  return find_in_picture(design, finder_of(design), **state, test::small_camera(), noise(), watch);
}

double off_m(const VisionState& found, const Pose& truth) {
  return pose_size(truth.inverse() * found.T_design_camera).translation_m;
}

TEST(FindInPicture, FindsTheBracketFromEachSideAsThreePicksWould) {
  for (const double turn : {0.0, 1.0, 2.0}) {
    const Pose truth = test::T_design_camera(turn);
    const auto frame = test::render_frame(*test::prepared_bracket(), truth, 3);
    const FindAnswer answer = find_in(test::prepared_bracket(), frame);
    ASSERT_EQ(answer.poses.size(), 1U) << turn << answer.reason;
    const VisionState& found = *answer.poses[0];
    EXPECT_LT(off_m(found, truth), 0.0015) << turn;
    EXPECT_TRUE(found.is_tracked()) << turn;
    EXPECT_EQ(found.scan_design.size(), found.scan.size()) << "it can be shown as it is";
    EXPECT_EQ(found.frame, frame);
  }
}

TEST(FindInPicture, SaysWhatToDoWhereNothingIsFound) {
  const FindAnswer answer =
      find_in(test::prepared_bracket(), test::empty_frame(test::T_design_camera(), 0));
  EXPECT_TRUE(answer.poses.empty());
  EXPECT_FALSE(answer.reason.empty());
}

TEST(FindInPicture, ACancelledSearchFindsNothing) {
  std::stop_source stop;
  stop.request_stop();
  const auto frame = test::render_frame(*test::prepared_bracket(), test::T_design_camera(), 0);
  EXPECT_TRUE(find_in(test::prepared_bracket(), frame, {stop.get_token(), {}}).poses.empty());
}

TEST(FindInPicture, GivesEveryWayThatAPlateWithAHiddenPegCanLie) {
  const auto plate = test::prepared_plate();
  const Pose truth = test::T_design_camera();
  const FindAnswer answer = find_in(plate, test::render_frame(*plate, truth, 0));
  ASSERT_GE(answer.poses.size(), 2U) << answer.reason;
  EXPECT_TRUE(std::any_of(answer.poses.begin(), answer.poses.end(), [&](const auto& found) {
    return off_m(*found, truth) < 0.003;
  })) << "the true one is among them";
  for (const auto& found : answer.poses) EXPECT_TRUE(found->is_tracked());
}

TEST(FindInPicture, WhatSymmetryMakesEqualIsNoChoice) {
  const auto plate = test::prepared_plate(false);
  const Pose truth = test::T_design_camera();
  const FindAnswer answer = find_in(plate, test::render_frame(*plate, truth, 0));
  EXPECT_EQ(answer.poses.size(), 1U) << answer.reason;
}

}  // namespace
}  // namespace spool
