// Of a depth image: a part that the camera saw through is missing, one that something hides is not.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "tests/vision/inspect/jointed_spool.h"
#include "vision/inspect/missing_parts.h"
#include "vision/inspector.h"

namespace spool {
namespace {

using test::jointed;
using namespace test;
using Eigen::Vector3d;

constexpr double kNoise = 0.001;

// A camera 2 m off that looks at the spool from beside and in front; a wall stands behind.
Pose T_design_camera() {
  const Vector3d eye(1.2, -1.8, 0.9), at(0.2, 0, 0.5);
  const Vector3d forward = (at - eye).normalized();
  const Vector3d right = forward.cross(Vector3d::UnitZ()).normalized();
  Pose T = Pose::Identity();
  T.linear() << right, forward.cross(right), forward;
  T.translation() = eye;
  return T;
}

std::vector<Rod> all_but(const std::vector<int>& gone) {
  std::vector<Rod> rods;
  for (int r = 0; r < 6; ++r)
    if (std::find(gone.begin(), gone.end(), r) == gone.end())
      rods.push_back(jointed().rods[static_cast<std::size_t>(r)]);
  return rods;
}

// A depth image of 240 x 180 of the rods, by sphere tracing; a ball may hide some.
PointCloud depth_image(const std::vector<Rod>& rods, const Vector3d& ball = {9, 9, 9}) {
  std::mt19937 random{3};
  std::normal_distribution<double> noise(0, kNoise);
  const Pose T = T_design_camera();
  PointCloud scan;
  for (int y = 0; y < 180; ++y)
    for (int x = 0; x < 240; ++x) {
      const Vector3d ray = Vector3d((x - 119.5) / 200, (y - 89.5) / 200, 1).normalized();
      double along = 0.3, left = 1;
      while (left > 1e-5 && along < 5) {
        const Vector3d p = T * (along * ray);
        left = std::min(0.8 - p.y(), (p - ball).norm() - 0.25);
        for (const Rod& rod : rods) left = std::min(left, distance_to(rod, p));
        along += left;
      }
      scan.points.emplace_back(((along + noise(random)) * ray).cast<float>());
    }
  return scan;
}

std::vector<MissingPart> missing_in(const PointCloud& scan) {
  const Pose T = T_design_camera();
  const PointCloud scan_design = moved(scan, T);
  const Explanation explanation =
      explain_surface(jointed().explained(), {scan_design, kNoise, false});
  const auto parts = summarise_parts(jointed().design, scan_design, explanation.declutter.classes,
                                     explanation.deviations, jointed().samples);
  const DesignInSight in_sight{Sight(scan.points), T.inverse().cast<float>(),
                               deviation_bound(kNoise)};
  return missing_parts(jointed().design,
                       {scan_design, explanation.declutter.classes, explanation.deviations},
                       jointed().samples, parts, in_sight);
}

TEST(MissingInSight, IsNothingOfASpoolThatIsThere) {
  EXPECT_TRUE(missing_in(depth_image(all_but({}))).empty());
}

TEST(MissingInSight, IsWhatTheCameraSawThrough) {
  for (const int part : {kTip, kEnd, kFoot}) {
    const auto missing = missing_in(depth_image(all_but({part})));
    ASSERT_EQ(missing.size(), 1U) << part;
    EXPECT_EQ(missing[0].part, part);
    EXPECT_TRUE(missing[0].is_seen_through);
  }
  // Also where what it hangs on is missing as well.
  EXPECT_EQ(missing_in(depth_image(all_but({kArm, kTip}))).size(), 2U);
}

TEST(MissingInSight, IsNotAPartOfWhichHalfIsThere) {
  std::vector<Rod> rods = all_but({});
  rods[kTip].length /= 2;
  EXPECT_TRUE(missing_in(depth_image(rods)).empty());
}

TEST(MissingInSight, IsNotWhatSomethingHides) {
  // Half way from the camera to the tip, which is or is not there.
  const Vector3d ball(0.85, -0.75, 0.95);
  EXPECT_TRUE(missing_in(depth_image(all_but({}), ball)).empty());
  EXPECT_TRUE(missing_in(depth_image(all_but({kTip}), ball)).empty());
}

TEST(MissingInSight, IsSaidByAnInspectionOfOneFrame) {
  const auto design = PreparedDesign::prepare(jointed().design);
  ASSERT_TRUE(design);
  InspectorOptions options;
  options.align = AlignMethod::kPose;
  options.T_design_scan = T_design_camera();
  options.T_design_scan->translation() += (*design)->model.origin;
  options.single_frame = true;
  const PointCloud scan = depth_image(all_but({kTip}));
  const auto inspection = Inspector(*design).process(scan, {.constant_m = kNoise}, options);
  ASSERT_TRUE(inspection);
  const auto missing =
      std::find_if(inspection->findings.begin(), inspection->findings.end(),
                   [](const Finding& finding) { return finding.kind == "missing"; });
  ASSERT_NE(missing, inspection->findings.end());
  EXPECT_EQ(missing->text, "tip is missing: the camera saw what lies behind its place.");
  const PartFinding& tip = inspection->parts[kTip];
  EXPECT_EQ(tip.status, Verdict::kSuspicious);
  EXPECT_EQ(tip.reason, missing->text);
}

}  // namespace
}  // namespace spool
