// A pipe that is too long under its cap: the cap alone would hardly tell.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/inspect/pipe_end.h"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "tests/vision/align/synthetic_spool.h"
#include "vision/inspect/chain_motions.h"

namespace spool {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr float kRadius = 0.03F, kLength = 0.5F;  // m
constexpr double kCap = 0.04;                     // m, as thick as the pipe
constexpr double kSize = 0.6;                     // m

// A pipe along z with a cap on its end.
struct CappedPipe {
  std::vector<test::Rod> rods{{{0, 0, 0}, Vector3d::UnitZ(), kRadius, kLength},
                              {{0, 0, kLength}, Vector3d::UnitZ(), kRadius, kCap}};
  DesignModel design = test::design_of(rods);
  SurfaceSamples samples;
  JointBranch branch;

  CappedPipe() {
    design.parts[0].kind = PartKind::kPipe;
    design.parts[1].kind = PartKind::kCap;
    samples = sample_surface(design, 3000);
    branch.part_near = 0;
    branch.part_far = 1;
    branch.frame = {{0, 0, kLength}, Vector3f::UnitZ()};
    branch.parts = {1};
    branch.is_part = {0, 1};
  }

  // Of the cap, with the pipe `longer_m` longer than it should be.
  [[nodiscard]] std::vector<ChainMotion> motions(double longer_m) const {
    std::vector<test::Rod> built = rods;
    built[0].length += longer_m;
    built[1].base.z() += longer_m;
    std::mt19937 random{3};
    const PointCloud scan =
        test::scan_of(built, Pose::Identity(), {.points = 4000, .noise_m = 0.001}, random);
    const PieceShape shape(branch.is_part, samples);
    const auto end = pipe_end(design, branch, samples);
    return chain_motions({0, branch, shape, end}, Occupancy(scan.points, kRoughMotion * kSize),
                         kSize);
  }
};

TEST(PipeEnd, IsThePipeGoneOnBeyondTheJoint) {
  const CappedPipe pipe;
  const auto end = pipe_end(pipe.design, pipe.branch, pipe.samples);
  EXPECT_EQ(static_cast<std::ptrdiff_t>(end.size()),
            std::count(pipe.samples.part.begin(), pipe.samples.part.end(), 0));
  for (const PipeEndPoint& each : end) {
    EXPECT_NEAR(each.point.z(), kLength + each.along, 1e-5);
    EXPECT_LT(each.point.head<2>().norm(), kRadius + 1e-4F);
    EXPECT_LE(each.along, kLength + 1e-5F);
  }
  EXPECT_TRUE(std::is_sorted(
      end.begin(), end.end(),
      [](const PipeEndPoint& a, const PipeEndPoint& b) { return a.along < b.along; }));
}

TEST(PipeEnd, OfThePipeBehindTheJointIsWhereThatBegins) {
  CappedPipe pipe;
  pipe.design.parts[0].kind = PartKind::kElbow;
  EXPECT_TRUE(pipe_end(pipe.design, pipe.branch, pipe.samples).empty());
  pipe.design.parts[1].kind = PartKind::kPipe;
  const auto end = pipe_end(pipe.design, pipe.branch, pipe.samples);
  ASSERT_FALSE(end.empty());
  for (const PipeEndPoint& each : end) {
    EXPECT_NEAR(each.point.z(), kLength + each.along, 1e-5);
    EXPECT_LE(each.along, kCap + 1e-5);
  }
}

TEST(PipeEnd, TellsThatAPipeUnderACapIsTooLong) {
  const CappedPipe pipe;
  const auto motions = pipe.motions(0.08);
  const auto longer = std::find_if(motions.begin(), motions.end(), [](const ChainMotion& each) {
    return each.fault == PieceFault::kTooLong;
  });
  ASSERT_NE(longer, motions.end());
  EXPECT_NEAR(longer->move.translation().z(), 0.08, kRoughMotion * kSize);
  EXPECT_TRUE(pipe.motions(0).empty()) << "built as designed";
}

}  // namespace
}  // namespace spool
