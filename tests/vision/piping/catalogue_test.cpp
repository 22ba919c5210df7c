// The catalogue against the rules that its standards follow and a second table typed from them.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/piping/catalogue.h"

#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "tools/campaign/standard_sizes.h"

namespace spool::piping {
namespace {

constexpr double kInch = 0.0254;
constexpr std::array kWithFittings{0.5, 0.75, 1.0, 1.25, 1.5,  2.0,  2.5,  3.0,  3.5,  4.0,
                                   5.0, 6.0,  8.0, 10.0, 12.0, 14.0, 16.0, 18.0, 20.0, 24.0};

TEST(Catalogue, WeighsWhatTheStandardPrints) {
  // B36.10M, plain end mass of STD pipe, kg/m: diameter and wall together.
  constexpr std::array<double, 20> kMass{1.27,  1.69,  2.50,  3.39,   4.05,   5.44,  8.63,
                                         11.29, 13.57, 16.08, 21.77,  28.26,  42.55, 60.29,
                                         73.86, 81.33, 93.27, 105.17, 117.15, 141.12};
  for (std::size_t i = 0; i < kMass.size(); ++i) {
    const double nps = kWithFittings[i];
    const double od = pipe_size(nps)->outside_diameter * 1000;
    const double wall = *wall_thickness(nps, "STD") * 1000;
    // Half of the mass's last digit, and what half of the last digit of a wall of 2.77 mm makes.
    EXPECT_NEAR(0.0246615 * (od - wall) * wall, kMass[i], 0.005 + 0.002 * kMass[i])
        << "NPS " << nps;
  }
}

TEST(Catalogue, SchedulesAreTheWeightsWhereTheStandardSaysSo) {
  for (const double nps : kWithFittings) {
    if (nps <= 10) {
      EXPECT_EQ(*wall_thickness(nps, "40"), *wall_thickness(nps, "STD")) << nps;
    }
    if (nps <= 8) {
      EXPECT_EQ(*wall_thickness(nps, "SCH 80"), *wall_thickness(nps, "xs")) << nps;
    }
    if (nps > 10) {
      EXPECT_DOUBLE_EQ(*wall_thickness(nps, "STD"), 0.00953) << nps;
    }
    EXPECT_EQ(*wall_thickness(nps, "40S"), *wall_thickness(nps, "STD")) << nps;
  }
}

TEST(Catalogue, WallsGrowWithTheSchedule) {
  for (const double nps : kWithFittings) {
    double last = 0;
    for (const char* schedule :
         {"5S", "10S", "20", "30", "40", "60", "80", "100", "120", "140", "160"}) {
      const auto wall = wall_thickness(nps, schedule);
      if (!wall) continue;  // not made in this size
      EXPECT_GT(*wall, last) << "NPS " << nps << " schedule " << schedule;
      last = *wall;
    }
    EXPECT_LT(last, pipe_size(nps)->outside_diameter / 2);
  }
}

TEST(Catalogue, ElbowsAreBentToTheirRadius) {
  for (const double nps : kWithFittings) {
    const FittingSize size = *fitting_size(nps);
    if (nps >= 1) {  // 38 mm at NPS 1/2 and 3/4 is an exception of the standard
      // B16.9 prints whole millimetres: half of one, and half more of the inch fraction's.
      EXPECT_NEAR(size.elbow_90_long, 1.5 * nps * kInch, 0.0011) << "NPS " << nps;
      EXPECT_NEAR(size.elbow_90_short, nps * kInch, 0.0011) << "NPS " << nps;
    }
    if (nps >= 4) {  // 45s of smaller sizes are longer than their arc
      const double arc = size.elbow_45 / std::tan(std::numbers::pi / 8);
      EXPECT_NEAR(arc, size.elbow_90_long, 0.02 * size.elbow_90_long) << "NPS " << nps;
    }
  }
}

TEST(Catalogue, FlangesAreWholeSixteenthsOfAnInch) {
  for (const int rating : {150, 300}) {
    for (const double nps : kWithFittings) {
      const FlangeSize size = *flange_size(nps, rating);
      for (const double length :
           {size.outside_diameter, size.thickness, size.raised_face, size.bolt_circle, size.hole,
            size.hub, size.weld_neck, size.slip_on}) {
        const double sixteenths = length / (kInch / 16);
        // Printed to a tenth of a millimetre, 0.063 of a sixteenth.
        EXPECT_NEAR(sixteenths, std::round(sixteenths), 0.064)
            << "NPS " << nps << " class " << rating << ", " << length;
      }
    }
  }
}

TEST(Catalogue, FlangesHaveRoomForTheirBolts) {
  for (const int rating : {150, 300}) {
    for (const double nps : kWithFittings) {
      const FlangeSize size = *flange_size(nps, rating);
      const std::string where = "NPS " + nps_text(nps) + " class " + std::to_string(rating);
      EXPECT_EQ(size.holes % 4, 0) << where;
      EXPECT_LT(size.bolt_circle + size.hole, size.outside_diameter) << where;
      EXPECT_GT(size.bolt_circle - size.hole, size.hub) << where;
      EXPECT_GT(size.bolt_circle - size.hole, size.raised_face) << where;
      EXPECT_GT(size.hub, pipe_size(nps)->outside_diameter) << where;
      EXPECT_GT(size.weld_neck, size.slip_on) << where;
      EXPECT_GT(size.slip_on, size.thickness) << where;
    }
  }
}

TEST(Catalogue, AgreesWithTheTableTypedAgainForScenes) {
  constexpr double kPrinted = 5e-5;  // m, both are printed to a tenth of a millimetre
  for (const campaign::StandardSizes& other : campaign::standard_sizes()) {
    const FittingSize fitting = *fitting_size(other.nps);
    const FlangeSize flange = *flange_size(other.nps, 150);
    EXPECT_NEAR(pipe_size(other.nps)->outside_diameter, other.outside_diameter, kPrinted);
    EXPECT_NEAR(*wall_thickness(other.nps, "STD"), other.wall, kPrinted);
    EXPECT_NEAR(fitting.elbow_90_long, other.elbow_90, kPrinted);
    EXPECT_NEAR(fitting.elbow_45, other.elbow_45, kPrinted);
    EXPECT_NEAR(fitting.tee, other.tee, kPrinted);
    EXPECT_NEAR(fitting.cap, other.cap, kPrinted);
    EXPECT_NEAR(fitting.reducer, other.reducer, kPrinted);
    EXPECT_NEAR(flange.outside_diameter, other.flange_diameter, kPrinted);
    EXPECT_NEAR(flange.thickness, other.flange_thickness, kPrinted);
    EXPECT_NEAR(flange.bolt_circle, other.bolt_circle, kPrinted);
    EXPECT_EQ(flange.holes, other.holes);
    EXPECT_NEAR(flange.hole, other.hole, kPrinted);
    EXPECT_NEAR(flange.weld_neck, other.weld_neck, kPrinted);
  }
}

TEST(Catalogue, SaysWhichSizeItDoesNotHold) {
  const auto said = [](const Error& error) { return error.message; };
  EXPECT_EQ(said(pipe_size(22).error()),
            "pipe of NPS 22 is not in the catalogue, which holds NPS 1/8 to 24 (ASME B36.10M)");
  EXPECT_NE(said(flange_size(30, 150).error()).find("class 150 of NPS 30"), std::string::npos);
  EXPECT_NE(said(flange_size(4, 600).error()).find("class 600 of NPS 4"), std::string::npos);
  EXPECT_NE(said(wall_thickness(3, "140").error()).find("schedule '140' of NPS 3"),
            std::string::npos);
  EXPECT_NE(said(tee_outlet(4, 1).error()).find("branch of NPS 1 of NPS 4"), std::string::npos);
  EXPECT_FALSE(fitting_size(0.25));
}

TEST(Catalogue, KnowsAPipeByItsDiameter) {
  EXPECT_EQ(nps_of_outside_diameter(0.2731), 10);  // catalogues print 273.0 and 273.1
  EXPECT_EQ(nps_of_outside_diameter(0.0603), 2);
  EXPECT_EQ(nps_of_outside_diameter(0.0610), std::nullopt);
}

TEST(Catalogue, WritesSizesAsOnDrawings) {
  EXPECT_EQ(nps_text(1.5), "1-1/2");
  EXPECT_EQ(nps_text(0.75), "3/4");
  EXPECT_EQ(nps_text(10), "10");
}

}  // namespace
}  // namespace spool::piping
