// spoolsight-job as a person runs it, from a piping file to the export.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/process.h"
#include "tests/support/refusal.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/write_file.h"
#include "tests/vision/piping/pcf_samples.h"
#include "vision/core/file_digest.h"
#include "vision/core/file_io.h"

namespace spool::test {
namespace {

bool holds(const std::string& text, const std::string& what) {
  return text.find(what) != std::string::npos;
}

class JobTool : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto pcf = write_file(folder_.path() / "line.pcf", spool_pcf());
    const ProcessResult made = tool(
        {"new", pcf, "--spool", "SP1", "--gap-rule", "subtract", "--root-gap-mm", "3", "-o", job_});
    ASSERT_EQ(made.code, 0) << made.err;
  }
  ProcessResult tool(const std::vector<std::string>& arguments,
                     const ProcessOptions& options = {}) const {
    return run(program("spoolsight-job"), arguments, options);
  }
  ProcessResult check(int step, const std::string& report, const std::string& outcome,
                      std::vector<std::string> more = {}) const {
    std::vector<std::string> all{"check",    job_,   "--step",    std::to_string(step),
                                 "--report", report, "--outcome", outcome};
    all.insert(all.end(), more.begin(), more.end());
    return tool(all);
  }
  // A report on one part, with a length of `measured` m.
  std::string report(const std::string& part, const char* status, double measured) const {
    nlohmann::json json = {
        {"schema", "spoolsight-report/1"},
        {"design", {{"sha256", *sha256_file(std::filesystem::path(job_) / "design.glb")}}},
        {"parts", {{{"name", part}, {"status", status}, {"size_checks", nlohmann::json::array()}}}},
        {"dimensions",
         {{{"name", "=length"},
           {"kind", "face_to_face"},
           {"from", part + "/a"},
           {"to", "x/b"},
           {"nominal_m", 0.3},
           {"measured_m", measured},
           {"u_m", 0.0004},
           {"status", status}}}}};
    return write_file(folder_.path() / "report.json", json.dump()).string();
  }
  TemporaryFolder folder_;
  std::string job_ = (folder_.path() / "line.spooljob").string();
};

TEST_F(JobTool, ShowsStepsWithWeldsAndCuts) {
  const ProcessResult shown = tool({"show", job_});
  ASSERT_EQ(shown.code, 0) << shown.err;
  for (const char* text : {"> ", "flange-1", "W-101 (fab) to flange-1, from +x",
                           "cut 310.2 mm (c-c 500.0 mm)", "next: step 1, flange-1"})
    EXPECT_TRUE(holds(shown.out, text)) << text << " is not in\n" << shown.out;
}

TEST_F(JobTool, KeepsChecksAndExportsThem) {
  ASSERT_EQ(check(1, report("flange-1", "ok", 0.3), "accept").code, 0);
  ASSERT_EQ(check(2, report("pipe-1", "not_ok", 0.31), "redo").code, 0);
  const std::string wrong = report("pipe-1", "not_ok", 0.305);
  expect_refused(check(2, wrong, "accept"), "spoolsight-job", 64, "cannot be accepted");
  ASSERT_EQ(check(2, wrong, "accept", {"--override", "QC agreed", "--operator", "operator 1"}).code,
            0);
  const std::string welded = report("pipe-1", "ok", 0.3035);
  ASSERT_EQ(check(2, welded, "accept", {"--phase", "after-weld"}).code, 0);
  const ProcessResult shown = tool({"show", job_});
  EXPECT_TRUE(holds(shown.out, "next: step 3")) << shown.out;
  EXPECT_TRUE(holds(shown.out, "W-101: accepted, 2 tries")) << shown.out;
  EXPECT_TRUE(holds(shown.out, "1 by override, =length -1.50 +- 1.13 mm")) << shown.out;
  const ProcessResult csv = tool({"export", job_, "--csv"});
  EXPECT_TRUE(holds(csv.out, "\"'=length\"")) << "a spreadsheet would run it:\n" << csv.out;
  EXPECT_TRUE(holds(csv.out, "\"QC agreed\"")) << csv.out;
  std::istringstream lines(tool({"export", job_, "--jsonl"}).out);
  std::vector<nlohmann::json> events;
  for (std::string line; std::getline(lines, line);) events.push_back(nlohmann::json::parse(line));
  ASSERT_EQ(events.size(), 5u);
  EXPECT_EQ(events[2]["override_reason"], "QC agreed");
  EXPECT_EQ(events[2]["numbers"][0]["measured_m"], 0.305);
  EXPECT_EQ(events[4]["event"], "joint");
  EXPECT_NEAR(events[4]["shrinkage"][0]["change_m"].get<double>(), -0.0015, 1e-9);
}

