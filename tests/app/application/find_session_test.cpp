// Claims about what a search is at: running, found, not found, a choice, cancelled.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/application/find_session.h"

#include <memory>

#include <gtest/gtest.h>

namespace spool {
namespace {

using Phase = FindSession::Phase;

VisionStatePtr pose_at(double x) {
  auto state = std::make_shared<VisionState>();
  state->T_design_camera.translation().x() = x;
  return state;
}

double x_of(const VisionStatePtr& state) { return state->T_design_camera.translation().x(); }

TEST(FindSession, OnePoseIsHandedOnAtOnce) {
  FindSession find;
  EXPECT_EQ(find.phase(), Phase::kIdle);
  find.start();
  EXPECT_TRUE(find.is_running());
  const VisionStatePtr found = find.answer({{pose_at(3)}, ""});
  ASSERT_TRUE(found);
  EXPECT_EQ(x_of(found), 3);
  EXPECT_EQ(find.phase(), Phase::kIdle);
  EXPECT_FALSE(find.shown()) << "no choice to make";
}

TEST(FindSession, ProgressNeverGoesBackAndEndsWithTheSearch) {
  FindSession find;
  find.report({"find", 0.5});
  EXPECT_EQ(find.progress().share, 0) << "nothing runs";
  find.start();
  find.report({"prepare", 0.25});
  find.report({"find", 0.75});
  find.report({"find", 0.5});
  EXPECT_EQ(find.progress().stage, "find");
  EXPECT_EQ(find.progress().share, 0.75);
  find.report({"fit", 7});
  EXPECT_EQ(find.progress().share, 1);
  find.start();
  EXPECT_EQ(find.progress().share, 0) << "the next search begins at nothing";
}

TEST(FindSession, NotFoundSaysWhyUntilTheNextSearch) {
  FindSession find;
  find.start();
  EXPECT_FALSE(find.answer({{}, "nothing there"}));
  EXPECT_EQ(find.phase(), Phase::kNotFound);
  EXPECT_EQ(find.reason(), "nothing there");
  find.start();
  EXPECT_TRUE(find.is_running());
  EXPECT_EQ(find.reason(), "");
}

TEST(FindSession, SeveralPosesAreSteppedThroughAndOneIsAccepted) {
  FindSession find;
  find.start();
  EXPECT_FALSE(find.answer({{pose_at(1), pose_at(2)}, ""})) << "the user chooses";
  EXPECT_EQ(find.phase(), Phase::kChoosing);
  EXPECT_EQ(find.choices(), 2U);
  EXPECT_EQ(x_of(find.shown()), 1);
  find.next();
  EXPECT_EQ(find.choice(), 1U);
  EXPECT_EQ(x_of(find.shown()), 2);
  find.next();
  EXPECT_EQ(x_of(find.shown()), 1) << "round again";
  find.next();
  const VisionStatePtr chosen = find.accept();
  ASSERT_TRUE(chosen);
  EXPECT_EQ(x_of(chosen), 2);
  EXPECT_EQ(find.phase(), Phase::kIdle);
  EXPECT_FALSE(find.accept()) << "once";
}

TEST(FindSession, WhatIsCancelledHasNoAnswer) {
  FindSession find;
  find.start();
  find.report({"find", 0.5});
  find.cancel();
  EXPECT_EQ(find.phase(), Phase::kIdle);
  EXPECT_FALSE(find.answer({{pose_at(1)}, ""}));
  EXPECT_FALSE(find.answer({{}, "late"}));
  EXPECT_EQ(find.phase(), Phase::kIdle);
  find.start();
  EXPECT_FALSE(find.answer({{pose_at(1), pose_at(2)}, ""}));
  find.cancel();
  EXPECT_FALSE(find.shown()) << "the choice is given up";
  EXPECT_FALSE(find.accept());
}

TEST(FindSession, AFailureIsSaidLikeWhatWasNotFound) {
  FindSession find;
  find.start();
  find.fail("the sensor went away");
  EXPECT_EQ(find.phase(), Phase::kNotFound);
  EXPECT_EQ(find.reason(), "the sensor went away");
  find.cancel();
  EXPECT_EQ(find.phase(), Phase::kIdle);
}

}  // namespace
}  // namespace spool
