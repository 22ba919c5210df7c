// Tests of the campaign's own dimensions: those of a spool laid out by hand, and of one part moved.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/campaign/built_truth.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tools/campaign/spool_router.h"
#include "tools/campaign/standard_sizes.h"

namespace spool::campaign {
namespace {

Assembly laid_out() {
  SpoolRouter router("spool", 4);
  router.start_with_flange();
  router.pipe(0.5);
  router.elbow(90, 0);
  router.pipe(0.4);
  router.flange();
  return router.assembly();
}

TEST(BuiltTruth, IsTheSumOfTheStandardsSizes) {
  const Assembly spool = laid_out();
  const BuiltTruth truth(spool);
  const StandardSizes& nps4 = sizes_of(4);
  EXPECT_NEAR(*truth.length("flange_1/face", "elbow_1/centre"),
              nps4.weld_neck + 0.5 + nps4.elbow_90, 1e-9);
  EXPECT_NEAR(*truth.length("elbow_1/centre", "flange_2/face"),
              nps4.weld_neck + 0.4 + nps4.elbow_90, 1e-9);
  EXPECT_NEAR(*truth.angle("pipe_1/axis", "pipe_2/axis"), std::numbers::pi / 2, 1e-9);
  EXPECT_NEAR(*truth.lean("pipe_2/axis", "flange_2/face"), 0, 1e-9);
  EXPECT_FALSE(truth.length("flange_1/face", "cap_1/in"));
}

TEST(BuiltTruth, FollowsTheWeldThatIsOff) {
  Assembly spool = laid_out();
  Member& last = spool.members.back();
  last.joint_error.rotate(Eigen::AngleAxisd(0.01, Eigen::Vector3d::UnitX()));
  last.joint_error.pretranslate(Eigen::Vector3d(0, 0, 0.004));
  Member& second_pipe = spool.members[3];
  second_pipe.joint_error.rotate(Eigen::AngleAxisd(0.02, Eigen::Vector3d::UnitY()));
  const BuiltTruth truth(spool);
  EXPECT_NEAR(*truth.lean("pipe_2/axis", "flange_2/face"), 0.01, 1e-9);
  EXPECT_NEAR(std::abs(*truth.angle("pipe_1/axis", "pipe_2/axis") - std::numbers::pi / 2), 0.02,
              1e-9);
  const StandardSizes& nps4 = sizes_of(4);
  // pipe_2 turned at the elbow's end passes elsewhere: the centre moves along pipe_1 by its arm.
  const double moved =
      *truth.length("flange_1/face", "elbow_1/centre") - (nps4.weld_neck + 0.5 + nps4.elbow_90);
  EXPECT_NEAR(std::abs(moved), nps4.elbow_90 * std::tan(0.02), 1e-6);
}

// A flange turned about its axis, and all turned about the datum's.
TEST(BuiltTruth, TurnsAreSeenFromTheDatumAndModuloThePitch) {
  const Assembly design = laid_out();
  const BuiltTruth drawn(design);
  const auto turned = [&](std::size_t member, double angle) {
    Assembly spool = design;
    spool.members[member].roll_rad += angle;
    return spool;
  };
  const auto turn = [&](const Assembly& spool, const std::string& from, const std::string& of) {
    return *BuiltTruth(spool).turn(drawn, "flange_1/face", from, of);
  };
  const std::string far = "flange_2/holes", node = "flange_2/face", holes = "flange_1/holes";
  for (const std::string& from : {holes, node}) {
    EXPECT_NEAR(turn(design, from, far), 0, 1e-9);
    EXPECT_NEAR(std::abs(turn(turned(4, 0.05), from, far)), 0.05, 1e-9);
    EXPECT_NEAR(std::abs(turn(turned(4, std::numbers::pi / 4 + 0.05), from, far)), 0.05, 1e-9)
        << "a pitch of eight holes is no turn";
  }
  // The sense is right-handed about the flange's z, which looks into the spool: as the roll about
  // the pipe's outward z, the other way round.
  EXPECT_NEAR(turn(turned(4, 0.05), holes, far), -0.05, 1e-9);
  // The first pipe carries all that follows: seen from it nothing but the datum has turned.
  EXPECT_NEAR(turn(turned(1, 0.05), node, far), 0, 1e-9);
  EXPECT_NEAR(std::abs(turn(turned(1, 0.05), node, holes)), 0.05, 1e-9);
  EXPECT_FALSE(BuiltTruth(design).turn(drawn, "flange_1/face", holes, "pipe_1/axis"));
}

}  // namespace
}  // namespace spool::campaign
