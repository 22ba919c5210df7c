// The design is found in a cluttered room, and is not where it is not.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/find/finder.h"

#include <random>
#include <utility>

#include <gtest/gtest.h>

#include "tests/vision/find/room.h"

namespace spool {
namespace {

using test::Rod;
using test::Room;

// The samples' tangent planes stand off a 40 mm pipe by 0.4 mm at a cell's distance (5 mm); 2 mm of
// noise over a thousand points adds a tenth; seen from one side, at its far end it may turn by
// three times as much, and the table that it lies on pulls. ICP on the surface comes after.
constexpr double kOff = 0.006;  // m

// Off (m) from the nearest of the copies.
double off(const FinderModel& model, const Room& room, const Pose& T_design_scan) {
  double least = 1e9;
  for (const Pose& T : room.T_scan_design)
    least = std::min(least, test::pose_distance(model, T_design_scan, T.inverse()));
  return least;
}

TEST(Finder, FindsATeeInACrowdedRoomAndNothingWhereItIsNot) {
  const FinderModel model = test::finder_of(test::design_of(test::tee_spool()), 4000);
  for (unsigned seed = 1; seed <= 10; ++seed) {
    std::mt19937 random{seed};
    const Room room = test::make_room(test::tee_spool(), {}, random);
    const FindResult found = find_design(model, room.points, {.noise_m = 0.002});
    ASSERT_TRUE(found.found) << "seed " << seed << ": " << found.reason;
    EXPECT_FALSE(found.is_ambiguous()) << "seed " << seed;
    EXPECT_LT(off(model, room, found.best.T_design_scan), kOff) << "seed " << seed;
    EXPECT_EQ(found.scan_points, room.points.size());
    EXPECT_FALSE(found.was_thinned);
    EXPECT_GE(found.planes, 2);
    EXPECT_GT(found.best.coverage, 0.35);
  }
  for (unsigned seed = 1; seed <= 3; ++seed) {
    std::mt19937 random{seed};
    const Room room = test::make_room(test::tee_spool(), {.copies = 0}, random);
    const FindResult found = find_design(model, room.points, {.noise_m = 0.002});
    EXPECT_FALSE(found.found) << "seed " << seed << ": coverage " << found.best.coverage << ", "
                              << found.best.explained << " of chance " << found.best.chance;
    EXPECT_NE(found.reason.find("was not found"), std::string::npos) << found.reason;
  }
}

TEST(Finder, NamesBothOfTwoCopiesOrTheOneThatShowsMore) {
  const FinderModel model = test::finder_of(test::design_of(test::tee_spool()), 4000);
  std::mt19937 random{1};
  const Room room = test::make_room(test::tee_spool(), {.copies = 2}, random);
  const FindResult found = find_design(model, room.points, {.noise_m = 0.002});
  ASSERT_TRUE(found.found) << found.reason;
  EXPECT_LT(off(model, room, found.best.T_design_scan), kOff);
  // Whichever shows less is at least among what was looked at.
  bool has_other = false;
  for (const PoseEvidence& pose : found.tried)
    has_other = has_other ||
                (off(model, room, pose.T_design_scan) < kOff &&
                 test::pose_distance(model, pose.T_design_scan, found.best.T_design_scan) > 0.5);
  EXPECT_TRUE(has_other);
  for (const PoseEvidence& other : found.others)
    EXPECT_LT(off(model, room, other.T_design_scan), kOff);
}

// Nothing tells how a round bar is turned about itself or which end is which, and that is no reason
// not to find it. Where no end is seen, nothing says how far along it lies.
TEST(Finder, FindsASingleStraightPipeByAnEndThatIsSeen) {
  const std::vector<Rod> pipe = {{{0, 0, 0}, Eigen::Vector3d::UnitZ(), 0.06, 0.9}};
  const FinderModel model = test::finder_of(test::design_of(pipe), 4000);
  EXPECT_EQ(model.free_motions, 1);
  for (const auto& [seed, is_end_seen] : {std::pair{1U, true}, {5U, true}, {2U, false}}) {
    std::mt19937 random{seed};
    const Room room = test::make_room(pipe, {.with_pipes = false}, random);
    const FindResult found = find_design(model, room.points, {.noise_m = 0.002});
    ASSERT_EQ(found.found, is_end_seen) << seed << ": " << found.reason;
    if (!is_end_seen) continue;
    const Pose T = found.best.T_design_scan * room.T_scan_design[0];
    for (const double end : {0.0, 0.9}) {
      const Eigen::Vector3d p = T * Eigen::Vector3d(0, 0, end);
      EXPECT_LT(std::min(p.norm(), (p - Eigen::Vector3d(0, 0, 0.9)).norm()), kOff) << seed;
    }
    EXPECT_TRUE(found.is_ambiguous()) << "it may be turned end for end";
    for (const PoseEvidence& other : found.others)
      EXPECT_TRUE(model.are_symmetric(found.best.T_design_scan, other.T_design_scan)) << seed;
  }
}

// A design of millimetres and one of a plant: all lengths follow from the design's own.
TEST(Finder, FindsTheSameAtAnyScale) {
  for (const double scale : {0.01, 100.0}) {
    std::vector<Rod> rods = test::tee_spool();
    for (Rod& rod : rods) {
      rod.base *= scale;
      rod.radius *= scale;
      rod.length *= scale;
    }
    const FinderModel model = test::finder_of(test::design_of(rods), 3000);
    std::mt19937 random{3};
    const Pose T_true = test::random_motion(scale, 2, random);
    std::vector<Eigen::Vector3f> points =
        test::scan_of(rods, T_true.inverse(),
                      {.points = 6000, .noise_m = 0.001 * scale, .towards = {0.3, 1, 0.4}}, random)
            .points;
    const FindResult found = find_design(model, points, {.noise_m = 0.001 * scale});
    ASSERT_TRUE(found.found) << scale << ": " << found.reason;
    EXPECT_LT(test::pose_distance(model, found.best.T_design_scan, T_true), kOff * scale) << scale;
  }
}

}  // namespace
}  // namespace spool
