// What lies in one line is one run, across tees and pipes; an elbow is of neither.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/find/straight_runs.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/vision/align/synthetic_spool.h"

namespace spool {
namespace {

using Eigen::Vector3d;

Part part_with(std::vector<Port> ports) {
  Part part;
  part.ports = std::move(ports);
  return part;
}

// A pipe, a tee in line with it, a pipe on, an elbow, a pipe at right angles; a branch on the tee.
DesignModel run_of_parts() {
  const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY();
  DesignModel design = test::design_of({{{0, 0, 0}, x, 0.05, 3}});  // for its size
  design.parts = {part_with({{"out", x, x}}),
                  part_with({{"in", x, -x}, {"out", 1.2 * x, x}, {"up", 1.1 * x + 0.1 * y, y}}),
                  part_with({{"in", 1.2 * x, -x}, {"out", 2 * x, x}}),
                  part_with({{"in", 2 * x, -x}, {"out", 2.1 * x + 0.1 * y, y}}),
                  part_with({{"in", 2.1 * x + 0.1 * y, -y}}),
                  part_with({{"in", 1.1 * x + 0.1 * y, -y}})};
  const auto join = [&](int a, int port_a, int b, int port_b) {
    Joint joint;
    joint.part_a = a;
    joint.port_a = port_a;
    joint.part_b = b;
    joint.port_b = port_b;
    design.joints.push_back(joint);
  };
  join(0, 0, 1, 0);
  join(1, 1, 2, 0);
  join(2, 1, 3, 0);
  join(3, 1, 4, 0);
  join(1, 2, 5, 0);
  return design;
}

TEST(StraightRuns, GoThroughTees) {
  const StraightRuns runs = straight_runs(run_of_parts());
  EXPECT_EQ(runs.count, 3);
  ASSERT_EQ(runs.of_part.size(), 6U);
  EXPECT_EQ(runs.of_part[0], runs.of_part[1]);
  EXPECT_EQ(runs.of_part[0], runs.of_part[2]);
  EXPECT_EQ(runs.of_part[3], -1);
  EXPECT_NE(runs.of_part[4], runs.of_part[0]);
  EXPECT_NE(runs.of_part[5], runs.of_part[0]);
  EXPECT_NE(runs.of_part[5], runs.of_part[4]);
  ASSERT_EQ(runs.lines.size(), 3U);
  const auto along = [&](int part, const Vector3d& axis) {
    const auto run = static_cast<std::size_t>(runs.of_part[static_cast<std::size_t>(part)]);
    return std::abs(double{runs.lines[run].direction.dot(axis.cast<float>())});
  };
  EXPECT_NEAR(along(0, Vector3d::UnitX()), 1, 1e-6);
  EXPECT_NEAR(along(4, Vector3d::UnitY()), 1, 1e-6);
  // A tee is on the branch's run as well, an elbow on both that it joins.
  EXPECT_EQ(runs.at[0], std::vector<int>{runs.of_part[0]});
  EXPECT_EQ(runs.at[1], (std::vector<int>{runs.of_part[0], runs.of_part[5]}));
  EXPECT_EQ(runs.at[3], (std::vector<int>{runs.of_part[0], runs.of_part[4]}));
}

TEST(StraightRuns, APartWithoutAJointIsOneByItself) {
  DesignModel design = run_of_parts();
  design.joints.clear();
  const StraightRuns runs = straight_runs(design);
  EXPECT_EQ(runs.count, 6);
  EXPECT_EQ(runs.of_part, (std::vector<int>{0, 1, 2, 3, 4, 5}));
  for (const RunLine& line : runs.lines) EXPECT_TRUE(line.direction.isZero());
}

}  // namespace
}  // namespace spool
