// What speaks for the true pose, for a wrong one and amid clutter.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/find/pose_evidence.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

#include "tests/vision/find/room.h"

namespace spool {
namespace {

using Eigen::Vector3f;

constexpr double kGate = 0.006;  // m; three times the noise

const FinderModel& tee() {
  static const FinderModel model = test::finder_of(test::design_of(test::tee_spool()), 4000);
  return model;
}

std::vector<Vector3f> seen_from(const Eigen::Vector3d& towards) {
  std::mt19937 random{1};
  return test::scan_of(test::tee_spool(), Pose::Identity(),
                       {.points = 8000, .noise_m = 0.002, .towards = towards}, random)
      .points;
}

PoseEvidence weigh(const std::vector<Vector3f>& scan, const Pose& T) {
  const FindScene scene(tee(), scan, 0.002, {});
  const PoseEvidence evidence = weigh_pose(tee(), scene, T.cast<float>(), kGate);
  EXPECT_LE(evidence.explained, scene.points().size());
  EXPECT_TRUE(std::is_sorted(evidence.points.begin(), evidence.points.end()));
  EXPECT_EQ(std::accumulate(evidence.per_part.begin(), evidence.per_part.end(), 0U),
            evidence.explained);
  return evidence;
}

TEST(PoseEvidence, CoversWhatIsSeen) {
  const PoseEvidence all = weigh(seen_from(Eigen::Vector3d::Zero()), Pose::Identity());
  EXPECT_GT(all.coverage, 0.9);  // pipe ends inside each other are the design's, and unseen
  EXPECT_EQ(all.free_motions, 0);
  EXPECT_LT(all.chance, 0.05 * static_cast<double>(all.explained));
  // A mean of a cell's few readings of 2 mm, across surfaces of every slope.
  EXPECT_GT(all.scale_m, 0.0005);
  EXPECT_LT(all.scale_m, 0.0025);
  const PoseEvidence half = weigh(seen_from({0.3, 1, 0.4}), Pose::Identity());
  EXPECT_GT(half.coverage, 0.35);  // normals within 78 degrees of the view: under half
  EXPECT_LT(half.coverage, 0.65);
  EXPECT_EQ(half.free_motions, 0);
}

TEST(PoseEvidence, FallsAsThePoseLeavesTheTruth) {
  const std::vector<Vector3f> scan = seen_from({0.3, 1, 0.4});
  double before = 1e9;
  for (const double shift : {0.0, 0.01, 0.03, 0.3}) {
    Pose T = Pose::Identity();
    T.translation() = shift * Eigen::Vector3d(0.5, 0.7, 0.5);
    const PoseEvidence evidence = weigh(scan, T);
    EXPECT_LT(evidence.excess(), 0.8 * before) << shift;
    before = std::max(1.0, evidence.excess());
  }
}

TEST(PoseEvidence, CountsClutterThatHappensToLieThere) {
  std::vector<Vector3f> noise;
  std::mt19937 random{2};
  std::uniform_real_distribution<float> unit(-0.2F, 1.0F);
  for (int i = 0; i < 200000; ++i) {
    const float x = unit(random), y = unit(random), z = unit(random);
    noise.emplace_back(x, 0.3F * y, z);
  }
  const PoseEvidence evidence = weigh(noise, Pose::Identity());
  EXPECT_GT(evidence.explained, 300U);
  // Even clutter: the layer round the surface foretells what lies on it, to a third (curvature, and
  // surfaces nearer to each other than the layer is thick).
  EXPECT_NEAR(evidence.chance, static_cast<double>(evidence.explained),
              0.35 * static_cast<double>(evidence.explained));
  EXPECT_GT(evidence.free_motions, 0) << "what chance holds is not held";
}

// Two pipes that meet at a right angle; the joint says which way each runs.
FinderModel corner() {
  using Eigen::Vector3d;
  const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY();
  DesignModel design = test::design_of({{{0, 0, 0}, x, 0.05, 0.6}, {{0.6, 0.05, 0}, y, 0.05, 0.5}});
  design.parts[0].ports = {{"out", design.parts[0].T_design_part.inverse() * Vector3d(0.6, 0, 0),
                            design.parts[0].T_design_part.linear().transpose() * x}};
  design.parts[1].ports = {{"in", design.parts[1].T_design_part.inverse() * Vector3d(0.6, 0.05, 0),
                            design.parts[1].T_design_part.linear().transpose() * -y}};
  Joint joint;
  joint.part_a = joint.port_a = joint.port_b = 0;
  joint.part_b = 1;
  design.joints = {joint};
  return test::finder_of(design, 4000);
}

TEST(PoseEvidence, SaysOfWhichPartsAStopShows) {
  const FinderModel model = corner();
  ASSERT_EQ(model.runs.count, 2);
  // What a scan shows that sees nothing of what looks along an axis.
  const auto held = [&](const std::vector<Vector3f>& blind) {
    std::vector<Vector3f> scan;
    for (std::size_t i = 0; i < model.samples.size(); ++i)
      if (std::none_of(blind.begin(), blind.end(), [&](const Vector3f& axis) {
            return std::abs(axis.dot(model.samples.normals[i])) > 0.9F;
          }))
        scan.push_back(model.samples.points[i]);
    const FindScene scene(model, scan, 0.002, {});
    return weigh_pose(model, scene, Eigen::Isometry3f::Identity(), kGate).shows_stop;
  };
  using Held = std::vector<std::uint8_t>;
  const Vector3f x = Vector3f::UnitX(), y = Vector3f::UnitY();
  EXPECT_EQ(held({}), (Held{1, 1}));
  EXPECT_EQ(held({y}), (Held{1, 0}));
  EXPECT_EQ(held({x, y}), (Held{0, 0}));
}

TEST(PoseEvidence, TakesFewPointsOnAStopForTheEndOfSomethingElse) {
  // Of what looks along y, the end of the second pipe, one point in so many; of all else
  // everything.
  const FinderModel model = corner();
  const auto shows = [&](std::size_t one_in) {
    std::vector<Vector3f> scan;
    std::size_t on = 0;
    for (std::size_t i = 0; i < model.samples.size(); ++i)
      if (std::abs(model.samples.normals[i].y()) < 0.9F || ++on % one_in == 0)
        scan.push_back(model.samples.points[i]);
    const FindScene scene(model, scan, 0.002, {});
    return weigh_pose(model, scene, Eigen::Isometry3f::Identity(), kGate).shows_stop;
  };
  EXPECT_EQ(shows(2), (std::vector<std::uint8_t>{1, 1}));
  EXPECT_EQ(shows(6), (std::vector<std::uint8_t>{1, 0}));
}

TEST(PoseEvidence, OfNothingIsNothing) {
  for (const auto& scan :
       {std::vector<Vector3f>{}, std::vector<Vector3f>(5, Vector3f(0.05F, 0, 0.2F)),
        std::vector<Vector3f>(500, Vector3f(9, 9, 9))}) {
    const PoseEvidence evidence = weigh(scan, Pose::Identity());
    EXPECT_LT(evidence.explained, 8U);
    EXPECT_EQ(evidence.coverage, 0);
    EXPECT_EQ(evidence.free_motions, 6);
  }
}

TEST(FindScene, CountsWhatIsFiniteAndThinsWhatIsTooMuch) {
  std::vector<Vector3f> scan = seen_from(Eigen::Vector3d::Zero());
  const std::size_t finite = scan.size();
  scan.resize(3 * finite, Vector3f::Constant(std::numeric_limits<float>::quiet_NaN()));
  const FindScene scene(tee(), scan, 0.002, {});
  EXPECT_EQ(scene.finite(), finite);
  EXPECT_FALSE(scene.was_thinned());
  EXPECT_TRUE(scene.planes().empty());
  EXPECT_GT(scene.points().size(), 1000U);
  // An organised cloud of two million pixels, mostly unmeasured, is taken as it is; one of two
  // million points is thinned, and what is sparse in it stays.
  scan.resize(2'000'000, scan.back());
  EXPECT_FALSE(FindScene(tee(), scan, 0.002, {}).was_thinned());
  std::fill(scan.begin() + static_cast<std::ptrdiff_t>(finite), scan.end(), scan[0]);
  const FindScene thinned(tee(), scan, 0.002, {});
  EXPECT_TRUE(thinned.was_thinned());
  EXPECT_EQ(thinned.finite(), scan.size());
  EXPECT_EQ(thinned.points().size(), scene.points().size());
}

}  // namespace
}  // namespace spool
