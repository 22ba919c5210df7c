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

// A square of a metre, its corners in the order of the proposal, and a point near the first.
std::vector<Landmark> square() {
  return {{{0, 0, 0}, 0, "a"},
          {{1, 1, 0}, 0, "b"},
          {{1, 0, 0}, 0, "c"},
          {{0, 1, 0}, 0, "d"},
          {{0.1, 0.1, 0}, 0, "e"}};
}

TEST(AlignSession, ASkippedPointIsNeverProposedAgainInThisAlignment) {
  AlignSession session(square());
  ASSERT_TRUE(session.can_skip());
  EXPECT_EQ(session.lit_after_skip()->text, "b");
  session.skip();
  EXPECT_EQ(session.lit()->text, "b") << "what was offered";
  EXPECT_FALSE(session.can_undo()) << "a skip is no pick";
  EXPECT_TRUE(session.pick_scan_point({5, 0, 0}));
  session.undo();
  EXPECT_EQ(session.lit()->text, "b") << "not a, even with nothing picked";
  for (const char* next : {"c", "d", "e"}) {
    session.skip();
    EXPECT_EQ(session.lit()->text, next);
  }
  EXPECT_FALSE(session.lit_after_skip().has_value());
  session.skip();
  EXPECT_FALSE(session.lit().has_value()) << "all were skipped: a tap on the drawing is left";
  EXPECT_FALSE(session.can_skip());
  session.choose_design_point({{0.5, 0.5, 0}, 0, "tapped"});
  EXPECT_TRUE(session.pick_scan_point({5, 0, 0}));
  session.clear();
  EXPECT_EQ(session.lit()->text, "a") << "another alignment begins anew";
}

TEST(AlignSession, SkippingATappedPointGoesBackToTheProposal) {
  AlignSession session(square());
  session.choose_design_point({{0.5, 0.5, 0}, 0, "tapped"});
  EXPECT_EQ(session.lit_after_skip()->text, "a");
  session.skip();
  EXPECT_EQ(session.lit()->text, "a");
  session.choose_design_point(square()[0]);  // the proposed point itself
  EXPECT_EQ(session.lit_after_skip()->text, "b");
  session.skip();
  EXPECT_EQ(session.lit()->text, "b");
}

TEST(AlignSession, AfterASkipTheNextPointIsStillFarFromThePicksAndOffTheirLine) {
  AlignSession session(square());
  EXPECT_TRUE(session.pick_scan_point({0, 0, 5}));  // a
  EXPECT_TRUE(session.pick_scan_point({1, 1, 5}));  // b
  EXPECT_EQ(session.lit()->text, "c");
  session.skip();
  EXPECT_EQ(session.lit()->text, "d") << "e lies on the line from a to b";
  session.undo();
  session.choose_design_point(square()[4]);
  EXPECT_TRUE(session.pick_scan_point({0.1, 0.1, 5}));  // e, next to a
  EXPECT_EQ(session.lit()->text, "d") << "b lies in line, c was skipped";
}

TEST(AlignSession, ProposesWhatThePictureHasMeasured) {
  std::vector<double> likelihood;
  std::size_t asked_with = 99;
  AlignSession session(square(), [&](std::span<const PointPair> pairs) {
    asked_with = pairs.size();
    return likelihood;
  });
  EXPECT_EQ(asked_with, 99U) << "nothing is asked before there is a picture";
  EXPECT_EQ(session.lit()->text, "a");
  likelihood = {1, 0.1, 0.2, 0.9, 1};
  EXPECT_TRUE(session.pick_scan_point({0, 0, 5}));
  EXPECT_EQ(asked_with, 1U);
  EXPECT_EQ(session.lit()->text, "d") << "b and c are not measured";
  likelihood = {0, 1, 1, 1, 1};
  EXPECT_EQ(session.lit()->text, "d") << "what is lit stays lit until something is done";
  likelihood = {0, 0, 0, 0, 0};
  session.skip();
  EXPECT_EQ(session.lit()->text, "b") << "the fitter may see what the program does not";
}

TEST(AlignSession, ARefusedTapIsSaidUntilSomethingElseHappens) {
  AlignSession session(square());
  const auto refused = [&] {
    session.refuse_scan_point();
    EXPECT_TRUE(session.is_refused());
    EXPECT_EQ(session.lit()->text, "a") << "the same point is still asked for";
    EXPECT_TRUE(session.pairs().empty());
  };
  refused();
  session.choose_design_point(square()[2]);
  EXPECT_FALSE(session.is_refused());
  session.undo();
  refused();
  EXPECT_TRUE(session.pick_scan_point({0, 0, 5}));
  EXPECT_FALSE(session.is_refused());
  session.undo();
  refused();
  session.skip();
  EXPECT_FALSE(session.is_refused());
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
