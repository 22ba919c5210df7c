// Tests of the rules: every limit of PFI ES-3 and ISO 13920 at it, just inside and just outside.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/measure/rules.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace spool {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

TEST(PfiEs3, AllowsALengthByItsNominalPipeSize) {
  struct Row {
    double nps, tolerance_mm;
  };
  const Row rows[] = {{0.125, 3}, {0.5, 3},     {10, 3},  {10.001, 5}, {12, 5},
                      {24, 5},    {24.001, 6},  {26, 6},  {36, 6},     {36.001, 8},
                      {48, 8},    {48.001, 10}, {60, 10}, {72, 12}};
  for (const Row& row : rows) {
    const auto tolerance = length_tolerance(pfi_es3(), row.nps, 1.0);
    ASSERT_TRUE(tolerance) << row.nps;
    EXPECT_NEAR(1000 * tolerance->value, row.tolerance_mm, 1e-9) << row.nps;
    EXPECT_EQ(tolerance->rule, "PFI ES-3 2.2");
  }
  EXPECT_FALSE(length_tolerance(pfi_es3(), 72.001, 1.0)) << "no row, no rule";
  EXPECT_FALSE(length_tolerance(pfi_es3(), 0, 1.0)) << "of no known size";
}

TEST(PfiEs3, AlignmentIsTheGreaterOfBothReadings) {
  // 1/32 in across, up to where 3/64 in a foot is more: 8 in.
  const auto at = [](double diameter_m) { return *alignment_tolerance(pfi_es3(), diameter_m); };
  EXPECT_NEAR(at(0.0921).value / kDegree, 0.494, 0.001);  // NPS 2's raised face
  EXPECT_NEAR(at(0.1572).value / kDegree, 0.289, 0.001);  // NPS 4's
  EXPECT_NEAR(at(0.2159).value / kDegree, 0.224, 0.001);  // NPS 6's
  EXPECT_NEAR(at(0.6921).value / kDegree, 0.224, 0.001);  // NPS 24's
  EXPECT_GT(at(0.2031).value, 3.0 / 64 / 12);
  EXPECT_NEAR(at(0.2032).value, 3.0 / 64 / 12, 1e-9);
  EXPECT_DOUBLE_EQ(at(0.2033).value, 3.0 / 64 / 12);
  EXPECT_EQ(at(0.1).rule, "PFI ES-3 3.1");
  EXPECT_FALSE(alignment_tolerance(pfi_es3(), 0)) << "of no known diameter";
  // Angles of legs are read as the alignment of their ends.
  EXPECT_DOUBLE_EQ(angle_tolerance(pfi_es3(), 0.5, 0.1143)->value, at(0.1143).value);
}

TEST(PfiEs3, RotationIsASixteenthOfAnInchByTheStricterReading) {
  RuleSet rules = pfi_es3();
  // Bolt circles of ASME B16.5, class 150: along the circle 1/16 in, or as a difference in level
  // across two holes, which is stricter for four of them alone.
  EXPECT_NEAR(rotation_tolerance(rules, 8, 0.1905)->value / kDegree, 0.955, 0.001);   // NPS 4
  EXPECT_NEAR(rotation_tolerance(rules, 20, 0.7493)->value / kDegree, 0.243, 0.001);  // NPS 24
  EXPECT_NEAR(rotation_tolerance(rules, 4, 0.1207)->value / kDegree, 1.066, 0.001);   // NPS 2
  EXPECT_EQ(rotation_tolerance(rules, 8, 0.1905)->rule, "PFI ES-3 3.1, along the bolt circle");
  EXPECT_EQ(rotation_tolerance(rules, 4, 0.1207)->rule, "PFI ES-3 3.1, level across two holes");
  rules.rotation_reading = RotationReading::kArc;
  EXPECT_NEAR(rotation_tolerance(rules, 4, 0.1207)->value / kDegree, 1.507, 0.001);
  rules.rotation_reading = RotationReading::kLevel;
  EXPECT_NEAR(rotation_tolerance(rules, 8, 0.1905)->value / kDegree, 1.248, 0.001);
  EXPECT_FALSE(rotation_tolerance(rules, 8, 0)) << "of no known circle";
}

TEST(Iso13920, RotationIsAnAngleOverTheBoltCircle) {
  EXPECT_NEAR(rotation_tolerance(iso_13920('B', 'F'), 8, 0.1905)->value / kDegree, 0.75, 1e-9);
  EXPECT_NEAR(rotation_tolerance(iso_13920('B', 'F'), 20, 0.7493)->value / kDegree, 0.5, 1e-9);
  EXPECT_FALSE(rotation_tolerance(RuleSet{}, 8, 0.1905));
}

