// The main path on a spool with a drawing: from a scan to verdicts on its dimensions and parts.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "tests/vision/measure/two_flange_spool.h"
#include "vision/inspector.h"

namespace spool {
namespace {

Inspection inspected(const test::SpoolScan& built, InspectorOptions options = {.scale_u = 0.0002}) {
  DesignModel model = test::two_flange_spool();
  model.origin = {100, 20, -3};  // a plant's coordinates
  const auto design = PreparedDesign::prepare(std::move(model));
  EXPECT_TRUE(design);
  std::mt19937 random{1};
  const Pose T_scan_design = test::random_motion(1.5, 1.0, random);
  PointCloud scan = moved(test::scan_of_spool(built), T_scan_design);
  options.align = AlignMethod::kPose;
  Pose T_design_scan = T_scan_design.inverse();
  T_design_scan.pretranslate(Eigen::Vector3d(100, 20, -3));
  options.T_design_scan = T_design_scan;
  const auto inspection = Inspector(*design).process(scan, {.constant_m = 0.0005}, options);
  EXPECT_TRUE(inspection);
  return *inspection;
}

const PartFinding& part(const Inspection& inspection, int index) {
  return inspection.parts[static_cast<std::size_t>(index)];
}

TEST(InspectorMeasures, ASpoolAsDrawnIsOkWhereItWasSeen) {
  const Inspection found = inspected({});
  ASSERT_EQ(found.dimensions.size(), 6U);
  for (const Dimension& dimension : found.dimensions)
    EXPECT_EQ(dimension.status, Verdict::kOk) << dimension.name << ": " << dimension.reason;
  for (const int p : {test::kFlangeA, test::kPipe1, test::kPipe2, test::kFlangeB})
    EXPECT_EQ(part(found, p).status, Verdict::kOk) << part(found, p).reason;
  // The elbow has no surface here.
  EXPECT_EQ(part(found, test::kElbow).status, Verdict::kNotMeasured);
  EXPECT_EQ(found.status, Verdict::kNotMeasured);
  EXPECT_EQ(found.datum.find("flange_"), 0U);
  EXPECT_TRUE(found.timing_s.contains("measure"));
}

TEST(InspectorMeasures, APipeCutTooLongIsNotOkWithAFinding) {
  test::SpoolScan built;
  built.T_design_built[test::kFlangeB] = Pose(Eigen::Translation3d(0.0045, 0, 0));
  const Inspection found = inspected(built);
  EXPECT_EQ(found.status, Verdict::kNotOk);
  EXPECT_EQ(part(found, test::kPipe2).status, Verdict::kNotOk);
  EXPECT_EQ(part(found, test::kPipe1).status, Verdict::kOk);
  const auto misplaced = [](const Inspection& inspection) {
    std::string names;
    for (const Finding& finding : inspection.findings)
      if (finding.kind == "misplaced") names += finding.part + " ";
    return names;
  };
  EXPECT_EQ(misplaced(found), "pipe_2 ");
  // The rules that are given decide: ISO 13920's class B allows 3 mm, class D 9 mm.
  EXPECT_EQ(misplaced(inspected(built, {.rules = iso_13920('B', 'F'), .scale_u = 0.0002})),
            "pipe_2 ");
  EXPECT_EQ(misplaced(inspected(built, {.rules = iso_13920('D', 'F'), .scale_u = 0.0002})), "");
}

TEST(InspectorMeasures, AGuessedUnitIsNotOk) {
  const Inspection found = inspected({}, {.units_confirmed = false, .scale_u = 0.0002});
  EXPECT_EQ(found.status, Verdict::kSuspicious);
  EXPECT_EQ(part(found, test::kPipe1).status, Verdict::kSuspicious);
}

std::size_t count_of(const Inspection& inspection, const std::string& kind) {
  return static_cast<std::size_t>(std::ranges::count(inspection.findings, kind, &Finding::kind));
}

TEST(InspectorMeasures, NothingIsOkWherePiecesOfKnownSizeContradictTheCalibration) {
  const Inspection honest = inspected({});
  EXPECT_EQ(count_of(honest, "scale"), 0U);
  ASSERT_TRUE(honest.scale);
  EXPECT_EQ(honest.scale->gauges.size(), 4U);  // two pipes, two flanges
  for (const double error : {0.015, -0.015}) {
    const Inspection found = inspected({.scale = 1 + error});
    ASSERT_TRUE(found.scale);
    EXPECT_TRUE(found.scale->is_contradicted) << found.scale->statistic;
    EXPECT_NEAR(found.scale->found, error, 3 * found.scale->found_u);
    EXPECT_EQ(count_of(found, "scale"), 1U);
    EXPECT_NE(found.status, Verdict::kOk);
    for (const Dimension& dimension : found.dimensions)
      EXPECT_NE(dimension.status, Verdict::kOk) << dimension.name;
    for (const PartFinding& each : found.parts) EXPECT_NE(each.status, Verdict::kOk);
  }
}

// A pipe fit whose radius is held, or narrowed, would say one of any sensor.
TEST(InspectorMeasures, TheScaleOfASensorWithoutCalibrationIsNarrowedAndPutRight) {
  const Inspection found = inspected({.scale = 1.012}, InspectorOptions{});
  ASSERT_TRUE(found.scale);
  EXPECT_FALSE(found.scale->is_contradicted);
  EXPECT_GT(found.scale->correction, 0.005);
  EXPECT_LT(found.scale->scale_u, 0.004);
  for (const Dimension& dimension : found.dimensions) {
    if (!dimension.is_measured || dimension.is_angle) continue;
    EXPECT_LT(std::abs(dimension.deviation), 2 * dimension.u.total()) << dimension.name;
    EXPECT_LT(dimension.u.scale, 0.005 * std::abs(dimension.measured)) << dimension.name;
  }
}

}  // namespace
}  // namespace spool
