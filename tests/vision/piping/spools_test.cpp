// Weld numbers given and made up, spools named and found, cut lists, sizes that are not the
// catalogue's.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/piping/spools.h"

#include <set>
#include <string>

#include "tests/vision/piping/pipework_probe.h"
#include "vision/piping/catalogue.h"
#include "vision/piping/cut_list.h"
#include "vision/piping/size_checks.h"

namespace spool::piping {
namespace {

using test::line_of;
using test::pcf;
using test::problem_line;
using test::read_good;
using test::replaced;
using test::spool_pcf;

std::string pipe(int from, int to, const std::string& more = "") {
  return "PIPE\n  END-POINT " + std::to_string(from) + " 0 0 4\n  END-POINT " + std::to_string(to) +
         " 0 0 4\n" + more;
}
std::string weld(int at, const std::string& more) {
  return "WELD\n  CO-ORDS " + std::to_string(at) + " 0 0\n" + more;
}

TEST(Spools, MakesUpWeldNumbersAndFlagsThem) {
  const Pipework out = read_good(spool_pcf());
  std::set<std::string> numbers;
  int given = 0;
  for (const PipeJoint& joint : out.joints) {
    if (joint.kind == PipeJoint::Kind::kBolted) {
      EXPECT_EQ(joint.number, "");
      continue;
    }
    EXPECT_TRUE(numbers.insert(joint.number).second) << joint.number << " twice";
    EXPECT_EQ(joint.is_made_up, joint.number.back() == '?') << joint.number;
    if (!joint.is_made_up) ++given;
  }
  EXPECT_EQ(given, 2);
  EXPECT_TRUE(numbers.count("W-101") == 1 && numbers.count("FW-7") == 1);
}

TEST(Spools, TellsShopFromSiteAndYard) {
  const struct {
    const char* says;
    WeldPlace place;
    bool is_told;
  } cases[] = {
      {"  SKEY WW\n", WeldPlace::kFab, true},
      {"  SKEY WWA\n", WeldPlace::kFab, true},
      {"  SKEY WM\n", WeldPlace::kFab, true},
      {"  SKEY WS\n", WeldPlace::kField, true},
      {"  SKEY WFT\n", WeldPlace::kField, true},
      {"  SKEY WO\n", WeldPlace::kField, true},
      {"  CATEGORY ERECTION\n", WeldPlace::kField, true},
      {"  CATEGORY FABRICATION\n", WeldPlace::kFab, true},
      {"  SKEY WS\n  WELD-ATTRIBUTE2 YAW\n", WeldPlace::kYaw, true},
      {"  CATEGORY YARD\n", WeldPlace::kYaw, true},
      {"", WeldPlace::kFab, false},
  };
  for (const auto& each : cases) {
    const Pipework out = read_good(
        pcf(pipe(0, 1000) + pipe(1000, 2000) + weld(1000, std::string("  NAME 1\n") + each.says)));
    ASSERT_EQ(out.joints.size(), 1u);
    EXPECT_EQ(out.joints[0].where, each.place) << each.says;
    EXPECT_EQ(problem_line(out, "does not say shop or site") == 10, !each.is_told) << each.says;
  }
}

TEST(Spools, ReportsANumberGivenTwice) {
  const Pipework out =
      read_good(pcf(pipe(0, 1000) + pipe(1000, 2000) + pipe(2000, 3000) +
                    weld(1000, "  SKEY WW\n  NAME 5\n") + weld(2000, "  SKEY WW\n  NAME 5\n")));
  EXPECT_EQ(problem_line(out, "weld number 5 is given twice, first in line 13"), 17);
}

TEST(Spools, AreWhatTheFileSays) {
  const Pipework out = read_good(spool_pcf());
  ASSERT_EQ(out.spools.size(), 2u);
  EXPECT_EQ(out.spools[0].name, "SP1");
  EXPECT_EQ(out.spools[0].components.size(), 8u);
  EXPECT_EQ(out.spools[1].components.size(), 4u);
  EXPECT_FALSE(out.spools[0].is_made_up);
}

TEST(Spools, EndAtSiteWeldsAndBoltsWhereTheFileNamesNone) {
  const std::string text = replaced(spool_pcf(), "    SPOOL-IDENTIFIER  SP1\n", "");
  const Pipework out = read_good(replaced(text, "    SPOOL-IDENTIFIER  SP2\n", ""));
  ASSERT_EQ(out.spools.size(), 2u);
  EXPECT_EQ(out.spools[0].name, "10-3-PL-3259-SP1");
  EXPECT_TRUE(out.spools[0].is_made_up);
  EXPECT_EQ(out.spools[0].components.size(), 8u);
  EXPECT_EQ(out.spools[1].components.size(), 4u);
}

TEST(Spools, TakesInWhatIsWeldedToThemInTheShop) {
  const Pipework out = read_good(pcf(pipe(0, 1000, "  SPOOL-IDENTIFIER A\n") + pipe(1000, 2000) +
                                     pipe(2000, 3000, "  ERECTION-ITEM\n")));
  EXPECT_EQ(out.components[1].spool, "A");
  EXPECT_EQ(out.components[2].spool, "");
  EXPECT_EQ(out.joints[1].where, WeldPlace::kField) << "to what goes up on site";
}

TEST(Spools, StandAloneWithTheirWeldsAndProblems) {
  const std::string text = replaced(spool_pcf(), "576.0 2", "580.0 2");  // a tee of SP1
  const Pipework whole = read_good(text);
  const auto one = only_spool(whole, "SP1");
  const auto two = only_spool(whole, "SP2");
  ASSERT_TRUE(one && two);
  EXPECT_EQ(one->spools.front().components.size(), 8u);
  EXPECT_EQ(one->components.size(), 9u) << "eight and the WELD between two of them";
  EXPECT_NE(problem_line(*one, "a branch of 80.0 mm"), -1);
  EXPECT_EQ(problem_line(*two, "a branch of 80.0 mm"), -1);
  for (const PipeJoint& joint : one->joints) {
    EXPECT_EQ(one->components.at(static_cast<std::size_t>(joint.a)).spool, "SP1");
    EXPECT_EQ(one->components.at(static_cast<std::size_t>(joint.b)).spool, "SP1");
    if (joint.weld >= 0) {
      EXPECT_EQ(one->components.at(static_cast<std::size_t>(joint.weld)).weld_number, "W-101");
    }
  }
  EXPECT_FALSE(only_spool(whole, "SP3"));
}

TEST(CutList, TakesOffFittingsAndGaps) {
  const Pipework out = read_good(spool_pcf());
  const auto list = cut_list(out, 0.003);
  ASSERT_EQ(list.size(), 4u);
  const double mm = 0.001;
  // Flange face to elbow centre 500: a weld neck of 69.8, an elbow of 114, a gap at either end.
  EXPECT_NEAR(list[0].centre_to_centre(), 500 * mm, 1e-9);
  EXPECT_NEAR(list[0].cut(), (500 - 69.8 - 114 - 6) * mm, 1e-9);
  // Reducer 89 along the pipe, although its ends lie 14.3 apart sideways.
  EXPECT_NEAR(list[3].ends[0].take_off, 89 * mm, 1e-9);
  EXPECT_NEAR(list[3].cut(), (200 - 6) * mm, 1e-9);
}

TEST(CutList, SharesTheGapBetweenTwoPipes) {
  const Pipework out = read_good(pcf(pipe(0, 1000) + pipe(1000, 2000)));
  for (const CutPipe& each : cut_list(out, 0.003)) EXPECT_NEAR(each.cut(), 0.9985, 1e-9);
  const Pipework drawn =
      read_good(pcf(pipe(0, 1000) + pipe(1003, 2000) +
                    "WELD\n  END-POINT 1000 0 0 4\n  END-POINT 1003 0 0 4\n  SKEY WW\n"));
  EXPECT_NEAR(cut_list(drawn, 0.003)[0].cut(), 1.0, 1e-9)
      << "a gap that is drawn is not taken twice";
}

TEST(SizeChecks, TrustTheDrawingAndSayWhatIsOdd) {
  const struct {
    const char* from;
    const char* to;
    const char* problem;
    const char* at;
  } cases[] = {
      {"ANGLE             9000", "ANGLE 4500", "says 45.00 degrees and is drawn at 90.00",
       "ELBOW\n"},
      {"ANGLE             9000", "ANGLE 90", "", ""},
      {"END-POINT         1386.0 2000.0 500.0 3 BW", "END-POINT 1380.0 2000.0 500.0 3 BW",
       "legs of different length", "ELBOW\n"},
      {"576.0 2", "580.0 2", "a branch of 80.0 mm where the catalogue has 76.0 mm", "TEE\n"},
      {"1000.0 2000.0 500.0 3 FL", "990.0 2000.0 500.0 3 FL",
       "a length of 79.8 mm where the catalogue has 69.8 mm", "FLANGE\n"},
      {"FLANGE WN RF CL150", "FLANGE WN RF", "", ""},  // NOMINAL-CLASS says it
      {"PIPE SMLS SCH 40", "PIPE SMLS", "has no schedule in its text; STD is taken", "PIPE\n"},
      {"PIPE SMLS SCH 40", "PIPE SMLS SCH 140", "schedule '140' of NPS 3 is not in the catalogue",
       "PIPE\n"},
      {"    TAP-CONNECTION\n        CO-ORDS       1553.9 2972.9 548.6 0.5\n", "",
       "an orifice flange without a TAP-CONNECTION", "FLANGE\n    END-POINT         1500.0 2934"},
      {"CL150", "CL900", "class 900 of NPS 3 is not in the catalogue", "FLANGE\n"},
  };
  for (const auto& each : cases) {
    const std::string text = replaced(spool_pcf(), each.from, each.to);
    const Pipework out = read_good(text);
    if (*each.problem == '\0') {
      EXPECT_TRUE(out.problems.empty()) << each.to << "\n" << test::all_problems(out);
    } else {
      EXPECT_EQ(problem_line(out, each.problem), line_of(text, each.at)) << each.to << "\n"
                                                                         << test::all_problems(out);
    }
  }
}

TEST(SizeChecks, TellAFlangesClassByItsLength) {
  std::string text = replaced(spool_pcf(), "    NOMINAL-CLASS     150\n", "");
  text = replaced(text, "CL150", "");
  const Pipework out = read_good(text);
  EXPECT_EQ(out.components[0].rating, "150");
  EXPECT_EQ(problem_line(out, "by its length it is class 150"), line_of(text, "FLANGE\n"));
}

TEST(SizeChecks, EveryElbowTeeAndFlangeOfTheCatalogueIsAsDrawn) {
  for (const double nps : {0.5, 1.0, 2.0, 4.0, 8.0, 12.0, 24.0}) {
    const FittingSize size = *fitting_size(nps);
    const double a = size.elbow_90_long * 1000;
    const std::string bore = " " + std::to_string(nps);
    const auto at = [](double x, double y) {
      return std::to_string(x) + " " + std::to_string(y) + " 0";
    };
    const Pipework out = read_good(pcf("ELBOW\n  END-POINT " + at(0, 0) + bore + "\n  END-POINT " +
                                       at(a, a) + bore + "\n  CENTRE-POINT " + at(a, 0) +
                                       "\n  SKEY ELBW\n  ANGLE 9000\n  SCHEDULE STD\n"));
    EXPECT_TRUE(out.problems.empty()) << test::all_problems(out);
    EXPECT_NEAR(bend_angle(out.components[0]), 1.5707963, 1e-6);
  }
}

}  // namespace
}  // namespace spool::piping
