// Motions that map a design onto itself: those of figures whose groups are known.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/campaign/symmetry.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/tools/campaign/solid_distance.h"
#include "tools/campaign/designs.h"
#include "tools/campaign/spool_router.h"

namespace spool::campaign {
namespace {

using Eigen::Vector3d;

TEST(Symmetry, OfThePlainFrameIsThatOfASquarePrism) {
  const Assembly frame = design_of(ObjectKind::kBoxFrame, 2, false);
  const auto motions = symmetries_of(frame);
  ASSERT_EQ(motions.size(), 8U);
  EXPECT_TRUE(motions.front().isApprox(Pose::Identity()));
  // Points on the frame stay on it, by a formula that knows nothing of corners.
  const std::vector<Pose> poses = poses_of(frame);
  Random random(1, 1);
  for (const Pose& motion : motions) {
    EXPECT_NEAR(motion.linear().determinant(), 1, 1e-12);
    for (std::size_t i = 0; i < poses.size(); ++i)
      for (const Patch& patch : patches_of(frame.members[i].spec)) {
        const auto local = sample(patch, random);
        if (!local) continue;
        const Vector3d moved = motion * poses[i] * patch.T_part_patch * *local;
        double nearest = 1e9;
        for (std::size_t k = 0; k < poses.size(); ++k)
          nearest = std::min(nearest, std::abs(test::solid_distance(frame.members[k].spec,
                                                                    poses[k].inverse() * moved)));
        EXPECT_LT(nearest, 1e-9);
      }
  }
}

TEST(Symmetry, IsBrokenByABrace) {
  EXPECT_EQ(symmetries_of(design_of(ObjectKind::kBoxFrame, 2, true)).size(), 1U);
}

TEST(Symmetry, OfASpoolWithBranchesIsNone) {
  EXPECT_EQ(symmetries_of(design_of(ObjectKind::kPipeSpool3m, 2, false)).size(), 1U);
  EXPECT_EQ(symmetries_of(design_of(ObjectKind::kFourBranch, 2, false)).size(), 1U);
}

TEST(Symmetry, OfAPipeBetweenTwoFlangesCountsTheirHoles) {
  SpoolRouter r("straight", 2);
  r.start_with_flange();
  r.pipe(0.5);
  r.flange();
  // Four holes: four turns about the axis, and end for end four half turns across it.
  EXPECT_EQ(symmetries_of(r.assembly()).size(), 8U);
}

TEST(Symmetry, OfABendWithLikeLegsIsAHalfTurn) {
  SpoolRouter r("bend", 3);
  r.start_with_flange();
  r.pipe(0.3);
  r.elbow(90, 0);
  r.pipe(0.3);
  r.flange();
  EXPECT_EQ(symmetries_of(r.assembly()).size(), 2U);
}

}  // namespace
}  // namespace spool::campaign
