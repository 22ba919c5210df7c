// spoolsight-job ncr as a person runs it: files, numbers, refusals, a full disk.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <string>
#include <vector>

#include <unistd.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/app/evidence/json_schema.h"
#include "tests/app/ncr/sample_ncr.h"
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

namespace fs = std::filesystem;

class JobNcr : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto pcf = write_file(folder_.path() / "line.pcf", spool_pcf());
    ASSERT_EQ(run(program("spoolsight-job"), {"new", pcf, "--spool", "SP1", "-o", job_}).code, 0);
    write_report(report_, *sha256_file(fs::path(job_) / "design.glb"));
  }
  ProcessResult ncr(std::vector<std::string> more, const ProcessOptions& options = {}) const {
    more.insert(more.begin(), {"ncr", job_});
    return run(program("spoolsight-job"), more, options);
  }
  ProcessResult write(std::vector<std::string> more = {},
                      const ProcessOptions& options = {}) const {
    more.insert(more.begin(), {"--report", report_, "--shop", "F01"});
    return ncr(more, options);
  }
  fs::path file(const std::string& number, const char* ending) const {
    return fs::path(job_) / "ncr" / number / (number + ending);
  }
  TemporaryFolder folder_;
  std::string job_ = (folder_.path() / "3032.spooljob").string();
  std::string report_ = (folder_.path() / "out").string();
};

TEST_F(JobNcr, WritesFourFilesAndPrintsTheNumber) {
  const auto fields = write_file(
      folder_.path() / "fields.json",
      R"({"head.issued_to": "Société \"É\" <& Cie>", "recommended_action.action": "Use as is"})");
  const ProcessResult made = write({"--operator", "NAME", "--fields", fields, "--units", "ft-in"});
  ASSERT_EQ(made.code, 0) << made.err;
  EXPECT_EQ(made.out, "3032-F01-NCR-001\n");
  EXPECT_EQ(write().out, "3032-F01-NCR-002\n") << "an operator without a name is no obstacle";
  for (const char* ending : {".pdf", ".html", ".json", ".bcfzip"})
    EXPECT_GT(fs::file_size(file("3032-F01-NCR-001", ending)), 500U) << ending;
  const auto json = nlohmann::json::parse(*read_file(file("3032-F01-NCR-001", ".json")));
  const auto schema = nlohmann::json::parse(*read_file(source_dir() / "assets/ncr.schema.json"));
  for (const auto& each : schema_violations(schema, json)) ADD_FAILURE() << each;
  EXPECT_EQ(json["form"][2]["value"], "Société \"É\" <& Cie>");
  const std::string html = *read_file(file("3032-F01-NCR-001", ".html"));
  EXPECT_NE(html.find("Soci\u00e9t\u00e9 &quot;\u00c9&quot; &lt;&amp; Cie&gt;"), std::string::npos);
  EXPECT_NE(html.find("11 13/16&quot;"), std::string::npos) << "0.3 m in inches";
}

TEST_F(JobNcr, BelongsToWhatVerifyKnows) {
  const auto verify = [&] { return run(program("spoolsight-inspect"), {"--verify", job_}); };
  ASSERT_EQ(write().code, 0);
  ASSERT_EQ(ncr({"--void", "3032-F01-NCR-001", "--reason", "r", "--operator", "NAME"}).code, 0);
  ASSERT_EQ(write().code, 0);
  const ProcessResult intact = verify();
  EXPECT_EQ(intact.code, 0) << intact.out << intact.err;
  const auto expect_told = [&](const std::string& what) {
    const ProcessResult told = verify();
    EXPECT_EQ(told.code, 1) << what;
    EXPECT_NE(told.out.find(what), std::string::npos) << told.out;
  };
  // One bit of each of its files.
  for (const char* ending : {".pdf", ".html", ".json", ".bcfzip"}) {
    const fs::path path = file("3032-F01-NCR-002", ending);
    const std::string was = *read_file(path);
    std::string is = was;
    is[is.size() / 2] = static_cast<char>(is[is.size() / 2] ^ 4);
    write_file(path, is);
    expect_told(std::string("changed: ncr/3032-F01-NCR-002/3032-F01-NCR-002") + ending);
    write_file(path, was);
  }
  const fs::path list = fs::path(job_) / "ncr/3032-F01-NCR-002/files.json";
  const std::string was = *read_file(list);
  write_file(list, replaced(was, "\"bytes\": ", "\"bytes\": 1"));
  expect_told("changed: ncr/3032-F01-NCR-002/files.json");
  write_file(list, was);
  write_file(fs::path(job_) / "ncr/3032-F01-NCR-002/more.txt", "");
  expect_told("added: ncr/3032-F01-NCR-002/more.txt");
  fs::remove_all(fs::path(job_) / "ncr/3032-F01-NCR-002");
  expect_told("removed: ncr/3032-F01-NCR-002");
}

TEST_F(JobNcr, KeepsVoidNumbersUsed) {
  ASSERT_EQ(write().code, 0);
  const ProcessResult done =
      ncr({"--void", "3032-F01-NCR-001", "--reason", "wrong spool", "--operator", "NAME"});
  ASSERT_EQ(done.code, 0) << done.err;
  EXPECT_EQ(write().out, "3032-F01-NCR-002\n");
  expect_refused(ncr({"--void", "3032-F01-NCR-009", "--reason", "r"}), "spoolsight-job", 64,
                 "no report");
  expect_refused(ncr({"--void", "3032-F01-NCR-002"}), "spoolsight-job", 64, "why");
}

TEST_F(JobNcr, RefusesWhatMakesNoSense) {
  expect_refused(ncr({}), "spoolsight-job", 64, "--report and --shop");
  expect_refused(ncr({"--report", report_, "--shop", "a/b"}), "spoolsight-job", 64, "letters");
  expect_refused(ncr({"--report", job_, "--shop", "F"}), "spoolsight-job", 65, "report.json");
  const auto fields = write_file(folder_.path() / "fields.json", R"({"head.colour": "red"})");
  expect_refused(write({"--fields", fields}), "spoolsight-job", 65, "head.colour");
  EXPECT_FALSE(fs::exists(fs::path(job_) / "ncr")) << "nothing is begun for a refusal";
}

TEST_F(JobNcr, OnAFullDiskNothingIsHalfWritten) {
  // More than what the journal maps in memory (32 KiB), less than the PDF with its letters.
  const ProcessResult full = write({}, {.file_size_limit_bytes = 34'000});
  EXPECT_EQ(full.code, 74) << full.err;
  EXPECT_NE(full.err.find("3032-F01-NCR-001"), std::string::npos) << full.err;
  for (const auto& entry : fs::directory_iterator(fs::path(job_) / "ncr"))
    EXPECT_EQ(entry.path().filename(), "lock");
  EXPECT_EQ(write().out, "3032-F01-NCR-001\n");
}

TEST_F(JobNcr, InAFolderThatTakesNothingItSaysSo) {
  // A file where the folder is to be: rights do not stop the administrator.
  write_file(fs::path(job_) / "ncr", "");
  EXPECT_EQ(write().code, 74);
  fs::remove(fs::path(job_) / "ncr");
  fs::permissions(job_, fs::perms::owner_read | fs::perms::owner_exec);
  if (::geteuid() != 0) {
    EXPECT_EQ(write().code, 74);
    EXPECT_FALSE(fs::exists(fs::path(job_) / "ncr"));
  }
  fs::permissions(job_, fs::perms::owner_all);
}

}  // namespace
}  // namespace spool::test
