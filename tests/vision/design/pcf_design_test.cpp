// Piping files as designs: bodies of every kind closed and where the file says, joints that meet.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "tests/support/refusal.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/write_file.h"
#include "tests/vision/piping/pcf_samples.h"
#include "tests/vision/piping/solid_checks.h"
#include "vision/design/design_reader.h"
#include "vision/piping/catalogue.h"

namespace spool {
namespace {

using Eigen::Vector3d;
using test::pcf;
using test::replaced;
using test::spool_pcf;

class PcfDesign : public testing::Test {
 protected:
  DesignModel good(const std::string& text, std::optional<LengthUnit> unit = std::nullopt) {
    const auto design = read_design(test::write_file(folder_.path() / "spool.pcf", text), unit);
    EXPECT_TRUE(design.has_value()) << (design ? "" : design.error().message);
    return design ? *design : DesignModel{};
  }
  test::TemporaryFolder folder_;
};

const Part& part_named(const DesignModel& design, const std::string& name) {
  for (const Part& part : design.parts) {
    if (part.name == name) return part;
  }
  ADD_FAILURE() << "no part " << name;
  return design.parts.front();
}

const Port& port_named(const Part& part, const std::string& name) {
  for (const Port& port : part.ports) {
    if (port.name == name) return port;
  }
  ADD_FAILURE() << part.name << " has no port " << name;
  return part.ports.front();
}

// A part's own triangles, design frame.
piping::Solid solid_of(const DesignModel& design, const Part& part) {
  piping::Solid solid;
  for (const Eigen::Vector3f& vertex : design.mesh.vertices)
    solid.vertices.push_back(vertex.cast<double>());
  const auto first = design.mesh.triangles.begin() + part.first_triangle;
  solid.triangles.assign(first, first + part.triangle_count);
  return solid;
}

bool warns(const DesignModel& design, const std::string& what) {
  for (const std::string& warning : design.warnings) {
    if (warning.find(what) != std::string::npos) return true;
  }
  return false;
}

TEST_F(PcfDesign, HasEveryPartWithAClosedBody) {
  const DesignModel design = good(spool_pcf());
  EXPECT_TRUE(design.warnings.empty()) << design.warnings.front();
  ASSERT_EQ(design.parts.size(), 14u);
  for (const Part& part : design.parts)
    EXPECT_EQ(test::fault_of(solid_of(design, part)), "") << part.name;
  EXPECT_EQ(part_named(design, "olet-1").kind, PartKind::kOlet);
  EXPECT_EQ(part_named(design, "olet-1").nps, 2);
  EXPECT_EQ(part_named(design, "olet-1").nps2, 0.75);
  EXPECT_EQ(part_named(design, "tee-1").nps2, 2);
  EXPECT_EQ(part_named(design, "pipe-1").schedule, "40");
  EXPECT_EQ(part_named(design, "pipe-1").heat, "H-77");
  EXPECT_EQ(part_named(design, "pipe-1").spool, "SP1");
  EXPECT_EQ(part_named(design, "flange-2").rating, "150");
  EXPECT_EQ(design.line, "10-3-PL-3259-002");
  EXPECT_EQ(design.revision, "2");
  EXPECT_FALSE(design.unit_inferred);
}

TEST_F(PcfDesign, JoinsPortsThatMeetFaceToFace) {
  const DesignModel design = good(spool_pcf());
  EXPECT_EQ(design.joints.size(), 13u);
  int welds = 0;
  for (const Joint& joint : design.joints) {
    const Part& a = design.parts[static_cast<std::size_t>(joint.part_a)];
    const Part& b = design.parts[static_cast<std::size_t>(joint.part_b)];
    const Port& from = a.ports[static_cast<std::size_t>(joint.port_a)];
    const Port& to = b.ports[static_cast<std::size_t>(joint.port_b)];
    const std::string where = a.name + "/" + from.name + " to " + b.name + "/" + to.name;
    // The file's own digits: a ten-thousandth of a millimetre in each of three.
    EXPECT_NEAR((a.T_design_part * from.position - b.T_design_part * to.position).norm(), 0, 2e-7)
        << where;
    // The 45's end points are rounded; over its leg of 35 mm that turns its ports by a microradian.
    EXPECT_NEAR(
        (a.T_design_part.linear() * from.direction).dot(b.T_design_part.linear() * to.direction),
        -1, 1e-9)
        << where;
    if (!joint.weld.empty()) ++welds;
    if (joint.weld == "FW-7") {
      EXPECT_EQ(joint.type, JointType::kField);
    }
  }
  EXPECT_EQ(welds, 11);
}

TEST_F(PcfDesign, StandsWithItsUpAlongY) {
  const DesignModel design = good(spool_pcf());
  const Part& cap = part_named(design, "cap-1");
  // E 1500, N 2500, up 776 mm.
  const Vector3d at = cap.T_design_part * port_named(cap, "weld").position + design.origin;
  EXPECT_NEAR((at - Vector3d(1.5, 0.776, -2.5)).norm(), 0, 1e-9);
  EXPECT_NEAR((cap.T_design_part.linear().col(2) - Vector3d::UnitY()).norm(), 0, 1e-9);
}

TEST_F(PcfDesign, HasItsMetalWhereTheStandardsPutIt) {
  const DesignModel design = good(spool_pcf());
  // Every vertex of a pipe lies on its outside or its bore, every one of the elbow on its torus.
  const Part& pipe = part_named(design, "pipe-1");
  for (const Triangle& t : solid_of(design, pipe).triangles) {
    const Vector3d p = pipe.T_design_part.inverse() * design.mesh.vertices[t[0]].cast<double>();
    const double radius = std::hypot(p.x(), p.y());
    EXPECT_LT(std::min(std::abs(radius - 0.04445), std::abs(radius - 0.04445 + 0.00549)), 1e-6);
  }
  const Part& elbow = part_named(design, "elbow-1");
  for (const Triangle& t : solid_of(design, elbow).triangles) {
    const Vector3d p = design.mesh.vertices[t[0]].cast<double>() + design.origin;
    // Bent about E 1386, N 2114, up 500 with 114 mm.
    const Vector3d from_centre = p - Vector3d(1.386, 0.5, -2.114);
    const double to_tube =
        std::hypot(std::hypot(from_centre.x(), from_centre.z()) - 0.114, from_centre.y());
    EXPECT_LT(std::min(std::abs(to_tube - 0.04445), std::abs(to_tube - 0.03896)), 1e-6);
  }
}

TEST_F(PcfDesign, BoltsFlangesTwoHoledOnTheNaturalLines) {
  const DesignModel design = good(spool_pcf());
  const Part& flange = part_named(design, "flange-1");
  ASSERT_TRUE(flange.holes);
  EXPECT_EQ(flange.holes->count, 4);
  EXPECT_NEAR(flange.holes->bolt_circle_m, 0.1524, 1e-9);
  // Its face looks west, the first hole stands half a pitch from straight up.
  EXPECT_NEAR((flange.T_design_part.linear().col(2) + Vector3d::UnitX()).norm(), 0, 1e-9);
  EXPECT_NEAR((flange.T_design_part.linear().col(0) - Vector3d::UnitY()).norm(), 0, 1e-9);
  EXPECT_NEAR((port_named(flange, "face").direction - Vector3d::UnitZ()).norm(), 0, 1e-9);
  const piping::Solid solid = solid_of(design, flange);
  for (int k = 0; k < 2 * flange.holes->count; ++k) {
    const double angle = flange.holes->clocking_rad + k * std::numbers::pi / flange.holes->count;
    const Vector3d at(flange.holes->bolt_circle_m / 2 * std::cos(angle),
                      flange.holes->bolt_circle_m / 2 * std::sin(angle), -0.012);
    EXPECT_NEAR(test::winding(solid, flange.T_design_part * at), k % 2 == 0 ? 0 : 1, 1e-4) << k;
  }
}

TEST_F(PcfDesign, MarksTapsSpindlesAndFlatSides) {
  const DesignModel design = good(spool_pcf());
  const Part& orifice = part_named(design, "flange-2");
  ASSERT_EQ(orifice.marks.size(), 1u);
  EXPECT_EQ(orifice.marks[0].type, "tap");
  // Away from the axis, to the east.
  EXPECT_NEAR((orifice.T_design_part.linear() * orifice.marks[0].direction).x(), 1, 0.01);
  EXPECT_EQ(part_named(design, "valve-1").marks.at(0).type, "spindle");
  const Part& reducer = part_named(design, "reducer-1");
  ASSERT_EQ(reducer.marks.size(), 1u);
  EXPECT_EQ(reducer.marks[0].type, "flat_side");
  // Flat below: there its outside runs level, so its lowest points are at one height.
  const piping::Solid solid = solid_of(design, reducer);
  double at_large = 1e9, at_small = 1e9;
  for (const Triangle& t : solid.triangles) {
    const Vector3d p = solid.vertices[t[0]] + design.origin;
    if (p.z() > -2.5861) at_large = std::min(at_large, p.y());
    if (p.z() < -2.6749) at_small = std::min(at_small, p.y());
  }
  EXPECT_NEAR(at_large, at_small, 1e-5);
}

TEST_F(PcfDesign, IsHeldByItsWidestOpenFace) {
  const DesignModel design = good(spool_pcf());
  ASSERT_EQ(design.datums.size(), 1u);
  EXPECT_EQ(design.parts[static_cast<std::size_t>(design.datums[0])].name, "flange-1");
}

TEST_F(PcfDesign, LosesNothingFarFromThePlantsOrigin) {
  const DesignModel near = good(spool_pcf());
  std::string far = spool_pcf();
  // 5 650 000 m north: where float steps are half a metre.
  for (const char* north :
       {"2000.0", "2114.0", "2414.0", "2500.0", "2586.0", "2675.0", "2875.0", "2910.0", "2934.7487",
        "2979.6500", "2981.7713", "3107.6363", "2775.0", "2972.9", "2250.0"})
    far = replaced(far, std::string(" ") + north, std::string(" 565000") + north);
  const DesignModel moved = good(far);
  ASSERT_EQ(moved.mesh.vertices.size(), near.mesh.vertices.size());
  EXPECT_LT(moved.origin.z(), -5000);
  const Vector3d shift = moved.parts[0].T_design_part.translation() + moved.origin -
                         near.parts[0].T_design_part.translation() - near.origin;
  for (std::size_t v = 0; v < near.mesh.vertices.size(); v += 97) {
    const Vector3d a = near.mesh.vertices[v].cast<double>() + near.origin + shift;
    const Vector3d b = moved.mesh.vertices[v].cast<double>() + moved.origin;
    EXPECT_NEAR((a - b).norm(), 0, 1e-6);
  }
}

TEST_F(PcfDesign, DrawsEveryKindOfComponent) {
  const struct {
    const char* what;
    const char* record;
    std::size_t parts;
    const char* warning;  // "" where its own shape is drawn
  } cases[] = {
      {"blind by one end", "FLANGE-BLIND\n  END-POINT 1000 0 0 4 FL\n  SKEY FLBL\n", 0,
       "FLANGE-BLIND"},
      {"slip-on", "FLANGE\n  END-POINT 990 0 0 4 BW\n  END-POINT 1000 0 0 4 FL\n  SKEY FLSO\n", 1,
       ""},
      {"socket weld", "FLANGE\n  END-POINT 980 0 0 2 SW\n  END-POINT 1000 0 0 2 FL\n  SKEY FLSW\n",
       1, ""},
      {"threaded", "FLANGE\n  END-POINT 980 0 0 2 SC\n  END-POINT 1000 0 0 2 FL\n  SKEY FLSC\n", 1,
       ""},
      {"lap joint ring", "LAPJOINT-RING\n  END-POINT 980 0 0 4\n  END-POINT 1000 0 0 4 FL\n", 1,
       ""},
      {"stub end", "LAPJOINT-STUBEND\n  END-POINT 900 0 0 4 BW\n  END-POINT 1000 0 0 4 FL\n", 1,
       ""},
      {"class 600",
       "FLANGE\n  END-POINT 900 0 0 4 BW\n  END-POINT 1000 0 0 4 FL\n  ITEM-DESCRIPTION WN CL600\n",
       1, "plain body"},
      {"cross",
       "CROSS\n  END-POINT 895 0 0 4\n  END-POINT 1105 0 0 4\n  CENTRE-POINT 1000 0 0\n  "
       "BRANCH1-POINT 1000 "
       "105 0 4\n  BRANCH2-POINT 1000 -105 0 4\n",
       1, ""},
      {"lateral",
       "TEE\n  END-POINT 900 0 0 4\n  END-POINT 1400 0 0 4\n  CENTRE-POINT 1000 0 0\n  "
       "BRANCH1-POINT 1282.8 "
       "282.8 0 4\n",
       1, ""},
      {"stub-in",
       "TEE-STUB\n  END-POINT 1000 0 0 4\n  END-POINT 1000 0 0 4\n  CENTRE-POINT 1000 0 0\n  "
       "BRANCH1-POINT "
       "1000 0 200 2\nPIPE\n  END-POINT 0 0 0 4\n  END-POINT 1000 0 0 4\n",
       2, ""},
      {"reducing elbow",
       "ELBOW-REDUCING\n  END-POINT 848 0 0 4\n  END-POINT 1000 152 0 3\n  CENTRE-POINT 1000 0 0\n",
       1, ""},
      {"bend with tangents",
       "BEND\n  END-POINT 400 0 0 4\n  END-POINT 1000 600 0 4\n  CENTRE-POINT 1000 0 0\n  "
       "BEND-RADIUS 343\n",
       1, ""},
      {"mitre", "BEND\n  END-POINT 960 0 0 4\n  END-POINT 1000 40 0 4\n  CENTRE-POINT 1000 0 0\n",
       1, "plain body"},
      {"cap by two ends",
       "CAP\n  END-POINT 1000 0 0 4 BW\n  END-POINT 1064 0 0 4\nPIPE\n  END-POINT 0 0 0 4\n  "
       "END-POINT 1000 0 0 4\n",
       2, ""},
      {"angle valve",
       "VALVE-ANGLE\n  END-POINT 900 0 0 4 FL\n  END-POINT 1000 100 0 4 FL\n  CENTRE-POINT 1000 0 "
       "0\n",
       1, ""},
      {"instrument", "INSTRUMENT\n  END-POINT 900 0 0 4\n  END-POINT 1000 0 0 4\n  SKEY OPFL\n", 1,
       ""},
      {"coupling", "COUPLING\n  END-POINT 980 0 0 1 SW\n  END-POINT 1000 0 0 1 SW\n", 1, ""},
      {"concentric reducer", "REDUCER-CONCENTRIC\n  END-POINT 898 0 0 4\n  END-POINT 1000 0 0 3\n",
       1, ""},
      {"unlisted pipe", "PIPE\n  END-POINT 0 0 0 30\n  END-POINT 1000 0 0 30\n", 1, ""},
      {"pipe of no length",
       "PIPE\n  END-POINT 5 0 0 4\n  END-POINT 5 0 0 4\nPIPE\n  END-POINT 5 0 0 4\n  END-POINT 900 "
       "0 0 4\n",
       1, "has no length or no bore"},
  };
  for (const auto& each : cases) {
    SCOPED_TRACE(each.what);
    const auto path = test::write_file(folder_.path() / "one.pcf", pcf(each.record));
    const auto design = read_design(path);
    if (each.parts == 0) {  // alone nothing tells which way it looks
      test::expect_refused(design, ErrorCode::kBadInput, "one.pcf", "no surface");
      continue;
    }
    ASSERT_TRUE(design) << design.error().message;
    EXPECT_EQ(design->parts.size(), each.parts);
    for (const Part& part : design->parts)
      EXPECT_EQ(test::fault_of(solid_of(*design, part)), "") << part.name;
    EXPECT_EQ(warns(*design, "plain body") || warns(*design, "no length"), *each.warning != '\0');
    if (*each.warning != '\0') {
      EXPECT_TRUE(warns(*design, each.warning));
    }
  }
}

TEST_F(PcfDesign, BendsASlightBendToItsSide) {
  // By one degree to the south, a metre either side of its centre.
  const DesignModel design = good(pcf(
      "BEND\n  END-POINT 0 0 0 4\n  END-POINT 1999.8477 -17.4524 0 4\n  CENTRE-POINT 1000 0 0\n"));
  const double south = design.bounds().max().z() + design.origin.z();
  EXPECT_NEAR(south, 0.0174524 + 0.05715 * std::cos(std::numbers::pi / 180), 1e-6);
}

TEST_F(PcfDesign, BlindAndGasketFollowTheFlangeTheySitOn) {
  const DesignModel design =
      good(pcf("FLANGE\n  END-POINT 900 0 0 4 BW\n  END-POINT 976.2 0 0 4 FL\n  SKEY "
               "FLWN\nGASKET\n  END-POINT "
               "976.2 0 0 4\n  END-POINT 979.2 0 0 4\nFLANGE-BLIND\n  END-POINT 979.2 0 0 4 FL\n  "
               "SKEY FLBL\n"));
  ASSERT_EQ(design.parts.size(), 3u);
  const Part& blind = part_named(design, "blind-1");
  // Its face looks back at the flange, its body lies beyond.
  EXPECT_NEAR((blind.T_design_part.linear().col(2) + Vector3d::UnitX()).norm(), 0, 1e-9);
  EXPECT_NEAR(design.bounds().max().x() + design.origin.x(), 0.9792 + 0.0238, 1e-6);
  EXPECT_EQ(blind.holes->count, 8);
}

TEST_F(PcfDesign, AsksToConfirmAUnitThatItGuessed) {
  const std::string silent = replaced(spool_pcf(), "UNITS-CO-ORDS   MM\n", "");
  EXPECT_TRUE(good(silent).unit_inferred);
  EXPECT_FALSE(good(silent, LengthUnit::kMillimetre).unit_inferred);
}

// Four elbows and four pipes round a rectangle, every pipe as long as centres less take-offs.
TEST_F(PcfDesign, TakeOffsOfTheCatalogueCloseALoop) {
  for (const piping::PipeSize& pipe : piping::pipe_sizes()) {
    const auto fitting = piping::fitting_size(pipe.nps);
    if (!fitting) continue;
    const double a = 1000 * fitting->elbow_90_long, w = 3 * a + 500, d = 3 * a + 900;
    const auto at = [&](double x, double y) {
      return " " + std::to_string(x) + " " + std::to_string(y) + " 0 " + std::to_string(pipe.nps) +
             "\n";
    };
    const auto elbow = [&](double x, double y, double sx, double sy) {
      return "ELBOW\n  END-POINT" + at(x + sx * a, y) + "  END-POINT" + at(x, y + sy * a) +
             "  CENTRE-POINT" + at(x, y) + "  SKEY ELBW\n  SCHEDULE STD\n";
    };
    const auto run = [&](double x0, double y0, double x1, double y1) {
      return "PIPE\n  END-POINT" + at(x0, y0) + "  END-POINT" + at(x1, y1) + "  SCHEDULE STD\n";
    };
    const DesignModel design = good(
        pcf(elbow(0, 0, 1, 1) + run(a, 0, w - a, 0) + elbow(w, 0, -1, 1) + run(w, a, w, d - a) +
            elbow(w, d, -1, -1) + run(w - a, d, a, d) + elbow(0, d, 1, -1) + run(0, d - a, 0, a)));
    EXPECT_TRUE(design.warnings.empty()) << design.warnings.front();
    ASSERT_EQ(design.joints.size(), 8u) << "NPS " << pipe.nps;
    for (const Joint& joint : design.joints) {
      const Part& p = design.parts[static_cast<std::size_t>(joint.part_a)];
      const Part& q = design.parts[static_cast<std::size_t>(joint.part_b)];
      const Vector3d from =
          p.T_design_part * p.ports[static_cast<std::size_t>(joint.port_a)].position;
      const Vector3d to =
          q.T_design_part * q.ports[static_cast<std::size_t>(joint.port_b)].position;
      EXPECT_NEAR((from - to).norm(), 0, 1e-8) << "NPS " << pipe.nps;
    }
    // Closed in steel too: each elbow's last ring lies on the pipe's end.
    const Part& first = design.parts[0];
    const piping::Solid solid = solid_of(design, first);
    double furthest = 0;
    for (const Triangle& t : solid.triangles)
      furthest = std::max(furthest, -(solid.vertices[t[0]].z() + design.origin.z()));
    EXPECT_NEAR(furthest, a / 1000, 1e-6) << "NPS " << pipe.nps;
  }
}

}  // namespace
}  // namespace spool
