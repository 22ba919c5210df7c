// Each defect moves what it says, by what it says, and nothing else.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/campaign/defects.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "tools/campaign/clearance.h"
#include "tools/campaign/designs.h"

namespace spool::campaign {
namespace {

using Eigen::Vector3d;
constexpr double kDegree = std::numbers::pi / 180;
constexpr double kExact = 1e-12;  // m and rad: rounding of a chain of thirty poses

// A design with one defect done to it.
struct Built {
  Assembly design, as_built;
  std::vector<Defect> defects;
  std::vector<Pose> before, after;

  Built(const Assembly& of, const Defect& defect) : design(of), defects{defect} {
    as_built = with_defects(design, Random(1, 1), defects);
    before = poses_of(design);
    after = poses_of(as_built);
  }
  int index(const std::string& name) const {
    for (std::size_t i = 0; i < design.members.size(); ++i)
      if (design.members[i].spec.name == name) return static_cast<int>(i);
    return -1;
  }
  // How part i moved, in the design frame.
  Pose motion(std::size_t i) const { return after[i] * before[i].inverse(); }
  // Parts that hang on `part` moved by `expected`, all others not at all.
  void expect_only_followers_move(int part, const Pose& expected, bool itself = true) const {
    for (std::size_t i = 0; i < before.size(); ++i) {
      const bool follows =
          hangs_on(design, static_cast<int>(i), part) && (itself || static_cast<int>(i) != part);
      EXPECT_TRUE(motion(i).isApprox(follows ? expected : Pose::Identity(), kExact))
          << design.members[i].spec.name;
    }
  }
};

Assembly pipe_spool() { return design_of(ObjectKind::kPipeSpool3m, 4, false); }

TEST(Turned, MovesAllThatHangsOnTheElbowAboutItsInlet) {
  const Built built(pipe_spool(), {.kind = DefectKind::kTurned, .amount = 90, .part = "elbow_1"});
  const int elbow = built.index("elbow_1");
  const Pose& pose = built.before[static_cast<std::size_t>(elbow)];
  const Vector3d inlet = pose.translation();
  const Vector3d axis = pose.linear().col(2);
  Pose expected = Pose::Identity();
  expected.rotate(Eigen::AngleAxisd(90 * kDegree, axis));
  expected.pretranslate(inlet - expected.linear() * inlet);
  built.expect_only_followers_move(elbow, expected);
  EXPECT_FALSE(built.after.back().isApprox(built.before[4], 0.1));
}

TEST(Long, ShiftsWhatFollowsAlongThePipe) {
  const Built built(pipe_spool(), {.kind = DefectKind::kLong, .amount = 37, .part = "pipe_2"});
  const int pipe = built.index("pipe_2");
  const Vector3d along = built.before[static_cast<std::size_t>(pipe)].linear().col(2);
  built.expect_only_followers_move(pipe, Pose(Eigen::Translation3d(0.037 * along)), false);
  const auto at = static_cast<std::size_t>(pipe);
  EXPECT_NEAR(built.as_built.members[at].spec.length_m,
              built.design.members[at].spec.length_m + 0.037, kExact);
}

TEST(Swapped, PutsEachBranchOnTheOthersPort) {
  const Built built(pipe_spool(), {.kind = DefectKind::kSwapped});
  ASSERT_EQ(built.defects.size(), 1U);
  const int a = built.index(built.defects[0].part);
  const int b = built.index(built.defects[0].other);
  ASSERT_GE(a, 0);
  ASSERT_GE(b, 0);
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  EXPECT_EQ(built.design.members[at(a)].spec.nps, built.design.members[at(b)].spec.nps);
  // A pipe's own frame is its inlet: each stands where the other stood.
  EXPECT_TRUE(built.after[at(a)].isApprox(built.before[at(b)], kExact));
  EXPECT_TRUE(built.after[at(b)].isApprox(built.before[at(a)], kExact));
  for (std::size_t i = 0; i < built.before.size(); ++i) {
    const int part = static_cast<int>(i);
    Pose expected = Pose::Identity();
    if (hangs_on(built.design, part, a)) expected = built.motion(at(a));
    if (hangs_on(built.design, part, b)) expected = built.motion(at(b));
    EXPECT_TRUE(built.motion(i).isApprox(expected, 1e-10)) << built.design.members[i].spec.name;
  }
}

TEST(Missing, LeavesAHoleAndMovesNothing) {
  const Built built(pipe_spool(), {.kind = DefectKind::kMissing});
  ASSERT_EQ(built.defects.size(), 1U);
  built.expect_only_followers_move(-1, Pose::Identity());
  int missing = 0;
  for (const Member& member : built.as_built.members) {
    if (!member.missing) continue;
    ++missing;
    EXPECT_EQ(member.spec.kind, PartKind::kFlange);
    EXPECT_EQ(member.spec.name, built.defects[0].part);
  }
  EXPECT_EQ(missing, 1);
}

TEST(Extra, StandsOnItsHostAndMovesNothing) {
  const Built built(pipe_spool(), {.kind = DefectKind::kExtra});
  built.expect_only_followers_move(-1, Pose::Identity());
  ASSERT_GT(built.as_built.members.size(), built.design.members.size());
  const std::size_t extra = built.design.members.size();
  const auto host = static_cast<std::size_t>(built.index(built.defects[0].part));
  // It starts on the host's axis, within its length, and leaves it at a right angle.
  const Pose T_host_extra = built.after[host].inverse() * built.after[extra];
  EXPECT_NEAR(T_host_extra.translation().head<2>().norm(), 0, kExact);
  EXPECT_GT(T_host_extra.translation().z(), 0);
  EXPECT_LT(T_host_extra.translation().z(), built.design.members[host].spec.length_m);
  EXPECT_NEAR(T_host_extra.linear().col(2).z(), 0, kExact);
}

TEST(Tilted, LeansOneFlangeByItsAngleAboutItsWeld) {
  const Built built(pipe_spool(), {.kind = DefectKind::kTilted, .amount = 2, .part = "flange_2"});
  const int flange = built.index("flange_2");
  const auto at = static_cast<std::size_t>(flange);
  const Pose moved = built.motion(at);
  EXPECT_NEAR(Eigen::AngleAxisd(moved.linear()).angle(), 2 * kDegree, 1e-9);
  const Eigen::Vector3d weld = ports_of(built.design.members[at].spec)[1].T_part_port.translation();
  EXPECT_LT((built.after[at] * weld - built.before[at] * weld).norm(), kExact);
  // The axis leans by the whole angle: none of it is a turn of the holes.
  EXPECT_NEAR(built.after[at].linear().col(2).dot(built.before[at].linear().col(2)),
              std::cos(2 * kDegree), 1e-12);
  built.expect_only_followers_move(flange, moved);
}

TEST(Clocked, TurnsTheHolesByHalfTheirPitch) {
  const Built built(pipe_spool(), {.kind = DefectKind::kClocked, .part = "flange_2"});
  const auto at = static_cast<std::size_t>(built.index("flange_2"));
  EXPECT_EQ(built.defects[0].amount, 22.5);  // eight holes
  const Pose moved = built.before[at].inverse() * built.after[at];
  EXPECT_NEAR(moved.translation().norm(), 0, kExact);
  EXPECT_NEAR(std::abs(moved.linear()(2, 2)), 1, kExact);
  EXPECT_NEAR(Eigen::AngleAxisd(moved.linear()).angle(), 22.5 * kDegree, 1e-9);
}

TEST(Offset, WeldsOnAside) {
  const Built built(pipe_spool(), {.kind = DefectKind::kOffset, .amount = 4, .part = "pipe_4"});
  const int pipe = built.index("pipe_4");
  const Pose moved = built.motion(static_cast<std::size_t>(pipe));
  EXPECT_NEAR(moved.translation().norm(), 0.004, 1e-9);
  const Vector3d axis = built.before[static_cast<std::size_t>(pipe)].linear().col(2);
  EXPECT_NEAR(moved.translation().dot(axis), 0, 1e-9);
  built.expect_only_followers_move(pipe, Pose(Eigen::Translation3d(moved.translation())));
}

TEST(Defects, AreTakenOutWhereNothingFits) {
  std::vector<Defect> defects = {{.kind = DefectKind::kTurned}, {.kind = DefectKind::kMissing}};
  const Assembly frame = design_of(ObjectKind::kBoxFrame, 1, true);
  const Assembly as_built = with_defects(frame, Random(1, 1), defects);
  ASSERT_EQ(defects.size(), 1U);
  EXPECT_EQ(defects[0].kind, DefectKind::kMissing);
  EXPECT_FALSE(as_built.members.front().missing);
}

TEST(Designs, DoNotRunIntoThemselves) {
  for (std::uint32_t seed = 1; seed <= 60; ++seed)
    for (const ObjectKind kind : {ObjectKind::kPipeSpool3m, ObjectKind::kSmallSpool,
                                  ObjectKind::kFourBranch, ObjectKind::kRandomSpool})
      EXPECT_FALSE(collides(design_of(kind, seed, false), 0.01))
          << static_cast<int>(kind) << " " << seed;
}

TEST(Designs, HaveTheSizesThatTheyAreNamedFor) {
  const auto size = [](ObjectKind kind, std::uint32_t seed) {
    Vector3d sides = bounds_of(design_of(kind, seed, true)).sizes();
    std::sort(sides.data(), sides.data() + 3);
    return sides;
  };
  std::set<int> lengths;
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    // Lengths vary by 7 % (10 % of the small one's).
    const Vector3d ps = size(ObjectKind::kPipeSpool3m, seed);
    EXPECT_LT((ps - Vector3d(0.5, 1.9, 2.85)).cwiseAbs().maxCoeff(), 0.3) << ps.transpose();
    const Vector3d bf = size(ObjectKind::kBoxFrame, seed);
    EXPECT_LT((bf - Vector3d(2, 2, 3.5)).cwiseAbs().maxCoeff(), 0.12) << bf.transpose();
    const Vector3d four = size(ObjectKind::kFourBranch, seed);
    EXPECT_LT((four.tail<2>() - Eigen::Vector2d(1.5, 2)).cwiseAbs().maxCoeff(), 0.4)
        << four.transpose();
    EXPECT_LT(size(ObjectKind::kSmallSpool, seed).maxCoeff(), 0.65);
    lengths.insert(static_cast<int>(1000 * ps[2]));
  }
  EXPECT_GT(lengths.size(), 15U);  // every seed another
}

}  // namespace
}  // namespace spool::campaign
