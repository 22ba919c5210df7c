// Tests of the drawing: its nodes and legs from ports and joints.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/measure/drawing.h"

#include <gtest/gtest.h>

#include "tests/vision/measure/two_flange_spool.h"

namespace spool {
namespace {

using test::two_flange_spool;

TEST(Drawing, HasANodeAFaceAndACentreAndALegBetween) {
  const DesignModel design = two_flange_spool();
  const Drawing drawing = drawing_of(design);
  ASSERT_EQ(drawing.nodes.size(), 3U);
  ASSERT_EQ(drawing.legs.size(), 2U);
  EXPECT_EQ(name_of(drawing.nodes[0], design), "flange_a/face");
  EXPECT_EQ(name_of(drawing.nodes[1], design), "elbow_1/centre");
  EXPECT_LT((drawing.nodes[1].point - Eigen::Vector3d(0, 0, 0.65)).norm(), 1e-12);
  for (const DrawingLeg& leg : drawing.legs) {
    EXPECT_NEAR(leg.length_m, 0.68, 1e-12);
    EXPECT_EQ(leg.pipes.size(), 1U);
    EXPECT_EQ(leg.parts.size(), 3U);
    EXPECT_EQ(leg.nps, 4);
  }
}

TEST(Drawing, AFreeEndIsANodeAndAPipeAloneALeg) {
  DesignModel design = two_flange_spool();
  design.joints.pop_back();  // flange_b is not joined
  const Drawing drawing = drawing_of(design);
  bool has_end = false;
  for (const DrawingNode& node : drawing.nodes)
    if (node.kind == NodeKind::kEnd) {
      has_end = has_end || name_of(node, design) == "pipe_2/out";
    }
  EXPECT_TRUE(has_end);
  design.joints.clear();
  design.parts = {design.parts[test::kPipe1]};
  const Drawing alone = drawing_of(design);
  ASSERT_EQ(alone.legs.size(), 1U);
  EXPECT_NEAR(alone.legs[0].length_m, 0.5, 1e-12);
  EXPECT_NEAR(alone.legs[0].direction.z(), 1, 1e-12);
}

TEST(Drawing, WithoutPortsOrWithPartsThatDoNotMeetThereIsNothingMadeUp) {
  DesignModel design = two_flange_spool();
  for (Part& part : design.parts) part.ports.clear();
  design.joints.clear();
  EXPECT_TRUE(drawing_of(design).legs.empty());
  DesignModel bent = two_flange_spool();
  bent.parts[test::kPipe1].ports[1].direction = Eigen::Vector3d(0.1, 0, 1).normalized();
  for (const DrawingLeg& leg : drawing_of(bent).legs)
    EXPECT_EQ(leg.pipes, std::vector<int>{test::kPipe2}) << "pipe_1 is no straight leg";
}

}  // namespace
}  // namespace spool