TEST(PfiEs3, ExemptsFittingToFittingOnlyWhereAsked) {
  RuleSet rules = pfi_es3();
  EXPECT_DOUBLE_EQ(length_tolerance(rules, 4, 0.3, 2)->value, 0.003);
  rules.fitting_allowance_m = 0.002;
  EXPECT_DOUBLE_EQ(length_tolerance(rules, 4, 0.3, 0)->value, 0.003);
  EXPECT_DOUBLE_EQ(length_tolerance(rules, 4, 0.3, 2)->value, 0.007);
  EXPECT_NE(length_tolerance(rules, 4, 0.3, 2)->rule.find("fitting to fitting"), std::string::npos);
}

TEST(Iso13920, LengthsOfEveryClassAtEveryLimit) {
  const double limits[] = {0.030, 0.120, 0.400, 1, 2, 4, 8, 12, 16, 20};
  const double mm[4][11] = {{1, 1, 1, 2, 3, 4, 5, 6, 7, 8, 9},
                            {1, 2, 2, 3, 4, 6, 8, 10, 12, 14, 16},
                            {1, 3, 4, 6, 8, 11, 14, 18, 21, 24, 27},
                            {1, 4, 7, 9, 12, 16, 21, 27, 32, 36, 40}};
  for (int c = 0; c < 4; ++c) {
    const RuleSet rules = iso_13920(static_cast<char>('A' + c), 'F');
    for (int i = 0; i < 10; ++i) {
      const double at = limits[i];
      EXPECT_NEAR(1000 * length_tolerance(rules, 4, at)->value, mm[c][i], 1e-9) << c << " " << at;
      EXPECT_NEAR(1000 * length_tolerance(rules, 4, at - 1e-6)->value, mm[c][i], 1e-9) << at;
      EXPECT_NEAR(1000 * length_tolerance(rules, 4, at + 1e-6)->value, mm[c][i + 1], 1e-9) << at;
    }
    EXPECT_EQ(length_tolerance(rules, 4, 1)->rule,
              std::string("ISO 13920-") + static_cast<char>('A' + c) + "F table 1, class " +
                  static_cast<char>('A' + c));
  }
}

TEST(Iso13920, AnglesByTheShorterLeg) {
  const double minutes[4][3] = {{20, 15, 10}, {45, 30, 20}, {60, 45, 30}, {90, 75, 60}};
  for (int c = 0; c < 4; ++c) {
    const RuleSet rules = iso_13920(static_cast<char>('A' + c), 'E');
    const double legs[] = {0.1, 0.4, 0.400001, 1.0, 1.000001, 5};
    const int row[] = {0, 0, 1, 1, 2, 2};
    for (int i = 0; i < 6; ++i)
      EXPECT_NEAR(angle_tolerance(rules, legs[i], 0.1)->value / kDegree * 60, minutes[c][row[i]],
                  1e-9)
          << c << " " << legs[i];
  }
}

TEST(Iso13920, FormByTheFacesOwnSize) {
  const double limits[] = {0.120, 0.400, 1, 2, 4, 8, 12, 16, 20};
  const double mm[4][10] = {{0.5, 1, 1.5, 2, 3, 4, 5, 6, 7, 8},
                            {1, 1.5, 3, 4.5, 6, 8, 10, 12, 14, 16},
                            {1.5, 3, 5.5, 9, 11, 16, 20, 22, 25, 25},
                            {2.5, 5, 9, 14, 18, 26, 32, 36, 40, 40}};
  for (int c = 0; c < 4; ++c) {
    const RuleSet rules = iso_13920('B', static_cast<char>('E' + c));
    for (int i = 0; i < 9; ++i)
      for (const double at : {limits[i], limits[i] + 1e-6})
        EXPECT_NEAR(1000 * alignment_tolerance(rules, at)->value * at,
                    mm[c][at > limits[i] ? i + 1 : i], 1e-9)
            << c << " " << at;
  }
}

TEST(Standards, AreKnownByName) {
  EXPECT_EQ(standard_rules("pfi-es3")->name, "PFI ES-3");
  EXPECT_EQ(standard_rules("iso-13920-BF")->name, "ISO 13920-BF");
  EXPECT_EQ(standard_rules("iso-13920-DH")->name, "ISO 13920-DH");
  for (const char* other :
       {"", "iso-13920", "iso-13920-B", "iso-13920-EF", "iso-13920-BA", "iso-13920-BFF", "pfi"})
    EXPECT_FALSE(standard_rules(other)) << other;
}

}  // namespace
}  // namespace spool
