// Claims about from where to look next.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/live/next_view.h"

#include <gtest/gtest.h>

#include "tests/vision/live/placed_states.h"

namespace spool {
namespace {

struct Bracket {
  std::shared_ptr<const SurfacePatches> patches = SurfacePatches::cut(
      test::prepared_bracket()->samples, test::prepared_bracket()->model.parts.size());
  PatchReadings readings{patches, test::small_camera(), test::millimetre_noise()};
  NextView next{patches, *test::prepared_bracket()->surface};
  Pose T = test::walking(0);

  void see_from(const Pose& T_design_camera, int i) {
    T = T_design_camera;
    readings.add(test::placed_state(T, T, i), Matrix6d::Zero());
  }
  std::optional<NextLook> best() {
    for (int i = 0; i < 20; ++i) next.update(readings);  // more than there are places
    return next.best(T.translation(), T.linear().col(2), T.linear().col(1));
  }
};

TEST(NextView, KnowsWhatTheDesignHidesOfItself) {
  const Bracket bracket;
  const auto below_arm = bracket.patches->at({0.08F, 0.1F, 0.07F}, Eigen::Vector3f::UnitX());
  ASSERT_TRUE(below_arm.has_value());
  // The arm's inner face low above the base: free to the right and aslant from above.
  bool is_free = false;
  for (std::size_t s = 0; s < NextView::kSides; ++s) {
    const Eigen::Vector3f side = bracket.next.side(s);
    if (side.x() > 0.7F && side.z() > 0.5F) is_free |= bracket.next.is_visible(*below_arm, s);
    if (side.z() > -0.5F) continue;
    EXPECT_FALSE(bracket.next.is_visible(*below_arm, s)) << "the base is before it";
  }
  EXPECT_TRUE(is_free);
}

TEST(NextView, IsNotWhereTheCameraLookedFrom) {
  Bracket bracket;
  for (int i = 0; i < 40; ++i) bracket.see_from(test::walking(i), i);
  const auto look = bracket.best();
  ASSERT_TRUE(look.has_value());
  // Whatever it shows was not known: of the patches that face that side there, some are not.
  std::size_t not_known = 0, known = 0;
  for (std::size_t s = 0; s < NextView::kSides; ++s) {
    if (bracket.next.side(s) != look->direction) continue;
    for (std::size_t k = 0; k < bracket.patches->all().size(); ++k)
      if (bracket.next.is_visible(k, s)) ++(bracket.readings.is_known(k) ? known : not_known);
  }
  EXPECT_GT(not_known, 20U);
  const Eigen::Vector3d now = (bracket.T.translation() - look->target.cast<double>()).normalized();
  EXPECT_LT(look->direction.cast<double>().dot(now), 0.8);
  EXPECT_GT(look->direction.z(), -0.6F) << "nobody looks from under the floor";
}

TEST(NextView, KeepsToWhatItSaidWhileItIsHalfAsGood) {
  Bracket bracket;
  for (int i = 0; i < 20; ++i) bracket.see_from(test::walking(i), i);
  const auto first = bracket.best();
  ASSERT_TRUE(first.has_value());
  // The camera goes half round: other looks are nearer now.
  for (int i = 20; i < 30; ++i) {
    bracket.T = test::T_design_camera(0.15 * (i - 20));
    const auto again = bracket.best();
    ASSERT_TRUE(again.has_value());
    EXPECT_EQ(again->direction, first->direction) << i;
  }
}

TEST(NextView, HasNothingToSayBeforeAllWasWeighedAndAfterAllIsKnown) {
  Bracket bracket;
  EXPECT_FALSE(
      bracket.next
          .best(bracket.T.translation(), bracket.T.linear().col(2), bracket.T.linear().col(1))
          .has_value());
  // Seen from all round and above, over and over; what is left is the underside.
  for (int i = 0; i < 160; ++i)
    bracket.see_from(test::T_design_camera(0.0393 * i, 0.03 * (i % 3)), i);
  const auto look = bracket.best();
  if (look) {
    EXPECT_LT(look->direction.z(), 0.1F) << look->gain;
  }
}

}  // namespace
}  // namespace spool
