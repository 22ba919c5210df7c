// The centre lines of a design, and the lengths of their legs against what the file says.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/guide/centre_line.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/refusal.h"
#include "tests/vision/guide/random_spool.h"
#include "tests/vision/guide/small_spool.h"
#include "tests/vision/piping/pcf_samples.h"
#include "vision/design/pipework_design.h"
#include "vision/guide/isometric_dimensions.h"
#include "vision/piping/pcf_reader.h"

namespace spool::test {
namespace {

DesignModel design_from(const std::string& text) {
  const auto pipework = piping::read_pcf(text, "test.pcf");
  EXPECT_TRUE(pipework) << (pipework ? "" : pipework.error().message);
  DesignModel design;
  design.path = "test.pcf";
  const Status built = design_of(*pipework, design);
  EXPECT_TRUE(built);
  return design;
}

// Lengths in whole tenths of a millimetre, sorted: the files are written to that or better.
std::vector<long> legs_of(const DesignModel& design) {
  const auto line = guide::centre_line(design, {});
  EXPECT_TRUE(line);
  std::vector<long> legs;
  for (const auto& each : guide::leg_lengths(design, *line))
    legs.push_back(std::lround(10000 * each.length_m));
  std::sort(legs.begin(), legs.end());
  return legs;
}

TEST(CentreLine, LegsOfTheSmallSpoolAreThoseWrittenDown) {
  // Face to tee 581, tee to face 1081, tee to corner 557 - 0 (its centre) and corner to the end
  // 352.
  EXPECT_EQ(legs_of(small_spool()), (std::vector<long>{3520, 5570, 5810, 10810}));
}

TEST(CentreLine, LegsOfAFileAreItsCoordinates) {
  // Read off the sample by hand: face to corner 500, corner to tee 500, tee to reducer 86, reducer
  // 89, to the olet 100, olet to corner 134.9 and its own 53.9, the branch to its cap 276.
  const std::vector<long> legs = legs_of(design_from(spool_pcf()));
  for (const long leg : {860L, 890L, 1000L, 2760L, 5000L})
    EXPECT_NE(std::find(legs.begin(), legs.end(), leg), legs.end()) << leg;
  EXPECT_EQ(std::count(legs.begin(), legs.end(), 5000L), 2);
}

TEST(CentreLine, InchesAndMillimetresGiveTheSameLegs) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const auto mm = legs_of(design_from(random_spool_pcf({.seed = seed})));
    const auto inch = legs_of(design_from(random_spool_pcf({.seed = seed, .inches = true})));
    ASSERT_EQ(mm.size(), inch.size());
    for (std::size_t k = 0; k < mm.size(); ++k)
      EXPECT_LE(std::abs(mm[k] - inch[k]), 1) << mm[k];  // the last digit
  }
}

TEST(CentreLine, SkewLegsAreTold) {
  const DesignModel design = design_from(random_spool_pcf({.seed = 1}));
  const auto line = guide::centre_line(design, {});
  ASSERT_TRUE(line);
  int skew = 0;
  for (const auto& run : line->runs) {
    if (!run.is_skew) continue;
    ++skew;
    EXPECT_NEAR(run.direction.cwiseAbs().maxCoeff(), std::sqrt(0.5), 1e-4);  // offsets at 45
  }
  EXPECT_EQ(skew, 2);  // of seed 1: two offsets of two 45s each
}

TEST(CentreLine, KeepsTheFilesCoordinates) {
  DesignModel design = design_from(random_spool_pcf({.seed = 1}));
  design.origin += Eigen::Vector3d(5000, 7, -3000);  // east, up, south: a plant's far corner
  const auto line = guide::centre_line(design, {});
  ASSERT_TRUE(line);
  const bool starts = std::any_of(line->nodes.begin(), line->nodes.end(), [](const auto& node) {
    return node.open_part >= 0 && (node.place - Eigen::Vector3d(5001, 3002, 7.5)).norm() < 1e-6;
  });
  EXPECT_TRUE(starts) << "the first flange's face is at 1000 2000 500 of the file";
}

TEST(CentreLine, OfADesignWithoutPortsIsRefused) {
  DesignModel bare;
  bare.path = "bare.stl";
  bare.parts.emplace_back();
  expect_refused(guide::centre_line(bare, {}), ErrorCode::kBadInput, "bare.stl",
                 "does not say what its parts are");
}

}  // namespace
}  // namespace spool::test
