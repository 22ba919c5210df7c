// A part is missing where its neighbours show and it does not, and only there.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/inspect/missing_parts.h"

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "tests/vision/inspect/jointed_spool.h"

namespace spool {
namespace {

using Eigen::Vector3d;
using test::jointed;
using test::JointedSpool;
using test::kEnd;
using test::kTip;

constexpr double kNoise = 0.001;  // m
const std::vector<bool> kAll(6, true);

std::vector<int> missing_in(const PointCloud& scan, const std::vector<Piece>& pieces = {}) {
  const JointedSpool& spool = jointed();
  const Explanation explanation = explain_surface(spool.explained(), {scan, kNoise, true});
  const auto parts = summarise_parts(spool.design, scan, explanation.declutter.classes,
                                     explanation.deviations, spool.samples);
  std::vector<int> missing;
  for (const MissingPart& it : missing_parts(
           spool.design, {scan, explanation.declutter.classes, explanation.deviations, pieces},
           spool.samples, parts)) {
    EXPECT_FALSE(it.is_seen_through) << "no camera";
    missing.push_back(it.part);
  }
  return missing;
}

TEST(MissingParts, AreThoseThatDoNotShowWhereTheirNeighboursDo) {
  EXPECT_TRUE(missing_in(jointed().scan(jointed().as_designed(), kAll)).empty());
  EXPECT_EQ(
      missing_in(jointed().scan(jointed().as_designed(), {true, true, true, false, true, true})),
      std::vector<int>{kTip});
  // Of a piece that was not scanned at all nobody can say that it is missing beyond its first part.
  EXPECT_EQ(
      missing_in(jointed().scan(jointed().as_designed(), {true, true, false, false, true, true})),
      std::vector<int>{});
}

// The scan less the points for which `is_gone` holds.
template <class IsGone>
PointCloud cut(const PointCloud& scan, const IsGone& is_gone) {
  PointCloud left;
  for (std::size_t i = 0; i < scan.size(); ++i) {
    if (is_gone(scan.points[i])) continue;
    left.points.push_back(scan.points[i]);
    left.normals.push_back(scan.normals[i]);
  }
  return left;
}

// Nobody knows what the scanner looked at: that a length of the spool was left out elsewhere says
// that the part may have been as well.
TEST(MissingParts, AreNotNamedWhereTheScanLeavesOutMore) {
  const PointCloud scan =
      jointed().scan(jointed().as_designed(), {true, true, true, false, true, true});
  const auto from_half_of_the_side = [](const Eigen::Vector3f& p) {
    return p.z() > 0.36F && p.y() < -0.2F && p.y() > -0.4F;
  };
  EXPECT_TRUE(missing_in(cut(scan, from_half_of_the_side)).empty());
  // What only looks away from a scanner is no gap: here half of all that lies along x or y.
  const auto from_below = [](const Eigen::Vector3f& p) {
    const bool is_arm = p.z() > 0.75F && p.x() > 0.05F;
    const bool is_side = p.y() < -0.05F && p.z() > 0.36F;
    return (is_arm && p.z() < 0.8F) || (is_side && p.z() < 0.4F);
  };
  EXPECT_EQ(missing_in(cut(scan, from_below)), std::vector<int>{kTip});
}

TEST(MissingParts, AreNamedWhereWhatElseDoesNotShowIsElsewhere) {
  const JointedSpool& spool = jointed();
  const PointCloud scan = spool.scan(spool.as_designed(), {true, true, true, false, true, false});
  EXPECT_TRUE(missing_in(scan).empty());
  Piece end;
  end.parts = {kEnd};
  EXPECT_EQ(missing_in(scan, {end}), std::vector<int>{kTip});
}

TEST(MissingParts, AreNotVouchedForByTheEndOfAPipe) {
  // A short end, of which a good part lies near the pipe that it should be welded to.
  const JointedSpool& spool = jointed();
  PointCloud scan = spool.scan(spool.as_designed(), {true, true, true, true, true, false});
  std::mt19937 random{5};
  const test::Rod pipe_end{{0, -0.45, 0.37}, -Vector3d::UnitZ(), 0.03, 0.01};
  const PointCloud more =
      test::scan_of({pipe_end}, Pose::Identity(), {.points = 60, .noise_m = kNoise}, random);
  scan.points.insert(scan.points.end(), more.points.begin(), more.points.end());
  scan.normals.insert(scan.normals.end(), more.normals.begin(), more.normals.end());
  EXPECT_EQ(missing_in(scan), std::vector<int>{kEnd});
}

TEST(MissingParts, AreNotVouchedForByWhatStandsThere) {
  // A post beside the place of the tip, to a centimetre; without normals its near side is
  // explained.
  const JointedSpool& spool = jointed();
  const auto with_post = [&](bool has_tip) {
    PointCloud scan = spool.scan(spool.as_designed(), {true, true, true, has_tip, true, true});
    std::mt19937 random{6};
    const test::Rod post{{0.6, 0.05, 0}, Vector3d::UnitZ(), 0.02, 1.3};
    const PointCloud more =
        test::scan_of({post}, Pose::Identity(), {.points = 2500, .noise_m = kNoise}, random);
    scan.points.insert(scan.points.end(), more.points.begin(), more.points.end());
    scan.normals.clear();
    return scan;
  };
  EXPECT_EQ(missing_in(with_post(false)), std::vector<int>{kTip});
  EXPECT_TRUE(missing_in(with_post(true)).empty());
}

TEST(MissingParts, AreNotVouchedForByWhatReachesThroughTheirSurface) {
  // A cradle's top: nowhere further than 18 mm from where the tip's surface would be.
  PointCloud scan = jointed().scan(jointed().as_designed(), {true, true, true, false, true, true});
  std::mt19937 random{8};
  std::uniform_real_distribution<float> unit(0, 1);
  for (int i = 0; i < 250; ++i) {
    const float angle = unit(random), off = 0.033F * unit(random), z = 0.86F + 0.3F * unit(random);
    const Eigen::Vector3f out(std::cos(angle), std::sin(angle), 0);
    scan.points.emplace_back(Eigen::Vector3f(0.6F, 0, z) + (0.015F + off) * out);
  }
  scan.normals.clear();
  EXPECT_EQ(missing_in(scan), std::vector<int>{kTip});
}

}  // namespace
}  // namespace spool
