// A whole file read: every record of it, by whatever writer, in whatever units.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/piping/pcf_reader.h"

#include <regex>
#include <string>

#include "tests/vision/piping/pipework_probe.h"
#include "vision/piping/pcf_text.h"

namespace spool::piping {
namespace {

using test::count_of;
using test::line_of;
using test::pcf;
using test::problem_line;
using test::read_good;
using test::replaced;
using test::spool_pcf;

// Positions, sizes and texts, which no manner of writing changes.
void expect_same(const Pipework& a, const Pipework& b, const char* how) {
  ASSERT_EQ(a.components.size(), b.components.size()) << how;
  EXPECT_EQ(a.joints.size(), b.joints.size()) << how;
  EXPECT_EQ(a.spools.size(), b.spools.size()) << how;
  EXPECT_EQ(a.line_ends.size(), b.line_ends.size()) << how;
  for (std::size_t c = 0; c < a.components.size(); ++c) {
    const Component& x = a.components[c];
    const Component& y = b.components[c];
    const std::string where = std::string(how) + ", " + mention(x);
    EXPECT_EQ(x.kind, y.kind) << where;
    EXPECT_EQ(x.skey, y.skey) << where;
    EXPECT_EQ(x.schedule, y.schedule) << where;
    EXPECT_EQ(x.rating, y.rating) << where;
    EXPECT_EQ(to_capitals(x.heat), to_capitals(y.heat)) << where;
    EXPECT_EQ(to_capitals(x.spool), to_capitals(y.spool)) << where;
    EXPECT_EQ(x.is_erection, y.is_erection) << where;
    EXPECT_EQ(x.places.size(), y.places.size()) << where;
    EXPECT_EQ(x.taps.size(), y.taps.size()) << where;
    ASSERT_EQ(port_count(x), port_count(y)) << where;
    for (int p = 0; p < port_count(x); ++p) {
      EXPECT_EQ(port_of(x, p).nps, port_of(y, p).nps) << where;
      // A thousandth of a millimetre, to which files are rounded in inches.
      EXPECT_NEAR((port_of(x, p).position - port_of(y, p).position).norm(), 0, 2e-6) << where;
    }
  }
}

TEST(PcfReader, UnderstandsEveryRecord) {
  const Pipework out = read_good(spool_pcf());
  EXPECT_TRUE(out.problems.empty()) << test::all_problems(out);
  const struct {
    ComponentKind kind;
    int count;
  } counts[] = {
      {ComponentKind::kPipe, 4},   {ComponentKind::kElbow, 2},  {ComponentKind::kTee, 1},
      {ComponentKind::kFlange, 2}, {ComponentKind::kCap, 1},    {ComponentKind::kReducer, 1},
      {ComponentKind::kOlet, 1},   {ComponentKind::kGasket, 1}, {ComponentKind::kBolt, 1},
      {ComponentKind::kValve, 1},  {ComponentKind::kWeld, 2},   {ComponentKind::kSupport, 1}};
  for (const auto& each : counts)
    EXPECT_EQ(count_of(out, each.kind), each.count) << name(each.kind);
  ASSERT_EQ(out.pipelines.size(), 1u);
  EXPECT_EQ(out.pipelines[0].reference, "10-3-PL-3259-002");
  EXPECT_EQ(out.pipelines[0].revision, "2");
  EXPECT_EQ(out.pipelines[0].nominal_class, "150");
  const Component& flange = out.components[0];
  EXPECT_EQ(flange.description, "FLANGE WN RF CL150 SCH STD ASTM A105");
  EXPECT_EQ(flange.rating, "150");
  EXPECT_EQ(flange.schedule, "STD");
  EXPECT_EQ(flange.id, "0001");
  EXPECT_EQ(flange.line, line_of(spool_pcf(), "FLANGE\n"));
  EXPECT_EQ(flange.ends[1].position, Eigen::Vector3d(1.0698, 2.0, 0.5));
  EXPECT_EQ(flange.ends[1].end, "BW");
  EXPECT_NE(flange.raw.find("    SKEY              FLWN"), std::string::npos);
  EXPECT_EQ(out.components[1].heat, "H-77");
  ASSERT_EQ(out.line_ends.size(), 1u);
  EXPECT_EQ(out.line_ends[0].keyword, "END-CONNECTION-EQUIPMENT");
  EXPECT_EQ(*out.line_ends[0].place, Eigen::Vector3d(1, 2, 0.5));
}

TEST(PcfReader, KeepsTapsSpindlesAndFlatSides) {
  const Pipework out = read_good(spool_pcf());
  int found = 0;
  for (const Component& each : out.components) {
    if (each.skey == "FOWN") {
      ASSERT_EQ(each.taps.size(), 1u);
      EXPECT_NEAR(each.taps[0].position.x(), 1.5539, 1e-9);
      EXPECT_EQ(each.taps[0].nps, 0.5);
      ++found;
    }
    if (each.kind == ComponentKind::kValve) {
      EXPECT_EQ(*each.spindle, Eigen::Vector3d::UnitZ());
      EXPECT_TRUE(each.is_erection);
      EXPECT_EQ(each.tag, "HV-101");
      ++found;
    }
    if (each.kind == ComponentKind::kReducer) {
      EXPECT_EQ(*each.flat_side, -Eigen::Vector3d::UnitZ());
      // Its axis is the pipe's although its ends lie apart sideways.
      EXPECT_NEAR((each.directions[1] - Eigen::Vector3d::UnitY()).norm(), 0, 1e-9);
      ++found;
    }
  }
  EXPECT_EQ(found, 3);
}

TEST(PcfReader, ReadsTheSameFromEveryWriter) {
  const std::string text = spool_pcf();
  const Pipework plain = read_good(text);
  const std::string materials = text.substr(text.find("MATERIALS"));
  const std::string body = text.substr(0, text.find("MATERIALS"));
  expect_same(plain, read_good(test::unindented(text)), "no indentation");
  const std::string own = replaced(text, "    HEAT-NUMBER", "    COLOUR red\n    HEAT-NUMBER");
  expect_same(plain, read_good(test::unindented(own)), "no indentation, an attribute of its own");
  expect_same(plain, read_good(test::in_small_letters(text)), "small letters");
  expect_same(plain, read_good(replaced(text, "\n", "\r\n")), "line ends of Windows");
  expect_same(plain, read_good(replaced(text, "\n    ", "\n\t")), "tabs");
  expect_same(plain, read_good("  " + replaced(text, "\n", "\n  ")), "a margin");
  expect_same(plain, read_good(materials + body), "materials first");
  std::string spelled = replaced(text, "CENTRE-POINT", "CENTER-POINT");
  spelled = replaced(spelled, "CO-ORDS  ", "COORDS");
  expect_same(plain, read_good(spelled), "American");
  expect_same(plain, read_good(replaced(text, "    END-POINT ", "    <END-POINT>")), "brackets");
}

// Every coordinate of the file in another unit.
std::string in_unit(const std::string& text, double factor, int digits, const char* header) {
  const std::regex point(R"((-POINT|CO-ORDS) +(-?[\d.]+) +(-?[\d.]+) +(-?[\d.]+))");
  std::string out;
  auto from = text.cbegin();
  for (std::sregex_iterator it(text.begin(), text.end(), point), end; it != end; ++it) {
    out.append(from, (*it)[0].first);
    out += (*it)[1].str();
    for (std::size_t k = 2; k <= 4; ++k) {
      char number[64];
      std::snprintf(number, sizeof number, " %.*f", digits, std::stod((*it)[k].str()) * factor);
      out += number;
    }
    from = (*it)[0].second;
  }
  out.append(from, text.cend());
  return replaced(out, "UNITS-CO-ORDS   MM", std::string("UNITS-CO-ORDS   ") + header);
}

TEST(PcfReader, ReadsTheSameInEveryUnit) {
  const Pipework plain = read_good(spool_pcf());
  expect_same(plain, read_good(in_unit(spool_pcf(), 1 / 25.4, 6, "INCH")), "inches");
  expect_same(plain, read_good(in_unit(spool_pcf(), 100, 2, "MM-HUNDREDTH")), "hundredths");
  std::string bores = replaced(spool_pcf(), "UNITS-BORE      INCH", "UNITS-BORE MM");
  bores = replaced(bores, " 3 FL", " 80 FL");
  for (const auto& [inch, dn] : {std::pair{" 3 BW", " 80 BW"},
                                 {" 2 BW", " 50 BW"},
                                 {" 2 FL", " 50 FL"},
                                 {" 3\n", " 80\n"},
                                 {" 2\n", " 50\n"},
                                 {" 0.75 SW", " 20 SW"},
                                 {" 0.5\n", " 15\n"}})
    bores = replaced(bores, inch, dn);
  expect_same(plain, read_good(bores), "bores in mm");
}

TEST(PcfReader, TellsUnitsFromFittingsWhereTheFileDoesNot) {
  const std::string silent =
      replaced(replaced(spool_pcf(), "UNITS-BORE      INCH\n", ""), "UNITS-CO-ORDS   MM\n", "");
  const Pipework mm = read_good(silent);
  expect_same(read_good(spool_pcf()), mm, "no units");
  EXPECT_TRUE(mm.coordinate_unit_inferred);
  EXPECT_NE(problem_line(mm, "confirm it by --design-unit"), -1);
  const std::string inch = in_unit(spool_pcf(), 1 / 25.4, 6, "?");
  const Pipework inches = read_good(replaced(inch, "UNITS-CO-ORDS   ?\n", ""));
  expect_same(read_good(spool_pcf()), inches, "no units, inches");
  EXPECT_TRUE(inches.coordinate_unit_inferred);
  EXPECT_FALSE(inches.bore_unit_inferred);
}

TEST(PcfReader, ReadsHeadersThatDoNotConform) {
  const std::string text =
      replaced(replaced(spool_pcf(), "UNITS-BORE      INCH", "UNITS-BOREIN INCH"),
               "UNITS-CO-ORDS   MM", "UNITS-COOR MM");
  const Pipework out = read_good(text);
  expect_same(read_good(spool_pcf()), out, "odd header");
  EXPECT_EQ(problem_line(out, "'UNITS-BOREIN' is read as UNITS-BORE"),
            line_of(text, "UNITS-BOREIN"));
  EXPECT_EQ(problem_line(out, "'UNITS-COOR' is read as"), line_of(text, "UNITS-COOR"));
  const std::string wrong = replaced(spool_pcf(), "UNITS-BORE      INCH", "UNITS-BORE MM");
  const Pipework mended = read_good(wrong);
  expect_same(read_good(spool_pcf()), mended, "bores said to be mm");
  EXPECT_EQ(problem_line(mended, "bores are said to be in mm"), line_of(wrong, "UNITS-CO-ORDS"));
}

TEST(PcfReader, HoldsUnitsUntilTheyChange) {
  const std::string pipe = "PIPE\n  END-POINT 0 0 0 4\n  END-POINT 1000 0 0 4\n";
  const std::string inch =
      "UNITS-CO-ORDS INCH\nPIPELINE-REFERENCE L-2\nPIPE\n  END-POINT 0 100 0 4\n  END-POINT 10 100 "
      "0 4\n";
  const Pipework out = read_good(pcf(pipe) + inch);
  ASSERT_EQ(out.components.size(), 2u);
  EXPECT_NEAR(out.components[0].ends[1].position.x(), 1.0, 1e-12);
  EXPECT_NEAR(out.components[1].ends[1].position.x(), 0.254, 1e-12);
  EXPECT_EQ(out.components[1].pipeline, 1);
  EXPECT_EQ(out.pipelines[1].reference, "L-2");
}

TEST(PcfReader, TakesTheUnitThatIsAskedFor) {
  const auto out =
      read_pcf(pcf("PIPE\n  END-POINT 0 0 0 4\n  END-POINT 10 0 0 4\n"), "f.pcf", 0.0254);
  ASSERT_TRUE(out);
  EXPECT_NEAR(out->components[0].ends[1].position.x(), 0.254, 1e-12);
  EXPECT_EQ(problem_line(*out, "coordinates are said to be in MM"), 2);
}

TEST(PcfReader, TakesAnOutsideDiameterForABore) {
  const std::string text = pcf("PIPE\n  END-POINT 0 0 0 60.3\n  END-POINT 900 0 0 60.3\n",
                               "UNITS-BORE MM\nUNITS-CO-ORDS MM\n");
  const Pipework out = read_good(text);
  EXPECT_EQ(out.components[0].ends[0].nps, 2);
  EXPECT_EQ(problem_line(out, "60.3 is the outside diameter of NPS 2"), 5);
}

TEST(PcfReader, KeepsMillimetresOfPlantCoordinates) {
  const Pipework out = read_good(pcf(
      "PIPE\n  END-POINT 482150130.6 5650130250.7 12345.6 4\n  END-POINT 482150130.6 5650131250.8 "
      "12345.6 4\n"));
  const Component& pipe = out.components[0];
  EXPECT_NEAR((pipe.ends[1].position - pipe.ends[0].position).norm(), 1.0001, 1e-8);
}

TEST(PcfReader, KeepsUnknownKeywordsAsRigidPieces) {
  const std::string text = pcf(
      "GADGET\n    END-POINT 0 0 0 4\n    END-POINT 200 0 0 4\n    COLOUR red\nWHATEVER\n    A b\n"
      "WEIRD\n    END-POINT 200 0 0 4\n    END-POINT 352 152 0 4\n    CENTRE-POINT 352 0 0\n    "
      "SKEY "
      "ELBW\n");
  const Pipework out = read_good(text);
  ASSERT_EQ(out.components.size(), 2u);
  EXPECT_EQ(out.components[0].kind, ComponentKind::kLink);
  EXPECT_NE(out.components[0].raw.find("COLOUR red"), std::string::npos);
  EXPECT_EQ(out.components[1].kind, ComponentKind::kElbow) << "known by its symbol key";
  EXPECT_EQ(problem_line(out, "'GADGET' is no keyword"), 4);
  EXPECT_EQ(problem_line(out, "'WHATEVER' is no keyword"), 8);
  EXPECT_EQ(out.joints.size(), 1u);
}

TEST(PcfReader, NamesEveryOddityWithItsLine) {
  const struct {
    const char* line;
    const char* problem;
  } cases[] = {
      {"  END-POINT 0 0 zero 4", "does not start with three numbers"},
      {"  ANGLE wide", "the angle 'wide' is no number"},
      {"  BEND-RADIUS -3", "the bend radius '-3' is no length"},
      {"  SPINDLE-DIRECTION AWAY", "'AWAY' is no direction"},
      {"  FLAT-DIRECTION ?", "'?' is no direction"},
      {"  END-POINT 0 0 0 4x", "the bore '4x' is no size"},
      {"  END-POINT 9e30 0 0 4", "beyond any plant"},
      {"  END-POINT 0 0 5 9e9", "wider than any pipe"},
      {"  ITEM-CODE NONE", "item code 'NONE' is not among the MATERIALS"},
  };
  for (const auto& each : cases) {
    const std::string text =
        pcf("PIPE\n  END-POINT 0 0 0 4\n  END-POINT 900 0 0 4\nMATERIALS\n  ITEM-CODE A\n"
            "PIPE\n  END-POINT 0 500 0 4\n" +
            std::string(each.line) + "\n  END-POINT 900 500 0 4\n");
    const Pipework out = read_good(text);
    const int line = problem_line(out, each.problem);
    // Of an item code the component is named, of all else the line itself.
    EXPECT_EQ(line, std::string(each.line).find("ITEM") != std::string::npos ? 9 : 11)
        << each.line << "\n"
        << test::all_problems(out);
  }
}

TEST(PcfReader, JoinsDescriptionsOfSeveralLines) {
  const Pipework out =
      read_good(pcf("PIPE\n  END-POINT 0 0 0 4\n  END-POINT 900 0 0 4\n"
                    "  ITEM-DESCRIPTION PIPE SCH\n  ITEM-DESCRIPTION 80\n"));
  EXPECT_EQ(out.components[0].description, "PIPE SCH 80");
  EXPECT_EQ(out.components[0].schedule, "80");
}

TEST(PcfReader, LeavesOutWhatWasNeverPlaced) {
  const Pipework out = read_good(
      pcf("PIPE\n  END-POINT 5000 0 0 4\n  END-POINT 6000 0 0 4\nPIPE\n  END-POINT 0 0 0 4\n"
          "  END-POINT 0 0 0 4\n"));
  EXPECT_EQ(out.components.size(), 1u);
  EXPECT_EQ(problem_line(out, "only zeros for coordinates"), 7);
}

}  // namespace
}  // namespace spool::piping