TEST_F(JobTool, DrawsChartsOfTriesAndMinutes) {
  ASSERT_EQ(check(1, report("flange-1", "ok", 0.3), "accept").code, 0);
  ASSERT_EQ(check(2, report("pipe-1", "not_ok", 0.31), "redo").code, 0);
  ASSERT_EQ(check(2, report("pipe-1", "ok", 0.3), "accept").code, 0);
  const std::string pdf = (folder_.path() / "charts.pdf").string();
  const ProcessResult drawn = tool({"charts", job_, "-o", pdf});
  ASSERT_EQ(drawn.code, 0) << drawn.err;
  EXPECT_TRUE(holds(drawn.out, "written to " + pdf)) << drawn.out;
  if (std::filesystem::exists("/usr/bin/pdftotext")) {
    const std::string text = run("/usr/bin/pdftotext", {"-layout", pdf, "-"}).out;
    for (const char* word : {"W-101", "pipe-1", "no check yet", "Tries and minutes by joint",
                             "What each try measured"})
      EXPECT_TRUE(holds(text, word)) << word << " is not in\n" << text;
  }
  expect_refused(tool({"charts", job_, "-o", "charts.svg"}), "spoolsight-job", 64, ".pdf or .png");
  const ProcessResult full = tool({"charts", job_, "-o", (folder_.path() / "full.pdf").string()},
                                  {.file_size_limit_bytes = 1024});
  EXPECT_EQ(full.code, 74) << full.err;
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "full.pdf"));
}

TEST_F(JobTool, MovesStepsAndRefusesWhatCannotBeBuilt) {
  expect_refused(tool({"order", job_, "--move", "7", "2"}), "spoolsight-job", 64, "cannot be done");
  expect_refused(tool({"order", job_, "--move", "1", "80"}), "spoolsight-job", 64, "steps 1 to");
  // Started from the pipe, with the flange last.
  ASSERT_EQ(tool({"order", job_, "--move", "1", "8"}).code, 0);
  EXPECT_TRUE(holds(tool({"show", job_}).out, "next: step 1, pipe-1"));
}

TEST_F(JobTool, OnAFullDiskSaysSo) {
  const ProcessResult full = tool({"check", job_, "--step", "1", "--report",
                                   report("flange-1", "ok", 0.3), "--outcome", "accept"},
                                  {.file_size_limit_bytes = 1024});
  EXPECT_EQ(full.code, 74) << full.err;
  EXPECT_TRUE(holds(full.err, "space")) << full.err;
  EXPECT_TRUE(holds(tool({"show", job_}).out, "next: step 1"));
}

TEST_F(JobTool, SalvagesADamagedJournalAndGoesOn) {
  for (int i = 0; i < 40; ++i) ASSERT_EQ(check(1, report("flange-1", "ok", 0.3), "accept").code, 0);
  expect_refused(tool({"salvage", job_}), "spoolsight-job", 64, "is sound");
  const auto path = std::filesystem::path(job_) / "journal.db";
  std::string bytes = *read_file(path);
  for (std::size_t i = bytes.size() - 4096; i < bytes.size(); ++i) bytes[i] = '\x5a';
  write_file(path, bytes);
  const ProcessResult shown = tool({"show", job_});
  EXPECT_EQ(shown.code, 65);
  EXPECT_TRUE(holds(shown.err, "is damaged")) << shown.err;
  EXPECT_EQ(check(1, report("flange-1", "ok", 0.3), "accept").code, 65);
  expect_refused(tool({"charts", job_, "-o", "none.pdf"}), "spoolsight-job", 65, "salvage");
  const ProcessResult salvaged = tool({"salvage", job_});
  ASSERT_EQ(salvaged.code, 0) << salvaged.err;
  EXPECT_TRUE(holds(salvaged.out, "salvaged ")) << salvaged.out;
  EXPECT_EQ(*read_file(std::filesystem::path(job_) / "journal.damaged-1.db"), bytes);
  EXPECT_EQ(check(1, report("flange-1", "ok", 0.3), "accept").code, 0);
  EXPECT_TRUE(holds(tool({"show", job_}).out, "next: step 2"));
}

}  // namespace
}  // namespace spool::test
