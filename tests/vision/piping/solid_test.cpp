// Solids against formulas that share nothing with their triangles: closed, right volume, and
// inside where a formula of cylinders says so.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/piping/solid.h"

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "tests/vision/piping/solid_checks.h"
#include "vision/piping/branch_solid.h"
#include "vision/piping/catalogue.h"
#include "vision/piping/flange_solid.h"

namespace spool::piping {
namespace {

using Eigen::Vector3d;
using test::disagreements;
using test::fault_of;

constexpr double kPi = std::numbers::pi;
// Chords lie up to 0.1 mm inside their circles (kChordError), facets of meeting curves twice that.
constexpr double kMargin = 0.0003;
constexpr std::array kSizes{0.5, 0.75, 1.0, 1.25, 1.5,  2.0,  2.5,  3.0,  3.5,  4.0,
                            5.0, 6.0,  8.0, 10.0, 12.0, 14.0, 16.0, 18.0, 20.0, 24.0};

// Inside a cylinder about a line through the origin, from `from` to `to` along it.
bool in_cylinder(const Vector3d& p, const Vector3d& axis, double radius, double from, double to) {
  const double along = p.dot(axis);
  return along > from && along < to && (p - along * axis).norm() < radius;
}

Station at(double z, double outer, double inner) {
  Station station;
  station.frame.translation().z() = z;
  station.outer = outer;
  station.inner = inner;
  return station;
}

TEST(Solid, TubeHasTheVolumeOfItsRing) {
  Solid tube;
  add_tube(tube, std::array{at(0, 0.0571, 0.0511), at(0.4, 0.0571, 0.0511)});
  EXPECT_EQ(fault_of(tube), "");
  const double ring = kPi * (0.0571 * 0.0571 - 0.0511 * 0.0511) * 0.4;
  // A polygon of n sides has sin(2 pi / n) / (2 pi / n) of its circle's area: 0.4 % of the discs,
  // which of a thin ring may be twice that.
  EXPECT_NEAR(test::volume(tube), ring, 0.008 * ring);
}

TEST(Solid, RodIsClosedByDiscs) {
  Solid rod;
  add_tube(rod, std::array{at(0, 0.03, 0), at(0.1, 0.02, 0)});
  EXPECT_EQ(fault_of(rod), "");
  const double cone = kPi * 0.1 / 3 * (0.03 * 0.03 + 0.03 * 0.02 + 0.02 * 0.02);
  EXPECT_NEAR(test::volume(rod), cone, 0.006 * cone);
}

TEST(Solid, MoreSidesTheLargerTheCircle) {
  for (const double radius : {0.01, 0.05, 0.3}) {
    const int sides = sides_of(radius);
    EXPECT_EQ(sides % 4, 0);
    if (sides > 24) {
      EXPECT_LE(radius * (1 - std::cos(kPi / sides)), kChordError);
    }
  }
}

struct TeeCase {
  const char* name;
  double run, run_inner, outlet, outlet_inner, angle;
  bool is_cross;
};

TEST(BranchedRun, IsTwoCylindersLessTheirBores) {
  const TeeCase cases[] = {
      {"straight", 0.0571, 0.0511, 0.0571, 0.0511, kPi / 2, false},
      {"reducing", 0.0571, 0.0511, 0.0302, 0.0263, kPi / 2, false},
      {"cross", 0.0571, 0.0511, 0.0571, 0.0511, kPi / 2, true},
      {"reducing cross", 0.0571, 0.0511, 0.0302, 0.0263, kPi / 2, true},
      {"lateral", 0.0571, 0.0511, 0.0445, 0.039, kPi / 4, false},
  };
  for (const TeeCase& each : cases) {
    const double down = 0.12, up = 0.25, length = 0.26;
    std::vector<Outlet> outlets{{each.outlet, each.outlet_inner, length, each.angle, false}};
    if (each.is_cross)
      outlets.push_back({each.outlet, each.outlet_inner, length, each.angle, true});
    Solid tee;
    ASSERT_TRUE(add_branched_run(tee, {each.run, each.run_inner, down, up}, outlets)) << each.name;
    EXPECT_EQ(fault_of(tee), "") << each.name;
    const auto inside = [&](const Vector3d& p) {
      bool in_steel = in_cylinder(p, Vector3d::UnitZ(), each.run, -down, up);
      bool in_bore = in_cylinder(p, Vector3d::UnitZ(), each.run_inner, -down, up);
      for (const Outlet& outlet : outlets) {
        const double side = outlet.opposite ? -1 : 1;
        const Vector3d axis(side * std::sin(outlet.angle), 0, std::cos(outlet.angle));
        in_steel = in_steel || in_cylinder(p, axis, outlet.outer, 0, length);
        in_bore = in_bore || in_cylinder(p, axis, outlet.inner, 0, length);
      }
      return in_steel && !in_bore;
    };
    EXPECT_EQ(disagreements(tee, kMargin, inside), 0) << each.name;
  }
}

TEST(BranchedRun, RefusesWhatCannotBe) {
  Solid none;
  const RunTube run{0.0571, 0.0511, 0.105, 0.105};
  const auto refused = [&](const Outlet& outlet) {
    return !add_branched_run(none, run, std::array{outlet});
  };
  EXPECT_TRUE(refused({0.06, 0.05, 0.105, kPi / 2, false})) << "wider than its run";
  EXPECT_TRUE(refused({0.0571, 0.0511, 0.05, kPi / 2, false})) << "ends inside the run";
  EXPECT_TRUE(refused({0.0571, 0.0511, 0.3, kPi / 4, false})) << "cuts past the run's end";
  EXPECT_TRUE(none.vertices.empty());
}

TEST(BranchedRun, EveryTeeOfTheCatalogueIsClosed) {
  for (const double nps : kSizes) {
    const double outer = pipe_size(nps)->outside_diameter / 2;
    const double inner = outer - *wall_thickness(nps, "STD");
    const double c = fitting_size(nps)->tee;
    Solid tee;
    ASSERT_TRUE(add_branched_run(tee, {outer, inner, c, c},
                                 std::array{Outlet{outer, inner, c, kPi / 2, false}}))
        << nps;
    EXPECT_EQ(fault_of(tee), "") << "NPS " << nps;
  }
}

TEST(SaddleBranch, SitsOnItsRunAndNotInIt) {
  for (const double angle : {kPi / 2, kPi / 4}) {
    const double run = 0.0571, end = 0.0167, base = 0.0234, bore = 0.0133, length = 0.13;
    Solid olet;
    ASSERT_TRUE(add_saddle_branch(olet, run, base, {end, bore, length, angle, false}));
    EXPECT_EQ(fault_of(olet), "");
    for (const Vector3d& vertex : olet.vertices)
      EXPECT_GT(std::hypot(vertex.x(), vertex.y()), run - 1e-9) << "into the run";
    const Vector3d axis(std::sin(angle), 0, std::cos(angle));
    const double at_end = length - 0.002;
    EXPECT_NEAR(test::winding(olet, at_end * axis), 0, 1e-6) << "the bore is open";
    EXPECT_NEAR(test::winding(olet, at_end * axis + (bore + end) / 2 * Vector3d::UnitY()), 1, 1e-6);
  }
}

TEST(Flange, EveryFlangeOfTheCatalogueIsClosedAndHasItsHoles) {
  for (const int rating : {150, 300}) {
    for (const double nps : kSizes) {
      const FlangeSize size = *flange_size(nps, rating);
      const double od = pipe_size(nps)->outside_diameter;
      const double bore = od - 2 * *wall_thickness(nps, "STD");
      const FlangeBody bodies[] = {
          {size.weld_neck, od, bore, 0, 0, true},
          {size.slip_on, size.hub, od + 0.0016, 0, 0, true},
          {size.slip_on, size.hub, bore, od + 0.0016, size.slip_on / 2, true},
          {size.slip_on, size.hub, od + 0.0024, 0, 0, false},
          {size.thickness, 0, 0, 0, 0, true},
      };
      for (const FlangeBody& body : bodies) {
        Solid flange;
        add_flange(flange, size, body);
        ASSERT_EQ(fault_of(flange), "") << "NPS " << nps << " class " << rating;
        // Half way through the plate: steel between the holes, air in each.
        for (int k = 0; k < size.holes; ++k) {
          const double hole = kPi / size.holes * (2 * k + 1);
          const double between = kPi / size.holes * (2 * k);
          const auto at_angle = [&](double angle) {
            return Vector3d(size.bolt_circle / 2 * std::cos(angle),
                            size.bolt_circle / 2 * std::sin(angle), -size.thickness / 2);
          };
          if (nps != 4 && k > 0) continue;  // the winding of all holes of all sizes takes minutes
          EXPECT_NEAR(test::winding(flange, at_angle(hole)), 0, 1e-6);
          EXPECT_NEAR(test::winding(flange, at_angle(between)), 1, 1e-6);
        }
      }
    }
  }
}

TEST(Flange, IsPlateHubFaceAndBore) {
  const FlangeSize size = *flange_size(4, 150);
  const double od = 0.1143, bore = 0.1023;
  Solid flange;
  add_flange(flange, size, {size.weld_neck, od, bore, 0, 0, true});
  const double cone = size.weld_neck - 0.006 - size.thickness;  // hub above its land
  const auto inside = [&](const Vector3d& p) {
    const double radius = std::hypot(p.x(), p.y());
    if (radius < bore / 2 || p.z() > 0 || p.z() < -size.weld_neck) return false;
    if (p.z() > -kRaisedFaceHeight) return radius < size.raised_face / 2;
    if (p.z() > -size.thickness) {
      for (int k = 0; k < size.holes; ++k) {
        const double turn = kPi / size.holes * (2 * k + 1);
        const double dx = p.x() - size.bolt_circle / 2 * std::cos(turn);
        const double dy = p.y() - size.bolt_circle / 2 * std::sin(turn);
        if (std::hypot(dx, dy) < size.hole / 2) return false;
      }
      return radius < size.outside_diameter / 2;
    }
    const double down = (-size.thickness - p.z()) / cone;
    return radius < (down < 1 ? size.hub + down * (od - size.hub) : od) / 2;
  };
  EXPECT_EQ(disagreements(flange, kMargin, inside, 1500), 0);
}

}  // namespace
}  // namespace spool::piping
