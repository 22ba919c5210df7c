// spoolsight-convert --isometric as a person runs it: pages, texts, states, refusals.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "render/image.h"
#include "tests/support/process.h"
#include "tests/support/refusal.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/write_file.h"
#include "tests/tools/inspect_run.h"
#include "tests/vision/guide/random_spool.h"
#include "tests/vision/piping/pcf_samples.h"
#include "vision/core/file_digest.h"
#include "vision/core/file_io.h"

namespace spool::test {
namespace {

class ConvertIsometric : public ::testing::Test {
 protected:
  std::string file(const char* name, const std::string& text) const {
    return write_file(folder_.path() / name, text).string();
  }
  std::string at(const char* name) const { return (folder_.path() / name).string(); }
  ProcessResult convert(const std::vector<std::string>& arguments) const {
    return run(program("spoolsight-convert"), arguments);
  }
  // Poppler's text of the pages, or "" where Poppler is not there.
  std::string text_of(const std::string& pdf, const char* page = nullptr) const {
    std::vector<std::string> arguments{"-layout", pdf, "-"};
    if (page != nullptr) arguments = {"-layout", "-f", page, "-l", page, pdf, "-"};
    return run("/usr/bin/pdftotext", arguments).out;
  }
  // A report on one part that is ok, of a job's design.
  std::string report(const std::string& job, const char* part) const {
    const nlohmann::json json = {
        {"schema", "spoolsight-report/1"},
        {"design", {{"sha256", *sha256_file(std::filesystem::path(job) / "design.glb")}}},
        {"parts", {{{"name", part}, {"status", "ok"}, {"size_checks", nlohmann::json::array()}}}},
        {"dimensions", nlohmann::json::array()}};
    return file("report.json", json.dump());
  }
  TemporaryFolder folder_;
};

bool holds(const std::string& text, const std::string& what) {
  return text.find(what) != std::string::npos;
}

#define NEEDS_POPPLER()                               \
  if (!std::filesystem::exists("/usr/bin/pdftotext")) \
  GTEST_SKIP() << "pdftotext (poppler-utils) is not there"

TEST_F(ConvertIsometric, TwoFacingPagesCutSheetAndWeldMap) {
  NEEDS_POPPLER();
  const std::string pcf = file("spool.pcf", spool_pcf());
  const ProcessResult result =
      convert({pcf, "--isometric", at("spool.pdf"), "--root-gap-mm", "3", "--date", "29 Nov 2026"});
  ASSERT_EQ(result.code, 0) << result.err;
  const ProcessResult info = run("/usr/bin/pdfinfo", {at("spool.pdf")});
  EXPECT_TRUE(holds(info.out, "Pages:           4")) << info.out;
  EXPECT_TRUE(holds(info.out, "(A3)")) << info.out;
  const std::string lines = text_of(at("spool.pdf"), "1"), model = text_of(at("spool.pdf"), "2");
  for (const char* each :
       {"W-101", "W1?", "FW-7 FW", "pipe-1", "elbow-2", "reducer-1", "valve-1", "olet-1"}) {
    EXPECT_TRUE(holds(lines, each)) << each << "\n" << lines;
    EXPECT_TRUE(holds(model, each)) << each << " on the shaded side\n" << model;
  }
  for (const char* each : {"500", "86", "89", "276", "N 198", "UP 198", "310", "29 Nov 2026",
                           "10-3-PL-3259-002", "1 of 4", "root gap 3"})
    EXPECT_TRUE(holds(lines, each)) << each;
  const std::string cuts = text_of(at("spool.pdf"), "3"), welds = text_of(at("spool.pdf"), "4");
  EXPECT_TRUE(holds(cuts, "H-77")) << cuts;  // the heat that the file names
  for (const char* each :
       {"HOLD", "Welder", "WPS", "to do", "roll", "site FW", "branch weld on the side of pipe-4"})
    EXPECT_TRUE(holds(welds, each)) << each << "\n" << welds;
}

TEST_F(ConvertIsometric, EveryNumberOfFortyPartsIsOnThePaper) {
  NEEDS_POPPLER();
  for (const unsigned seed : {11U, 12U, 13U}) {
    const std::string pcf = file("random.pcf", random_spool_pcf({.seed = seed, .inches = true}));
    const ProcessResult result = convert({pcf, "--isometric", at("random.pdf")});
    ASSERT_EQ(result.code, 0) << result.err;
    EXPECT_FALSE(holds(result.err, "no room")) << result.err;
    const std::string lines = text_of(at("random.pdf"), "1");
    for (int weld = 1; weld <= 30; ++weld)
      EXPECT_TRUE(holds(lines, "W" + std::to_string(weld))) << weld << " of seed " << seed;
    for (int pipe = 1; pipe <= 15; ++pipe)
      EXPECT_TRUE(holds(lines, "pipe-" + std::to_string(pipe))) << pipe << " of seed " << seed;
  }
}

TEST_F(ConvertIsometric, EqualInputsGiveEqualFiles) {
  const std::string pcf = file("spool.pcf", spool_pcf());
  ASSERT_EQ(convert({pcf, "--isometric", at("one.pdf")}).code, 0);
  ASSERT_EQ(convert({pcf, "--isometric", at("two.pdf")}).code, 0);
  EXPECT_EQ(*read_file(at("one.pdf")), *read_file(at("two.pdf")));
}

TEST_F(ConvertIsometric, PicturesAreOneAPage) {
  const std::string pcf = file("spool.pcf", spool_pcf());
  const ProcessResult result = convert({pcf, "--isometric", at("spool.png")});
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_FALSE(std::filesystem::exists(at("spool.png")));
  EXPECT_FALSE(std::filesystem::exists(at("spool-5.png")));
  for (const char* name : {"spool-1.png", "spool-2.png", "spool-3.png", "spool-4.png"}) {
    const auto image = render::read_png(at(name));
    ASSERT_TRUE(image) << name;
    EXPECT_EQ(image->width, 3307);  // 420 mm at 200 dpi
  }
}

TEST_F(ConvertIsometric, LengthsInFeetAndInches) {
  NEEDS_POPPLER();
  const std::string pcf =
      file("one.pcf", test::pcf("PIPE\n    END-POINT 0 0 0 4\n    END-POINT 914.4 0 0 4\n"));
  ASSERT_EQ(convert({pcf, "--isometric", at("one.pdf"), "--feet-inches"}).code, 0);
  EXPECT_TRUE(holds(text_of(at("one.pdf"), "1"), "3' 0")) << text_of(at("one.pdf"), "1");
}

TEST_F(ConvertIsometric, TheStateOfAWeldIsTheJobs) {
  NEEDS_POPPLER();
  const std::string pcf = file("spool.pcf", spool_pcf());
  ASSERT_EQ(
      run(program("spoolsight-job"), {"new", pcf, "--spool", "SP1", "-o", at("SP1.spooljob")}).code,
      0);
  const std::string job = at("SP1.spooljob");
  for (const auto& [step, part] : {std::pair{"1", "flange-1"}, {"2", "pipe-1"}}) {
    const ProcessResult checked =
        run(program("spoolsight-job"), {"check", job, "--step", step, "--report", report(job, part),
                                        "--outcome", "accept", "--operator", "A. Fitter"});
    ASSERT_EQ(checked.code, 0) << checked.err;
  }
  const ProcessResult result =
      convert({pcf, "--spool", "SP1", "--isometric", at("spool.pdf"), "--job", at("SP1.spooljob")});
  ASSERT_EQ(result.code, 0) << result.err;
  const std::string welds = text_of(at("spool.pdf"), "4");
  EXPECT_TRUE(holds(welds, "checked")) << welds;
  EXPECT_TRUE(holds(welds, "A. Fitter 2")) << welds;
  EXPECT_TRUE(holds(welds, "to do")) << welds;
  expect_refused(convert({file("other.pcf", random_spool_pcf({.seed = 1})), "--isometric",
                          at("o.pdf"), "--job", at("SP1.spooljob")}),
                 "spoolsight-convert", 65, "another design");
}

TEST_F(ConvertIsometric, ADesignThatDoesNotSayWhatItIsIsRefused) {
  const std::string stl = file("bare.stl",
                               "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n"
                               "vertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid s\n");
  expect_refused(convert({stl, "--design-unit", "m", "--isometric", at("bare.pdf")}),
                 "spoolsight-convert", 65, "does not say what its parts are");
  EXPECT_FALSE(std::filesystem::exists(at("bare.pdf")));
}

TEST_F(ConvertIsometric, RefusesWhatMakesNoSense) {
  const std::string pcf = file("spool.pcf", spool_pcf());
  expect_refused(convert({pcf, "--isometric", at("spool.svg")}), "spoolsight-convert", 64,
                 "written as .pdf or .png");
  expect_refused(convert({pcf, "--info", "--date", "today"}), "spoolsight-convert", 64,
                 "are of --isometric");
}

TEST_F(ConvertIsometric, APlaceThatCannotBeWrittenIsTold) {
  const std::string pcf = file("spool.pcf", spool_pcf());
  for (const char* name : {"nowhere/spool.pdf", "nowhere/spool.png"}) {
    const ProcessResult result = convert({pcf, "--isometric", at(name)});
    EXPECT_EQ(result.code, 74) << result.err;
    EXPECT_TRUE(holds(result.err, "nowhere/spool")) << result.err;
  }
}

}  // namespace
}  // namespace spool::test
