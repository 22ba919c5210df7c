// Ends that meet, nearly meet and do not; welds, branch fittings, elbows without a centre.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/piping/joint_graph.h"

#include <string>

#include "tests/vision/piping/pipework_probe.h"

namespace spool::piping {
namespace {

using test::pcf;
using test::problem_line;
using test::read_good;

std::string pipe(const std::string& from, const std::string& to) {
  return "PIPE\n  END-POINT " + from + "\n  END-POINT " + to + "\n";
}

TEST(JointGraph, NeverMovesWhatDoesNotMeet) {
  const struct {
    const char* start;
    int joints;
    const char* problem;
  } cases[] = {
      {"1000 0 0 4", 1, ""},
      {"1000.4 0 0 4", 1, ""},
      {"1003 0 0 4", 1, "3.00 mm apart (a gap)"},
      {"998 0 0 4", 1, "2.00 mm apart (an overlap)"},
      {"1000 2.5 0 4", 1, "2.50 mm apart (side by side)"},
      {"1007 0 0 4", 0, ""},
  };
  for (const auto& each : cases) {
    const Pipework out =
        read_good(pcf(pipe("0 0 0 4", "1000 0 0 4") + pipe(each.start, "2000 0 0 4")));
    EXPECT_EQ(static_cast<int>(out.joints.size()), each.joints) << each.start;
    EXPECT_EQ(problem_line(out, "mm apart") >= 0, *each.problem != '\0') << each.start;
    if (*each.problem != '\0') {
      EXPECT_EQ(problem_line(out, each.problem), 8) << test::all_problems(out);
    }
    EXPECT_EQ(out.components[0].ends[1].position, Eigen::Vector3d(1, 0, 0));
  }
}

TEST(JointGraph, JoinsAcrossARootGapThatAWeldSpans) {
  const Pipework out =
      read_good(pcf(pipe("0 0 0 4", "1000 0 0 4") + pipe("1003 0 0 4", "2000 0 0 4") +
                    "WELD\n  END-POINT 1000 0 0 4\n  END-POINT 1003 0 0 4\n  SKEY WW\n  NAME 7\n"));
  ASSERT_EQ(out.joints.size(), 1u);
  EXPECT_NEAR(out.joints[0].gap, 0.003, 1e-9);
  EXPECT_EQ(out.joints[0].number, "7");
  EXPECT_EQ(problem_line(out, "apart"), -1);
}

TEST(JointGraph, DoesNotDependOnOrder) {
  const std::string parts[] = {pipe("0 0 0 4", "1000 0 0 4"), pipe("1000 0 0 4", "2000 0 0 4"),
                               pipe("3000 0 0 4", "2000 0 0 4")};
  EXPECT_EQ(read_good(pcf(parts[0] + parts[1] + parts[2])).joints.size(), 2u);
  EXPECT_EQ(read_good(pcf(parts[2] + parts[0] + parts[1])).joints.size(), 2u);
}

TEST(JointGraph, ReportsEndsThatDoNotFit) {
  const Pipework bores =
      read_good(pcf(pipe("0 0 0 4", "1000 0 0 4") + pipe("1000 0 0 3", "2000 0 0 3")));
  EXPECT_EQ(problem_line(bores, "different bores, NPS 4 and NPS 3"), 8);
  const Pipework ends =
      read_good(pcf(pipe("0 0 0 4 BW", "1000 0 0 4 BW") + pipe("1000 0 0 4 FL", "2000 0 0 4 BW")));
  EXPECT_EQ(problem_line(ends, "ends that do not fit, BW and FL"), 8);
  const Pipework three =
      read_good(pcf(pipe("0 0 0 4", "1000 0 0 4") + pipe("1000 0 0 4", "2000 0 0 4") +
                    pipe("1000 0 0 4", "1000 500 0 4")));
  EXPECT_EQ(problem_line(three, "two others already meet"), 11);
}

TEST(JointGraph, MissesTheGasketBetweenTwoFaces) {
  const std::string flanges =
      "FLANGE\n  END-POINT 0 0 0 4 BW\n  END-POINT 76.2 0 0 4 FL\n  SKEY FLWN\n"
      "FLANGE\n  END-POINT 79.2 0 0 4 FL\n  END-POINT 155.4 0 0 4 BW\n  SKEY FLWN\n";
  const Pipework out = read_good(pcf(flanges));
  ASSERT_EQ(out.joints.size(), 1u);
  EXPECT_EQ(out.joints[0].kind, PipeJoint::Kind::kBolted);
  EXPECT_EQ(problem_line(out, "room for a gasket that the file does not have"), 9);
  const Pipework with =
      read_good(pcf(flanges + "GASKET\n  END-POINT 76.2 0 0 4\n  END-POINT 79.2 0 0 4\n"));
  EXPECT_EQ(with.joints.size(), 2u);
  EXPECT_EQ(problem_line(with, "apart"), -1);
}

TEST(JointGraph, FindsTheCentreOfAnElbowWithoutOne) {
  const std::string elbow = "ELBOW\n  END-POINT 1000 0 0 4\n  END-POINT 1152 152 0 4\n";
  const Pipework out =
      read_good(pcf(pipe("0 0 0 4", "1000 0 0 4") + elbow + pipe("1152 152 0 4", "1152 900 0 4")));
  const Component& found = out.components[1];
  ASSERT_TRUE(found.centre);
  EXPECT_NEAR((found.centre->position - Eigen::Vector3d(1.152, 0, 0)).norm(), 0, 1e-9);
  EXPECT_EQ(problem_line(out, "its centre is taken where"), 7);
  const Pipework alone = read_good(pcf(elbow));
  EXPECT_FALSE(alone.components[0].centre);
  EXPECT_EQ(problem_line(alone, "drawn straight"), 4);
}

TEST(JointGraph, SeatsBranchFittingsOnTheirRun) {
  const std::string run = pipe("0 0 0 4", "1000 0 0 4");
  const std::string olet =
      "OLET\n  CENTRE-POINT 400 0 0\n  BRANCH1-POINT 400 0 90 1 BW\n  SKEY WTBW\n";
  const Pipework out = read_good(pcf(run + olet + pipe("400 0 90 1", "400 0 300 1") +
                                     "WELD\n  CO-ORDS 400 0 57\n  SKEY WS\n  NAME B1\n"));
  ASSERT_EQ(out.joints.size(), 2u);
  EXPECT_EQ(out.joints[0].port_a, kOnRun);
  EXPECT_EQ(out.joints[0].a, 0);
  EXPECT_EQ(out.joints[0].b, 1);
  EXPECT_EQ(out.joints[0].number, "B1") << "the weld drawn on the run's outside";
  EXPECT_EQ(out.joints[0].where, WeldPlace::kField);
  const Pipework off = read_good(pcf(pipe("0 50 0 4", "1000 50 0 4") + olet));
  EXPECT_EQ(problem_line(off, "sits on nothing"), 7);
  const Pipework lost = read_good(pcf(run + "OLET\n  BRANCH1-POINT 400 0 90 1 BW\n"));
  EXPECT_EQ(problem_line(lost, "no CENTRE-POINT"), 7);
}

TEST(JointGraph, SeatsATeeWithoutARunOnThePipeUnderIt) {
  const std::string stub =
      "TEE-STUB\n  END-POINT 500 0 0 4\n  END-POINT 500 0 0 4\n  CENTRE-POINT 500 0 0\n"
      "  BRANCH1-POINT 500 0 57.15 2\n";
  for (const std::string& run : {pipe("0 0 0 4", "1000 0 0 4"),
                                 pipe("0 0 0 4", "500 0 0 4") + pipe("500 0 0 4", "1000 0 0 4")}) {
    const Pipework out = read_good(pcf(stub + run + pipe("500 0 57.15 2", "500 0 400 2")));
    EXPECT_EQ(out.joints.size(), out.components.size() - 1) << test::all_problems(out);
    EXPECT_EQ(problem_line(out, "is seated on the pipe there"), 4);
    EXPECT_EQ(problem_line(out, "already meet"), -1);
    EXPECT_EQ(out.spools.size(), 1u);
  }
}

TEST(JointGraph, ReportsWeldsThatJoinNothing) {
  const Pipework out = read_good(
      pcf(pipe("0 0 0 4", "1000 0 0 4") + "WELD\n  CO-ORDS 500 0 0\n  SKEY WW\nWELD\n  SKEY WW\n"));
  EXPECT_EQ(problem_line(out, "stands where no two ends meet"), 7);
  EXPECT_EQ(problem_line(out, "has no place"), 10);
}

}  // namespace
}  // namespace spool::piping
