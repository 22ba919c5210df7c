// spoolsight-convert as a person runs it, and a piping file given to spoolsight-inspect.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/process.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/write_file.h"
#include "tests/tools/inspect_run.h"
#include "tests/vision/piping/pcf_samples.h"
#include "vision/design/design_reader.h"
#include "vision/design/sampling.h"

namespace spool::test {
namespace {

class Convert : public ::testing::Test {
 protected:
  std::string file(const char* name, const std::string& text) const {
    return write_file(folder_.path() / name, text).string();
  }
  std::string at(const char* name) const { return (folder_.path() / name).string(); }
  ProcessResult convert(const std::vector<std::string>& arguments) const {
    return run(program("spoolsight-convert"), arguments);
  }
  TemporaryFolder folder_;
};

bool holds(const std::string& text, const std::string& what) {
  return text.find(what) != std::string::npos;
}

TEST_F(Convert, WritesTheDesignAsGltf) {
  const std::string pcf = file("spool.pcf", spool_pcf());
  const ProcessResult result = convert({pcf, "-o", at("spool.glb")});
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_TRUE(holds(result.out, "14 parts, 13 joints")) << result.out;
  const auto design = read_design(at("spool.glb"));
  ASSERT_TRUE(design) << design.error().message;
  EXPECT_EQ(design->parts.size(), 14u);
  EXPECT_EQ(design->line, "10-3-PL-3259-002");
  EXPECT_TRUE(design->warnings.empty());
}

TEST_F(Convert, PrintsWhatItUnderstood) {
  const std::string text =
      replaced(spool_pcf(), "ANGLE             9000", "ANGLE             4500");
  const ProcessResult result = convert({file("spool.pcf", text), "--info", "--root-gap-mm", "3"});
  ASSERT_EQ(result.code, 0) << result.err;
  for (const char* line :
       {"14 components in 1 pipeline, coordinates in MM, bores in inch",
        "pipeline 10-3-PL-3259-002 (line 7), spec CS150, class 150, revision 2",
        "SP1: 8 parts, 7 fab, 1 field, 0 yaw welds", "tag HV-101", "NPS 3 x 2",
        "W-101    fab    flange-1 to pipe-1, line 28", "no WELD in the file (number made up)",
        "cut list, mm, root gap 3.0 mm",
        "500.0 to centres: flange-1 less 69.8 and gap 3.0; elbow-1 less 114.0 and gap 3.0; cut "
        "310.2",
        "support PS-12 SKID (line 121)", "bolts B16", "END-CONNECTION-EQUIPMENT", "problems: 1",
        "line 34: ELBOW (line 34) says 45.00 degrees and is drawn at 90.00"})
    EXPECT_TRUE(holds(result.out, line)) << line << "\nis not in\n" << result.out;
  EXPECT_FALSE(std::filesystem::exists(at("spool.glb")));
}

TEST_F(Convert, FlagsSpoolsThatItMadeUp) {
  const std::string text = replaced(spool_pcf(), "    SPOOL-IDENTIFIER  SP1\n", "");
  const ProcessResult result =
      convert({file("spool.pcf", replaced(text, "    SPOOL-IDENTIFIER  SP2\n", "")), "--info"});
  EXPECT_TRUE(holds(result.out, "10-3-PL-3259-SP1 (made up: the file names none): 8 parts"))
      << result.out;
  EXPECT_FALSE(holds(convert({file("named.pcf", spool_pcf()), "--info"}).out, "made up: the file"));
}

TEST_F(Convert, WarnsOfProblemsWhileItWrites) {
  const std::string text = replaced(spool_pcf(), "576.0 2", "580.0 2");
  const ProcessResult result = convert({file("spool.pcf", text), "-o", at("spool.glb")});
  EXPECT_EQ(result.code, 0);
  EXPECT_TRUE(holds(result.err, "warning: line 47: TEE (line 47) has a branch of 80.0 mm"))
      << result.err;
}

TEST_F(Convert, EndsWithTheCodesOfAllPrograms) {
  const std::string pcf = file("spool.pcf", spool_pcf());
  const std::string glb = at("spool.glb");
  const struct {
    std::vector<std::string> arguments;
    int code;
    const char* says;
  } cases[] = {
      {{}, 64, "design"},
      {{pcf}, 64, "give -o FILE.glb, --info, --isometric FILE.pdf or several"},
      {{pcf, "-o", at("spool.stl")}, 64, "a design is written as .glb"},
      {{pcf, "--info", "--root-gap-mm", "-1"}, 64, "--root-gap-mm"},
      {{file("mesh.obj", "v 0 0 0\n"), "--info"}, 64, "--info is of a .pcf file"},
      {{at("none.pcf"), "-o", glb}, 65, "none.pcf"},
      {{file("zero.pcf", test::pcf("PIPE\n  END-POINT 0 0 0 4\n  END-POINT 0 0 0 4\n")), "--info"},
       65,
       "only zeros"},
      {{file("font.pcf", std::string("\x01") + "fcp____"), "-o", glb}, 65, "screen font"},
      {{pcf, "-o", at("missing/spool.glb")}, 74, "spool.glb"},
  };
  for (const auto& each : cases) {
    const ProcessResult result = convert(each.arguments);
    EXPECT_EQ(result.code, each.code) << each.says << "\n" << result.err;
    EXPECT_TRUE(holds(result.err, each.says)) << each.says << "\nis not in\n" << result.err;
  }
  EXPECT_EQ(convert({"--version"}).code, 0);
}

TEST_F(Convert, TakesTheUnitThatIsAskedFor) {
  const std::string pcf = file("spool.pcf", replaced(spool_pcf(), "UNITS-CO-ORDS   MM\n", ""));
  const ProcessResult guessed = convert({pcf, "-o", at("guessed.glb")});
  EXPECT_EQ(guessed.code, 0);
  EXPECT_TRUE(holds(guessed.err, "confirm it by --design-unit")) << guessed.err;
  const ProcessResult told = convert({pcf, "-o", at("told.glb"), "--design-unit", "mm"});
  EXPECT_EQ(told.code, 0);
  EXPECT_FALSE(holds(told.err, "--design-unit")) << told.err;
}

TEST_F(Convert, WritesOneSpoolOfSeveral) {
  const std::string pcf = file("spool.pcf", spool_pcf());
  const ProcessResult result = convert({pcf, "--spool", "SP2", "-o", at("two.glb"), "--info"});
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_TRUE(holds(result.out, "4 components")) << result.out;
  EXPECT_FALSE(holds(result.out, "SP1")) << result.out;
  const auto design = read_design(at("two.glb"));
  ASSERT_TRUE(design) << design.error().message;
  EXPECT_EQ(design->spool, "SP2");
  EXPECT_EQ(design->parts.size(), 4u);  // no gasket, no valve: those go up on site
  EXPECT_EQ(design->joints.size(), 3u);
  const ProcessResult none = convert({pcf, "--spool", "SP3", "-o", at("three.glb")});
  EXPECT_EQ(none.code, 65);
  EXPECT_TRUE(holds(none.err, "'SP3' is no spool of the file; its spools are SP1, SP2"))
      << none.err;
}

TEST_F(Convert, InspectTakesAPipingFileAsDesign) {
  const std::string pcf = file("spool.pcf", spool_pcf());
  const auto design = read_design(pcf);
  ASSERT_TRUE(design) << design.error().message;
  const SurfaceSamples samples = sample_surface(*design, 6000);
  std::ofstream scan(folder_.path() / "scan.xyz");
  for (const Eigen::Vector3f& point : samples.cloud.points) {
    const Eigen::Vector3d p = point.cast<double>() + design->origin;
    scan << p.x() << " " << p.y() << " " << p.z() << "\n";
  }
  scan.close();
  write_pose(folder_.path() / "pose.json", Eigen::Isometry3d::Identity());
  const InspectRun result = run_inspect(
      {"--design", pcf, "--scan", at("scan.xyz"), "--scan-unit", "m", "--pose", at("pose.json")},
      folder_.path() / "out");
  EXPECT_EQ(result.process.code, 2) << result.process.err;  // nothing is ok until features decide
  EXPECT_EQ(result.report["parts"].size(), 14u);
  EXPECT_EQ(result.report["datum"][0], "flange-1");
  EXPECT_EQ(result.report["parts"][1]["name"], "pipe-1");
  EXPECT_GT(result.report["parts"][1]["points"].get<int>(), 100);
  // The scan is the design itself: all of it is explained but what lies in the bores, behind the
  // outside that a camera sees.
  EXPECT_GT(result.report["alignment"]["overlap"].get<double>(), 0.5);
}

}  // namespace
}  // namespace spool::test
