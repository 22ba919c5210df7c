// Tests of the features: where steel is that was measured, and what is not taken for it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/measure/part_feature.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/vision/measure/two_flange_spool.h"
#include "vision/measure/part_shapes.h"

namespace spool {
namespace {

using Eigen::Vector3d;

const PartFeature& feature_of(const PartFeatures& features, int part) {
  const int index = features.of(part);
  EXPECT_GE(index, 0) << features.why_not[static_cast<std::size_t>(part)];
  static const PartFeature kNone;
  return index < 0 ? kNone : features.features[static_cast<std::size_t>(index)];
}

// Off the nominal axis at the feature's own origin, m.
double axis_off(const PartFeature& feature) {
  const Vector3d d = feature.T_design_nominal.inverse() * feature.T_design_measured.translation();
  return std::hypot(d.x(), d.y());
}

TEST(PartFeatures, AreThePipesAxesAndTheFlangesFaces) {
  const DesignModel design = test::two_flange_spool();
  const PartFeatures features = test::features_of(design, test::SpoolScan{});
  ASSERT_EQ(features.features.size(), 4U);
  EXPECT_EQ(features.of(test::kElbow), -1);
  const PartFeature& pipe = feature_of(features, test::kPipe1);
  EXPECT_EQ(pipe.kind, FeatureKind::kAxis);
  EXPECT_LT(axis_off(pipe), 1e-4);
  EXPECT_NEAR(pipe.radius_m, 0.05715, 1e-4);
  EXPECT_FALSE(pipe.is_observed[2]) << "an axis slides along itself";
  EXPECT_EQ(pipe.fit_covariance(2, 2), 0);
  const PartFeature& face = feature_of(features, test::kFlangeB);
  EXPECT_EQ(face.kind, FeatureKind::kFace);
  EXPECT_GT(face.T_design_measured.linear().col(2).x(), 0.9999) << "it looks outward";
  EXPECT_FALSE(face.is_observed[0]);
  EXPECT_NEAR(face.T_design_measured.translation().x(), 0.68, 2e-4);
}

TEST(PartFeatures, TheBoreSeenThroughAnOpenEndIsNotTheOutside) {
  DesignModel design = test::two_flange_spool();
  constexpr double kBore = 0.05113;
  // pipe_2's bore is drawn: one triangle with its corners there is enough to know the wall.
  Part& pipe = design.parts[test::kPipe2];
  const auto first = static_cast<std::uint32_t>(design.mesh.triangles.size());
  for (std::uint32_t t = 0; t < pipe.triangle_count; ++t) {
    design.mesh.triangles.push_back(design.mesh.triangles[pipe.first_triangle + t]);
    design.triangle_part.push_back(test::kPipe2);
  }
  const auto vertex = static_cast<std::uint32_t>(design.mesh.vertices.size());
  for (const double a : {0.0, 0.1, 0.2})
    design.mesh.vertices.push_back(
        Vector3d(0.4, kBore * std::cos(a), 0.65 + kBore * std::sin(a)).cast<float>());
  design.mesh.triangles.push_back({vertex, vertex + 1, vertex + 2});
  design.triangle_part.push_back(test::kPipe2);
  pipe.first_triangle = first;
  pipe.triangle_count += 1;
  ASSERT_NEAR(pipe_shape(design, test::kPipe2)->bore_radius_m, kBore, 1e-6);
  // A quarter of the pipe's turn shows its bore only, over a third of its length.
  PointCloud scan = test::scan_of_spool({.noise_m = 0.001});
  for (Eigen::Vector3f& p : scan.points) {
    const Vector3d d = p.cast<double>() - Vector3d(0, 0, 0.65);
    const double across = std::hypot(d.y(), d.z());
    if (d.x() < 0.48 || d.x() > 0.64 || std::abs(across - 0.05715) > 0.005) continue;
    if (d.y() < std::abs(d.z())) continue;
    p -= Vector3d(0, d.y(), d.z()).cast<float>() * static_cast<float>((0.05715 - kBore) / across);
  }
  const PartFeatures features = test::features_of(design, scan);
  const PartFeature& axis = feature_of(features, test::kPipe2);
  EXPECT_LT(axis_off(axis), 2e-4);
  EXPECT_NEAR(axis.radius_m, 0.05715, 2e-4);
}

TEST(PartFeatures, AFlangesBackIsNotItsFace) {
  const DesignModel design = test::two_flange_spool();
  test::SpoolScan scan;
  // Off by its own thickness: its back lies where the face should.
  scan.T_design_built[test::kFlangeB] = Pose(Eigen::Translation3d(0.029, 0, 0));
  const PartFeatures features = test::features_of(design, scan);
  EXPECT_EQ(features.of(test::kFlangeB), -1);
  EXPECT_NE(features.why_not[test::kFlangeB].find("in front"), std::string::npos)
      << features.why_not[test::kFlangeB];
}

TEST(PartFeatures, WhatIsCutOffByTheBoundIsNotMeasured) {
  const DesignModel design = test::two_flange_spool();
  test::SpoolScan scan;
  scan.noise_m = 0.002;
  // Of 16 mm and 2 mm of noise the bound of 20 mm takes a fortieth of the readings, all on one
  // side.
  scan.T_design_built[test::kFlangeB] = Pose(Eigen::Translation3d(0.016, 0, 0));
  scan.T_design_built[test::kPipe1] = Pose(Eigen::Translation3d(0, 0.016, 0));
  const PartFeatures cut = test::features_of(design, scan);
  for (const int part : {test::kFlangeB, test::kPipe1}) {
    EXPECT_EQ(cut.of(part), -1);
    EXPECT_NE(cut.why_not[static_cast<std::size_t>(part)].find("too far"), std::string::npos)
        << cut.why_not[static_cast<std::size_t>(part)];
  }
  scan.T_design_built[test::kFlangeB] = Pose(Eigen::Translation3d(0.008, 0, 0));
  scan.T_design_built[test::kPipe1] = Pose(Eigen::Translation3d(0, 0.008, 0));
  const PartFeatures whole = test::features_of(design, scan);
  EXPECT_NEAR(feature_of(whole, test::kFlangeB).T_design_measured.translation().x(), 0.688, 5e-4);
  EXPECT_NEAR(axis_off(feature_of(whole, test::kPipe1)), 0.008, 5e-4);
}

TEST(PartFeatures, OfOneCameraWhatFacesAwayOrGrazesIsLeftOut) {
  const DesignModel design = test::two_flange_spool();
  const PointCloud scan = test::scan_of_spool({});
  const Vector3d eye(0.1, -1.5, 0.3);
  const PartFeatures one_side = test::features_of(design, scan, 0, eye);
  const PartFeatures all = test::features_of(design, scan);
  // Within 66 degrees of the ray: 132 of 360.
  const double share = static_cast<double>(feature_of(one_side, test::kPipe1).points) /
                       static_cast<double>(feature_of(all, test::kPipe1).points);
  EXPECT_NEAR(share, 132.0 / 360, 0.03);
  EXPECT_LT(axis_off(feature_of(one_side, test::kPipe1)), 4e-4);
  EXPECT_EQ(one_side.of(test::kFlangeB), -1) << "its face looks past the camera";
}

TEST(PartFeatures, TooFewPointsMakeNone) {
  const DesignModel design = test::two_flange_spool();
  PointCloud scan = test::scan_of_spool({});
  scan.points.resize(20);
  const PartFeatures features = test::features_of(design, scan);
  EXPECT_TRUE(features.features.empty());
  EXPECT_NE(features.why_not[test::kPipe1].find("points"), std::string::npos);
}

}  // namespace
}  // namespace spool
