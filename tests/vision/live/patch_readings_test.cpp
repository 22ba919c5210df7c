// Claims about what is kept of each patch of the design.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/live/patch_readings.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/vision/live/placed_states.h"

namespace spool {
namespace {

std::shared_ptr<const SurfacePatches> bracket_patches() {
  const PreparedDesign& design = *test::prepared_bracket();
  return SurfacePatches::cut(design.samples, design.model.parts.size());
}

PatchReadings bracket_readings() {
  return {bracket_patches(), test::small_camera(), test::millimetre_noise()};
}

// The patch of the base's top in front of arm and post.
std::size_t on_the_base(const PatchReadings& readings) {
  const auto patch = readings.patches().at({0.2F, 0.08F, 0.05F}, Eigen::Vector3f::UnitZ());
  EXPECT_TRUE(patch.has_value());
  return patch.value_or(0);
}

Pose lifted(double by_m, const Pose& T) { return Eigen::Translation3d(0, 0, by_m) * T; }

TEST(SurfacePatches, EveryPointOfTheSurfaceIsOfAPatchOfItsPart) {
  const auto patches = bracket_patches();
  const SurfaceSamples& samples = test::prepared_bracket()->samples;
  std::size_t of_part = 0;
  for (std::size_t i = 0; i < samples.part.size(); ++i) {
    const auto patch = patches->at(samples.cloud.points[i], samples.cloud.normals[i]);
    ASSERT_TRUE(patch.has_value());
    of_part += patches->all()[*patch].part == samples.part[i] ? 1U : 0U;
  }
  EXPECT_EQ(of_part, samples.part.size());
  double area = 0;
  for (const SurfacePatch& patch : patches->all()) area += double{patch.area_m2};
  // The outside of the three boxes, less where they stand on each other; samples give it by their
  // spacing, to a fifth.
  const double truth = 2 * (0.4 * 0.2 + 0.6 * 0.05) + 0.56 * 0.15 + 0.24 * 0.09;
  EXPECT_NEAR(area / truth, 1, 0.2);
}

TEST(SurfacePatches, TellsTheSidesOfAThinPlateApart) {
  SurfaceSamples samples;
  for (int i = 0; i < 40; ++i)
    for (int k = 0; k < 40; ++k)
      for (const float side : {-1.0F, 1.0F}) {
        samples.cloud.points.emplace_back(0.005F * static_cast<float>(i),
                                          0.005F * static_cast<float>(k), 0.001F * side);
        samples.cloud.normals.emplace_back(0.0F, 0.0F, side);
        samples.part.push_back(0);
      }
  samples.radius_m = 0.005;
  const auto patches = SurfacePatches::cut(samples, 1);
  // A reading's foot may stand a millimetre off: nearer to the other side than to its own.
  const auto above = patches->at({0.1F, 0.1F, -0.0005F}, Eigen::Vector3f::UnitZ());
  ASSERT_TRUE(above.has_value());
  EXPECT_GT(patches->all()[*above].normal.z(), 0.9F);
}

TEST(SurfacePatches, AreNoMoreThanAskedForAndNoFewerOnASmallPart) {
  const SurfaceSamples& samples = test::prepared_bracket()->samples;
  const auto few = SurfacePatches::cut(samples, 3, {.most = 60, .fewest_a_part = 4});
  EXPECT_LE(few->all().size(), 60U);
  const auto patches = SurfacePatches::cut(samples, 3);
  for (int part = 0; part < 3; ++part)
    EXPECT_GE(std::ranges::count(patches->all(), part, &SurfacePatch::part), 16) << part;
}

TEST(PatchReadings, MeanIsHowFarTheSurfaceIsFromTheDesign) {
  PatchReadings readings = bracket_readings();
  // The design is said to lie 2 mm lower in the scene than it does.
  for (int i = 0; i < 30; ++i)
    readings.add(test::placed_state(test::walking(i), lifted(0.002, test::walking(i)), i),
                 Matrix6d::Zero());
  const PatchMean base = readings.of(on_the_base(readings));
  ASSERT_GT(base.information, 0);
  EXPECT_NEAR(base.mean_m, 0.002, 3 * std::sqrt(base.variance_m2()));
  EXPECT_LT(std::sqrt(base.variance_m2()), kKnownSigma_m);
  EXPECT_TRUE(readings.is_known(on_the_base(readings)));
  const auto under = readings.patches().at({0.2F, 0.08F, 0.0F}, -Eigen::Vector3f::UnitZ());
  ASSERT_TRUE(under.has_value());
  EXPECT_EQ(readings.of(*under).information, 0) << "nobody looked at the underside";
}

TEST(PatchReadings, ACorrectedPoseCorrectsWhatWasReadBefore) {
  const Vector6d small = (Vector6d() << 0.002, -0.001, 0.0015, 0.004, -0.006, 0.003).finished();
  const Pose T_new_old = pose_from_small(small);
  PatchReadings corrected = bracket_readings(), right = bracket_readings();
  for (int i = 0; i < 10; ++i) {
    const Pose truth = test::walking(i);
    corrected.add(test::placed_state(truth, T_new_old.inverse() * truth, i), Matrix6d::Zero());
    right.add(test::placed_state(truth, truth, i), Matrix6d::Zero());
  }
  corrected.follow(T_new_old);
  // Of a small part of the readings near edges another surface is nearer after the correction.
  std::vector<double> off, before;
  for (std::size_t k = 0; k < right.patches().all().size(); ++k) {
    if (right.of(k).information <= 0 || corrected.of(k).information <= 0) continue;
    off.push_back(std::abs(corrected.of(k).mean_m - right.of(k).mean_m));
  }
  ASSERT_GT(off.size(), 50U);
  std::ranges::sort(off);
  // 6 mrad over half a metre is 3 mm; its square over that length is 0.02 mm, and other readings
  // are in a patch whose border moved.
  EXPECT_LT(off[off.size() / 2], 0.0001);
  EXPECT_LT(off[off.size() * 9 / 10], 0.0005);
}

TEST(PatchReadings, ACameraThatStandsStillLearnsNoMoreThanByOneLook) {
  PatchReadings still = bracket_readings(), walked = bracket_readings();
  const auto add = [](PatchReadings& readings, const Pose& T, int i) {
    readings.add(test::placed_state(T, T, i), Matrix6d::Zero());
  };
  add(still, test::walking(0), 0);
  const double one = still.of(on_the_base(still)).information;
  for (int i = 0; i < 40; ++i) add(still, test::walking(0), i + 1);
  for (int i = 0; i < 40; ++i) add(walked, test::walking(i), i);
  // The same readings are Tukey's a little more or less in each frame.
  EXPECT_LT(still.of(on_the_base(still)).information, 1.3 * one);
  EXPECT_GT(walked.of(on_the_base(walked)).information, 8 * one);
}

// A hand lies 15 mm over the base from frame `from` on.
test::ChangeFrame hand_over_the_base(const Pose& T) {
  return [T](DepthFrame& frame) {
    const Camera camera = test::small_camera();
    for (int v = 0; v < frame.height; ++v)
      for (int u = 0; u < frame.width; ++u) {
        std::uint16_t& depth = frame.depth[static_cast<std::size_t>(v * frame.width + u)];
        const Eigen::Vector3d p = T * camera.back_project(u, v, depth * camera.depth_unit_m);
        const bool is_base = std::abs(p.z() - 0.05) < 0.005 && p.x() > 0.1 && p.x() < 0.28;
        if (is_base) depth = static_cast<std::uint16_t>(depth - 17);  // along a slanting ray
      }
  };
}

TEST(PatchReadings, AHandThatPassesChangesNothingAndWhatStaysDoes) {
  PatchReadings readings = bracket_readings();
  int i = 0;
  for (; i < 30; ++i)
    readings.add(test::placed_state(test::walking(i), test::walking(i), i), Matrix6d::Zero());
  const std::size_t base = on_the_base(readings);
  const auto cover = [&](int frames) {
    for (const int end = i + frames; i < end; ++i) {
      const Pose T = test::walking(i);
      readings.add(test::placed_state(T, T, i, hand_over_the_base(T)), Matrix6d::Zero());
    }
  };
  cover(20);  // two thirds of a second
  EXPECT_NEAR(readings.of(base).mean_m, 0, 0.0005);
  cover(25);  // and as long again
  EXPECT_NEAR(readings.of(base).mean_m, 0.015, 0.003);
}

TEST(PatchReadings, APartsNumberHoldsTheDoubtOfThePose) {
  PatchReadings readings = bracket_readings();
  for (int i = 0; i < 20; ++i)
    readings.add(test::placed_state(test::walking(i), test::walking(i), i), Matrix6d::Zero());
  const PartReading sure = readings.of_part(0, Matrix6d::Zero());
  ASSERT_TRUE(sure.is_seen);
  EXPECT_NEAR(sure.mean_m, 0, sure.u_m + 0.0003);  // rounding to millimetres of a flat surface
  EXPECT_LT(sure.u_m, 0.0003);
  // Its top and one side are seen, of six faces: 0.08 m2 of 0.22.
  EXPECT_GT(sure.coverage, 0.2);
  EXPECT_LT(sure.coverage, 0.6);
  Matrix6d doubt = Matrix6d::Zero();
  doubt(2, 2) = 1e-6;  // 1 mm upwards: most of what is seen is its top
  const PartReading unsure = readings.of_part(0, doubt);
  EXPECT_GT(unsure.u_m, 0.0012);
  EXPECT_LT(unsure.u_m, 0.0021);
  EXPECT_EQ(unsure.mean_m, sure.mean_m);
}

}  // namespace
}  // namespace spool
