// Tests of rotations: what they are seen from, whose they are, one-holed, and what is not measured.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/measure/rotation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/vision/measure/holed_spool.h"
#include "vision/measure/dimensions.h"
#include "vision/measure/judge_dimensions.h"

namespace spool {
namespace {

using Eigen::Vector3d;
using test::HoledScan;
using test::kFlangeA;
using test::kFlangeB;

constexpr double kDegree = std::numbers::pi / 180;

HoledScan dense() {
  HoledScan built;
  built.spool.per_square_metre = 640'000;  // points 1.25 mm apart
  return built;
}

struct Measured {
  MeasuredDrawing drawing;
  std::vector<PartFinding> parts;
  std::vector<Finding> findings;

  [[nodiscard]] const Dimension& rotation(const std::string& to) const {
    for (const Dimension& dimension : drawing.dimensions)
      if (dimension.kind == "rotation" && dimension.to == to) return dimension;
    ADD_FAILURE() << "no rotation of " << to;
    static const Dimension kNone;
    return kNone;
  }
  [[nodiscard]] std::string findings_of(const std::string& kind) const {
    std::string names;
    for (const Finding& finding : findings)
      if (finding.kind == kind) names += finding.part + " ";
    return names;
  }
};

Measured measured(const HoledScan& built, DesignModel design, std::uint32_t seed = 1) {
  design.datums = {kFlangeA};
  const PartFeatures features = test::holed_features(design, test::scan_of_holed(built, seed));
  Measured result;
  result.drawing =
      measure_dimensions(design, drawing_of(design), features, pfi_es3(), {.scale_u = 0.0002});
  for (int p = 0; p < test::kSpoolParts; ++p) {
    PartFinding finding;
    finding.part = p;
    finding.status = Verdict::kSuspicious;
    result.parts.push_back(finding);
  }
  judge_dimensions(design, result.drawing.dimensions, result.parts, result.findings);
  return result;
}

TEST(Rotation, OfASpoolAsDrawnIsOkAndSaysWhatItIsSeenFrom) {
  const Measured as_drawn = measured(dense(), test::holed_spool(8));
  EXPECT_EQ(as_drawn.drawing.datum,
            "flange_a/face and the axis of the pipe on it, turned about it by its bolt holes");
  const Dimension& far = as_drawn.rotation("flange_b/holes");
  EXPECT_EQ(far.from, "flange_a/holes");
  EXPECT_EQ(far.status, Verdict::kOk) << far.reason;
  EXPECT_NEAR(far.nominal, 22.5 * kDegree, 1e-9);
  EXPECT_LT(std::abs(far.deviation), 3 * far.u.total());
  EXPECT_EQ(far.rule, "PFI ES-3 3.1, along the bolt circle");
  EXPECT_EQ(far.u.scale, 0) << "angles do not change with scale";
  // The datum's own holes against what lies furthest off its axis.
  const Dimension& own = as_drawn.rotation("flange_a/holes");
  EXPECT_EQ(own.from, "flange_b/face");
  EXPECT_EQ(own.status, Verdict::kOk) << own.reason;
}

TEST(Rotation, OfAFlangeThatIsTurnedByTwoDegreesIsItsFlanges) {
  HoledScan built = dense();
  built.turn_b_rad = 2 * kDegree;
  const Measured turned = measured(built, test::holed_spool(8));
  const Dimension& far = turned.rotation("flange_b/holes");
  EXPECT_EQ(far.status, Verdict::kNotOk) << far.reason;
  EXPECT_NEAR(far.deviation, 2 * kDegree, 3 * far.u.total());
  EXPECT_EQ(far.answers, kFlangeB);
  EXPECT_EQ(turned.findings_of("misplaced"), "flange_b ");
  EXPECT_EQ(turned.findings_of("one_holed"), "");
  EXPECT_EQ(turned.rotation("flange_a/holes").status, Verdict::kOk);
}

TEST(Rotation, HalfAPitchIsOneHoled) {
  HoledScan built = dense();
  built.turn_b_rad = 22.5 * kDegree;
  const Measured turned = measured(built, test::holed_spool(8));
  EXPECT_EQ(turned.findings_of("one_holed"), "flange_b ");
  EXPECT_EQ(turned.findings_of("misplaced"), "");
  EXPECT_EQ(turned.parts[kFlangeB].status, Verdict::kNotOk);
  const Dimension& far = turned.rotation("flange_b/holes");
  EXPECT_NEAR(std::abs(far.deviation), 22.5 * kDegree, 3 * far.u.total());
  EXPECT_NE(far.reason.find("one-holed"), std::string::npos);
}

// Then the holes cannot say how the drawing is turned: the far flange does.
TEST(Rotation, ADatumThatIsOneHoledIsNamedAndTurnsNothing) {
  HoledScan built = dense();
  built.turn_a_rad = 22.5 * kDegree;
  const Measured turned = measured(built, test::holed_spool(8));
  EXPECT_EQ(turned.findings_of("one_holed"), "flange_a ");
  EXPECT_NE(turned.drawing.datum.find("by flange_b/face"), std::string::npos);
  EXPECT_EQ(turned.rotation("flange_b/holes").status, Verdict::kOk);
}

// The datum's holes are right by definition: what is turned is all else, and its offset shows it.
TEST(Rotation, OfTheDatumsHolesMovesTheFarEnd) {
  HoledScan built = dense();
  built.turn_a_rad = 2 * kDegree;
  const Measured turned = measured(built, test::holed_spool(8));
  const Dimension& own = turned.rotation("flange_a/holes");
  EXPECT_NEAR(own.deviation, 2 * kDegree, 3 * own.u.total());
  EXPECT_EQ(own.status, Verdict::kNotOk) << own.reason;
  double aside = 0;
  for (const Dimension& dimension : turned.drawing.dimensions)
    if (dimension.kind == "offset") aside = std::max(aside, std::abs(dimension.deviation));
  EXPECT_NEAR(aside, 0.68 * std::sin(2 * kDegree), 0.68 * 3 * own.u.total());
}

TEST(Rotation, IsKnownModuloThePitchOnly) {
  HoledScan built = dense();
  built.turn_b_rad = 45 * kDegree;
  const Measured turned = measured(built, test::holed_spool(8));
  EXPECT_EQ(turned.rotation("flange_b/holes").status, Verdict::kOk);
}

TEST(Rotation, WithoutHolesInSightIsNotMeasuredWithAdvice) {
  HoledScan built = dense();
  built.hole_m = 0;
  const Measured blind = measured(built, test::holed_spool(8));
  EXPECT_NE(blind.drawing.datum.find("by flange_b/face"), std::string::npos);
  for (const char* to : {"flange_a/holes", "flange_b/holes"}) {
    const Dimension& rotation = blind.rotation(to);
    EXPECT_EQ(rotation.status, Verdict::kNotMeasured);
    EXPECT_NE(rotation.reason.find("do not stand out"), std::string::npos) << rotation.reason;
    EXPECT_NE(rotation.reason.find("squarely"), std::string::npos);
  }
  EXPECT_EQ(blind.parts[kFlangeB].status, Verdict::kNotMeasured);
}

TEST(Rotation, OfATapStaysNotMeasuredWhereTheHolesAre) {
  DesignModel design = test::holed_spool(8);
  design.parts[kFlangeB].marks.push_back({.type = "tap"});
  const Measured with_tap = measured(dense(), std::move(design));
  EXPECT_EQ(with_tap.rotation("flange_b/holes").status, Verdict::kOk);
  EXPECT_EQ(with_tap.rotation("flange_b/tap").status, Verdict::kNotMeasured);
  EXPECT_NE(with_tap.parts[kFlangeB].status, Verdict::kOk);
}

}  // namespace
}  // namespace spool
