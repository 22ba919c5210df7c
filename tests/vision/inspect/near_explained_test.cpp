// What lies only near the design tells which of several joints in line went wrong.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <random>

#include <gtest/gtest.h>

#include "tests/vision/align/synthetic_spool.h"
#include "vision/inspect/chain_weigher.h"
#include "vision/inspect/explanation.h"

namespace spool {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr double kNoise = 0.001;  // m

// Three lengths along z, each thinner than the one before: by 10 mm, then by 5.
struct SteppedPipe {
  std::vector<test::Rod> rods{{{0, 0, 0}, Vector3d::UnitZ(), 0.05, 0.5},
                              {{0, 0, 0.5}, Vector3d::UnitZ(), 0.04, 0.1},
                              {{0, 0, 0.6}, Vector3d::UnitZ(), 0.035, 0.2}};
  DesignModel design = test::design_of(rods);
  Result<DesignSurface> surface = DesignSurface::build(design);
  SurfaceSamples samples = sample_surface(design, 4000);
  std::vector<JointBranch> tree;

  SteppedPipe() {
    design.parts[0].kind = design.parts[2].kind = PartKind::kPipe;
    design.parts[1].kind = PartKind::kReducer;
    tree = {branch(0, 1, 0.5F, {1, 2}), branch(1, 2, 0.6F, {2})};
  }

  static JointBranch branch(int near, int far, float z, std::vector<int> parts) {
    JointBranch branch;
    branch.joint = near;
    branch.part_near = near;
    branch.part_far = far;
    branch.frame = {{0, 0, z}, Vector3f::UnitZ()};
    branch.is_part.assign(3, 0);
    for (const int part : parts) branch.is_part[static_cast<std::size_t>(part)] = 1;
    branch.parts = std::move(parts);
    return branch;
  }

  // Pipe `longer` is 80 mm too long.
  [[nodiscard]] std::vector<Piece> pieces(std::size_t longer) const {
    std::vector<test::Rod> built = rods;
    built[longer].length += 0.08;
    for (std::size_t p = longer + 1; p < built.size(); ++p) built[p].base.z() += 0.08;
    std::mt19937 random{5};
    const PointCloud scan =
        test::scan_of(built, Pose::Identity(), {.points = 6000, .noise_m = kNoise}, random);
    const ExplainedDesign explained{design, *surface, samples};
    const ExplainedScan scanned{scan, kNoise, true};
    return moved_pieces(explained, scanned, explain_surface(explained, scanned), tree, 1);
  }
};

TEST(NearExplained, TellsTheJointThatWentWrong) {
  const SteppedPipe pipe;
  const auto first = pipe.pieces(0);
  ASSERT_EQ(first.size(), 1U);
  EXPECT_EQ(first[0].fault, PieceFault::kTooLong);
  EXPECT_EQ(first[0].part, 0) << "of the joints in line the one before the step";
  EXPECT_NEAR(first[0].amount, 0.08, 0.003);
}

// The same points, of which some lie well on the design or only near it.
TEST(NearExplained, IsWonByThePieceThatItLiesOn) {
  const SteppedPipe pipe;
  std::vector<test::Rod> moved(pipe.rods.begin() + 1, pipe.rods.end());
  for (test::Rod& rod : moved) rod.base.z() += 0.08;
  std::mt19937 random{6};
  const PointCloud scan = test::scan_of(
      moved, Pose::Identity(), {.points = 3000, .noise_m = kNoise, .with_ends = false}, random);
  std::vector<Vector3f> explained, left;
  std::vector<std::int32_t> part;
  for (const Vector3f& p : scan.points) {
    (p.z() < 0.8F ? explained : left).push_back(p);
    if (p.z() < 0.8F) part.push_back(p.z() < 0.6F ? 1 : 2);
  }
  const auto of_piece = static_cast<double>(explained.size());
  // The pipe that is too long, as far as it should go and beyond.
  const PointCloud pipe_points =
      test::scan_of({pipe.rods[0]}, Pose::Identity(),
                    {.points = 2000, .noise_m = kNoise, .with_ends = false}, random);
  explained.insert(explained.end(), pipe_points.points.begin(), pipe_points.points.end());
  part.resize(explained.size(), 0);
  const PointCloud excess =
      test::scan_of({{{0, 0, 0.5}, Vector3d::UnitZ(), 0.05, 0.08}}, Pose::Identity(),
                    {.points = 300, .noise_m = kNoise, .with_ends = false}, random);
  left.insert(left.end(), excess.points.begin(), excess.points.end());
  std::vector<PieceShape> shapes;
  for (const JointBranch& branch : pipe.tree) shapes.emplace_back(branch.is_part, pipe.samples);
  const ChainOptions options{.noise_m = kNoise, .size_m = 0.8};
  const ChainWeigher weigher(pipe.tree, shapes, pipe.design, pipe.samples, options);
  ChainMotion motion;
  motion.fault = PieceFault::kTooLong;
  motion.move.translation().z() = 0.08F;
  const auto gain = [&](std::uint8_t is_well) {
    const std::vector<std::uint8_t> well(explained.size(), is_well);
    const auto weighed = weigher.weigh({explained, part, well, left}, motion, 0.1);
    return weighed ? weighed->gain : 0.0;
  };
  EXPECT_GT(gain(1), 0.9 * static_cast<double>(left.size()));
  EXPECT_GT(gain(0) - gain(1), 0.9 * of_piece);
}

}  // namespace
}  // namespace spool
