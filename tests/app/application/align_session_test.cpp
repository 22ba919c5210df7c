// Claims about picks: what is lit, what undo takes back, what is refused.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/application/align_session.h"

#include <gtest/gtest.h>

namespace spool {
namespace {

std::vector<Landmark> three() {
  return {{{0, 0, 0}, 0, "a"}, {{1, 0, 0}, 0, "b"}, {{0, 1, 0}, 0, "c"}};
}

TEST(AlignSession, LightsTheNextProposedPointAfterEachPick) {
  AlignSession session(three());
  EXPECT_EQ(session.lit()->text, "a");
  EXPECT_TRUE(session.pick_scan_point({5, 0, 0}));
  EXPECT_EQ(session.lit()->text, "b");
  session.undo();
  EXPECT_EQ(session.lit()->text, "a");
  EXPECT_FALSE(session.can_undo());
}

TEST(AlignSession, AnotherDesignPointCanBeTappedInstead) {
  AlignSession session(three());
  session.choose_design_point({{0.5, 0.5, 0}, 0, "tapped"});
  EXPECT_EQ(session.lit()->text, "tapped");
  session.undo();  // takes the choice back first
  EXPECT_EQ(session.lit()->text, "a");
  session.choose_design_point(three()[1]);
  EXPECT_TRUE(session.pick_scan_point({1, 0, 0}));
  EXPECT_EQ(session.lit()->text, "a") << "b is used";
}

TEST(AlignSession, ThreePairsGiveThePoseThatMadeThem) {
  AlignSession session(three());
  Vector6d small;
  small << 0.3, -0.2, 1.0, 0.4, 0.1, -0.3;
  const Pose T_scan_design = pose_from_small(small);
  for (const Landmark& landmark : three()) {
    EXPECT_EQ(session.result().status, PairsStatus::kTooFew);
    EXPECT_TRUE(session.pick_scan_point(T_scan_design * landmark.position));
  }
  ASSERT_EQ(session.result().status, PairsStatus::kOk) << session.result().reason;
  const PoseSize error = pose_size(session.result().T_design_scan * T_scan_design);
  EXPECT_LT(error.translation_m, 1e-9);
  EXPECT_LT(error.rotation_rad, 1e-9);
  EXPECT_EQ(session.result().residual_m.size(), 3U);
}

TEST(AlignSession, KeepsTheReasonOfARefusalUntilUndo) {
  AlignSession session(three());
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(session.pick_scan_point({1, 2, 3}));
  EXPECT_NE(session.result().status, PairsStatus::kOk);
  EXPECT_FALSE(session.result().reason.empty());
  EXPECT_FALSE(session.pick_scan_point({0, 0, 0})) << "no proposed point is left";
  session.undo();
  EXPECT_EQ(session.result().status, PairsStatus::kTooFew);
}

}  // namespace
}  // namespace spool
