// Tests of the dimensions: as drawn, with one known error each, and what is not measured.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/measure/dimensions.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/vision/measure/two_flange_spool.h"
#include "vision/measure/judge_dimensions.h"

namespace spool {
namespace {

using Eigen::Vector3d;
using test::SpoolScan;

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kCalibrated = 0.0002;

MeasuredDrawing measured(const DesignModel& design, const SpoolScan& scan,
                         const DimensionOptions& options = {.scale_u = kCalibrated},
                         std::uint32_t seed = 1) {
  return measure_dimensions(design, drawing_of(design), test::features_of(design, scan, seed),
                            pfi_es3(), options);
}

const Dimension& find(const MeasuredDrawing& drawing, const std::string& kind,
                      const std::string& to) {
  for (const Dimension& dimension : drawing.dimensions)
    if (dimension.kind == kind && dimension.to == to) return dimension;
  ADD_FAILURE() << "no " << kind << " to " << to;
  static const Dimension kNone;
  return kNone;
}

Pose turned(const Vector3d& point, const Vector3d& axis, double degrees) {
  Pose pose = Pose::Identity();
  pose.linear() = rotation_from_vector(axis * degrees * kDegree);
  pose.translation() = point - pose.linear() * point;
  return pose;
}

TEST(Dimensions, OfASpoolAsDrawnAreWithinTheirUncertaintyAndOk) {
  const DesignModel design = test::two_flange_spool();
  int outside = 0, all = 0;
  for (std::uint32_t seed = 1; seed <= 8; ++seed) {
    const MeasuredDrawing drawing = measured(design, {}, {.scale_u = kCalibrated}, seed);
    ASSERT_EQ(drawing.dimensions.size(), 6U);
    for (const Dimension& dimension : drawing.dimensions) {
      SCOPED_TRACE(dimension.kind + " " + dimension.name + ": " + dimension.reason);
      ASSERT_TRUE(dimension.is_measured);
      EXPECT_EQ(dimension.status, Verdict::kOk);
      EXPECT_GE(dimension.probability, 0.95);
      EXPECT_FALSE(dimension.rule.empty());
      ++all;
      outside += std::abs(dimension.deviation) > 2 * dimension.u.total();
    }
  }
  // One in twenty of 48; more than 8 happen once in a thousand such tests.
  EXPECT_LE(outside, 8) << all;
}

TEST(Dimensions, AreNominalAsTheDrawingHasThem) {
  const DesignModel design = test::two_flange_spool();
  const MeasuredDrawing drawing = measured(design, {});
  EXPECT_NEAR(find(drawing, "centre_to_face", "elbow_1/centre").nominal, 0.68, 1e-9);
  EXPECT_NEAR(find(drawing, "centre_to_face", "flange_b/face").nominal, 0.68, 1e-9);
  EXPECT_NEAR(find(drawing, "angle", "pipe_2/axis").nominal, 90 * kDegree, 1e-9);
  EXPECT_EQ(find(drawing, "angle", "pipe_2/axis").answers, test::kElbow);
}

TEST(Dimensions, ACutThatIsTooLongIsItsOwnLengthAndNothingElse) {
  const DesignModel design = test::two_flange_spool();
  SpoolScan scan;
  scan.T_design_built[test::kFlangeB] = Pose(Eigen::Translation3d(0.0045, 0, 0));
  const MeasuredDrawing drawing = measured(design, scan);
  for (const Dimension& dimension : drawing.dimensions) {
    const bool is_it = dimension.to == "flange_b/face" && dimension.kind == "centre_to_face";
    EXPECT_EQ(dimension.status, is_it ? Verdict::kNotOk : Verdict::kOk)
        << dimension.name << ": " << dimension.reason;
    if (!is_it) continue;
    EXPECT_NEAR(dimension.deviation, 0.0045, 3 * dimension.u.total());
    EXPECT_EQ(dimension.answers, test::kPipe2);
    EXPECT_EQ(dimension.rule, "PFI ES-3 2.2");
  }
}

TEST(Dimensions, AFaceThatLeansIsItsFlanges) {
  const DesignModel design = test::two_flange_spool();
  SpoolScan scan;
  scan.T_design_built[test::kFlangeB] = turned({0.68, 0, 0.65}, Vector3d::UnitY(), 0.6);
  const MeasuredDrawing drawing = measured(design, scan);
  const Dimension& lean = find(drawing, "face_alignment", "flange_b/face");
  EXPECT_EQ(lean.status, Verdict::kNotOk) << lean.reason;
  EXPECT_NEAR(lean.deviation, 0.6 * kDegree, 3 * lean.u.total());
  EXPECT_EQ(lean.answers, test::kFlangeB);
  EXPECT_EQ(find(drawing, "face_alignment", "flange_a/face").status, Verdict::kOk);
}

TEST(Dimensions, AnElbowThatIsOutShowsAsItsAngleAndFarOffset) {
  const DesignModel design = test::two_flange_spool();
  SpoolScan scan;
  const Pose out = turned({0, 0, 0.65}, Vector3d::UnitY(), -1);  // lifts pipe_2's far end
  scan.T_design_built[test::kPipe2] = scan.T_design_built[test::kFlangeB] = out;
  const MeasuredDrawing drawing = measured(design, scan);
  const Dimension& angle = find(drawing, "angle", "pipe_2/axis");
  EXPECT_EQ(angle.status, Verdict::kNotOk) << angle.reason;
  EXPECT_NEAR(std::abs(angle.deviation), kDegree, 3 * angle.u.total());
  // 0.68 m at 1 degree: 11.9 mm.
  const Dimension& offset = find(drawing, "offset", "flange_b/face");
  EXPECT_EQ(offset.from, "flange_a/face");
  EXPECT_NEAR(std::abs(offset.deviation), 0.68 * std::sin(kDegree), 3 * offset.u.total());
  EXPECT_EQ(offset.status, Verdict::kNotOk);
}

TEST(Dimensions, AnOffsetIsOfAllThatLiesBetweenItAndTheDatum) {
  const DesignModel design = test::two_flange_spool();
  SpoolScan scan;  // an angle within its tolerance that is too much at the far end: 3.8 mm of 3
  const Pose out = turned({0, 0, 0.65}, Vector3d::UnitY(), -0.32);
  scan.T_design_built[test::kPipe2] = scan.T_design_built[test::kFlangeB] = out;
  const MeasuredDrawing drawing = measured(design, scan);
  for (const Dimension& dimension : drawing.dimensions) {
    if (dimension.kind != "offset") {
      EXPECT_EQ(dimension.status, Verdict::kOk) << dimension.name << ": " << dimension.reason;
      continue;
    }
    std::vector<int> parts = dimension.parts;
    std::ranges::sort(parts);
    EXPECT_EQ(parts, (std::vector<int>{test::kFlangeA, test::kPipe1, test::kElbow, test::kPipe2,
                                       test::kFlangeB}));
    EXPECT_EQ(dimension.answers, -1) << "whose fault it is, it does not tell";
    EXPECT_EQ(dimension.status, Verdict::kNotOk) << dimension.reason;
  }
  std::vector<PartFinding> parts(test::kSpoolParts);
  for (int p = 0; p < test::kSpoolParts; ++p) {
    parts[static_cast<std::size_t>(p)].part = p;
    parts[static_cast<std::size_t>(p)].status = Verdict::kSuspicious;
  }
  std::vector<Finding> findings;
  judge_dimensions(design, drawing.dimensions, parts, findings);
  for (const PartFinding& part : parts)
    EXPECT_EQ(part.status, Verdict::kSuspicious) << part.part << ": " << part.reason;
}

TEST(Dimensions, HowAFlangeWithHolesIsTurnedIsListedAndKeepsItFromBeingOk) {
  DesignModel design = test::two_flange_spool();
  design.parts[test::kFlangeB].holes = BoltHoles{.count = 8, .bolt_circle_m = 0.1905};
  const MeasuredDrawing drawing = measured(design, {});
  const Dimension& rotation = find(drawing, "rotation", "flange_b/holes");
  EXPECT_FALSE(rotation.is_measured);
  EXPECT_EQ(rotation.status, Verdict::kNotMeasured);
  EXPECT_NE(rotation.reason.find("bolt holes"), std::string::npos);
  EXPECT_EQ(rotation.parts, std::vector<int>{test::kFlangeB});
  EXPECT_EQ(drawing.dimensions.size(), 7U) << "one without holes has none";
}

TEST(Dimensions, AnUncalibratedScaleMakesLongOnesSuspiciousAndSaysSo) {
  const DesignModel design = test::two_flange_spool();
  const MeasuredDrawing drawing = measured(design, {}, {.scale_u = 0.005});
  const Dimension& length = find(drawing, "centre_to_face", "flange_b/face");
  EXPECT_EQ(length.status, Verdict::kSuspicious);
  EXPECT_NEAR(length.u.scale, 0.005 * 0.68, 1e-5);
  EXPECT_NE(length.reason.find("scale"), std::string::npos);
  const Dimension& angle = find(drawing, "angle", "pipe_2/axis");
  EXPECT_EQ(angle.u.scale, 0) << "angles do not change with scale";
  EXPECT_EQ(angle.status, Verdict::kOk);
}

TEST(Dimensions, AScanThatIsTooLargeIsWithinItsStatedScale) {
  const DesignModel design = test::two_flange_spool();
  SpoolScan scan;
  scan.scale = 1.005;
  const MeasuredDrawing drawing = measured(design, scan, {.scale_u = 0.005});
  const Dimension& length = find(drawing, "centre_to_face", "elbow_1/centre");
  EXPECT_NEAR(length.deviation, 0.0034, 0.0005);
  EXPECT_LT(std::abs(length.deviation), 2 * length.u.total());
  EXPECT_NE(length.status, Verdict::kOk);
}

TEST(Dimensions, WarpIsPartOfTheDoubtOfEvery) {
  const DesignModel design = test::two_flange_spool();
  const PartFeatures flat = test::features_of(design, SpoolScan{});
  const PartFeatures warped = test::features_of(design, SpoolScan{}, 1, 0.003);
  const Drawing plan = drawing_of(design);
  const auto with = [&](const PartFeatures& features) {
    return measure_dimensions(design, plan, features, pfi_es3(), {.scale_u = kCalibrated});
  };
  const MeasuredDrawing a = with(flat), b = with(warped);
  for (std::size_t i = 0; i < a.dimensions.size(); ++i) {
    EXPECT_EQ(a.dimensions[i].u.warp, 0);
    EXPECT_GT(b.dimensions[i].u.warp, 0.5 * b.dimensions[i].u.total()) << b.dimensions[i].name;
    EXPECT_LT(b.dimensions[i].probability, a.dimensions[i].probability + 1e-12);
  }
}

TEST(Dimensions, WhatWasNotSeenIsNotMeasuredWithTheReason) {
  const DesignModel design = test::two_flange_spool();
  SpoolScan scan;
  scan.is_there[test::kFlangeB] = false;
  const MeasuredDrawing without_face = measured(design, scan);
  const Dimension& length = find(without_face, "centre_to_face", "flange_b/face");
  EXPECT_EQ(length.status, Verdict::kNotMeasured);
  EXPECT_FALSE(length.is_measured);
  EXPECT_NE(length.reason.find("face of flange_b"), std::string::npos) << length.reason;
  EXPECT_EQ(find(without_face, "centre_to_face", "elbow_1/centre").status, Verdict::kOk);
  scan = {};
  scan.is_there[test::kPipe2] = false;
  const MeasuredDrawing without_pipe = measured(design, scan);
  for (const Dimension& dimension : without_pipe.dimensions) {
    const bool is_a = dimension.to == "flange_a/face";  // its lean against pipe_1
    EXPECT_EQ(dimension.is_measured, is_a) << dimension.name;
  }
}

TEST(Dimensions, AreRelativeToTheDatumThatIsNamed) {
  DesignModel design = test::two_flange_spool();
  SpoolScan scan;
  scan.T_design_built[test::kFlangeA] = Pose(Eigen::Translation3d(0, 0.006, 0));
  scan.T_design_built[test::kPipe1] = scan.T_design_built[test::kFlangeA];
  design.datums = {test::kFlangeB};
  const MeasuredDrawing from_b = measured(design, scan);
  EXPECT_EQ(from_b.datum.find("flange_b/face"), 0U) << from_b.datum;
  EXPECT_EQ(find(from_b, "offset", "flange_a/face").from, "flange_b/face");
  design.datums = {test::kFlangeA};
  const MeasuredDrawing from_a = measured(design, scan);
  EXPECT_EQ(from_a.datum.find("flange_a/face"), 0U) << from_a.datum;
  EXPECT_EQ(find(from_a, "offset", "flange_b/face").from, "flange_a/face");
  // A datum that was not seen, or is no flange, is said.
  scan.is_there[test::kFlangeA] = false;
  const MeasuredDrawing unseen = measured(design, scan);
  EXPECT_NE(unseen.datum.find("not measured"), std::string::npos);
  EXPECT_EQ(find(unseen, "offset", "flange_b/face").status, Verdict::kNotMeasured);
  design.datums = {test::kPipe1};
  EXPECT_NE(measured(design, scan).datum.find("no flange"), std::string::npos);
}

TEST(Dimensions, NothingIsOkWhereAUnitWasGuessed) {
  const DesignModel design = test::two_flange_spool();
  const MeasuredDrawing drawing =
      measured(design, {}, {.scale_u = kCalibrated, .nothing_ok = "But a unit was guessed."});
  for (const Dimension& dimension : drawing.dimensions) {
    EXPECT_EQ(dimension.status, Verdict::kSuspicious) << dimension.name;
    EXPECT_NE(dimension.reason.find("unit was guessed"), std::string::npos);
  }
}

TEST(Dimensions, WithoutARuleNothingIsDecided) {
  const DesignModel design = test::two_flange_spool();
  const MeasuredDrawing drawing =
      measure_dimensions(design, drawing_of(design), test::features_of(design, SpoolScan{}),
                         RuleSet{.name = "nothing"}, {.scale_u = kCalibrated});
  for (const Dimension& dimension : drawing.dimensions) {
    EXPECT_TRUE(dimension.is_measured);
    EXPECT_EQ(dimension.status, Verdict::kSuspicious);
  }
}

}  // namespace
}  // namespace spool
