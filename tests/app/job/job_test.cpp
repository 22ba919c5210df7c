// A job's folder: made whole, opened again where it was, and what it does not accept.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/job/job.h"

#include <gtest/gtest.h>

#include "tests/support/refusal.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/write_file.h"
#include "tests/vision/piping/pcf_samples.h"
#include "vision/core/file_digest.h"
#include "vision/core/file_io.h"

namespace spool::test {
namespace {

using job::Job;
using job::JobUse;
using job::Outcome;

class JobFolder : public ::testing::Test {
 protected:
  void SetUp() override {
    pcf_ = write_file(folder_.path() / "line.pcf", spool_pcf());
    const Status made = job::create_job(path_, {.design = pcf_, .spool = "SP1"});
    ASSERT_TRUE(made) << made.error().message;
  }
  Result<Job> open(JobUse use = JobUse::kWork) const { return Job::open(path_, use); }
  static job::CheckRecord check(const char* status, Outcome outcome) {
    job::CheckRecord record;
    record.status = status;
    record.outcome = outcome;
    record.at = job::now();
    return record;
  }
  // job.json with a piece of its text replaced.
  void edit(const char* from, const std::string& to) const {
    write_file(path_ / "job.json", replaced(*read_file(path_ / "job.json"), from, to));
  }
  TemporaryFolder folder_;
  std::filesystem::path pcf_, path_ = folder_.path() / "line.spooljob";
};

TEST_F(JobFolder, HoldsTheDesignItWasMadeFrom) {
  auto job = open();
  ASSERT_TRUE(job) << job.error().message;
  EXPECT_EQ(job->file().spool, "SP1");
  EXPECT_EQ(*read_file(path_ / "source.pcf"), spool_pcf());
  EXPECT_EQ(job->file().source_sha256, sha256_hex(spool_pcf()));
  EXPECT_EQ(job->file().design_sha256, *sha256_file(path_ / "design.glb"));
  EXPECT_TRUE(std::filesystem::is_directory(path_ / "evidence"));
  EXPECT_EQ(job->steps().size(), job->design().parts.size());
  EXPECT_EQ(job->current_step(), 0);
  EXPECT_EQ(job->joint_text(0), "");
  EXPECT_EQ(job->joint_text(1), "W-101");
}

TEST_F(JobFolder, FromAnotherFilesSpoolIsRefused) {
  const auto other = folder_.path() / "other.spooljob";
  expect_refused(job::create_job(other, {.design = pcf_, .spool = "SP9"}), ErrorCode::kBadInput,
                 "line.pcf", "SP1");
  expect_refused(job::create_job(path_, {.design = pcf_, .spool = "SP1"}), ErrorCode::kIo,
                 "line.spooljob", "is there already");
  expect_refused(job::create_job(folder_.path() / "plain", {.design = pcf_, .spool = "SP1"}),
                 ErrorCode::kUsage, "plain", "NAME.spooljob");
  EXPECT_FALSE(std::filesystem::exists(other));
  const auto names = std::distance(std::filesystem::directory_iterator(folder_.path()),
                                   std::filesystem::directory_iterator());
  EXPECT_EQ(names, 2) << "something half made was left behind";
}

TEST_F(JobFolder, FromItsOwnGltfIsTheSame) {
  const auto second = folder_.path() / "second.spooljob";
  const Status made = job::create_job(second, {.design = path_ / "design.glb", .spool = "SP1"});
  ASSERT_TRUE(made) << made.error().message;
  auto job = Job::open(second, JobUse::kLook);
  ASSERT_TRUE(job) << job.error().message;
  EXPECT_EQ(job->file().order, open()->file().order);
  expect_refused(job::create_job(folder_.path() / "third.spooljob",
                                 {.design = path_ / "design.glb", .spool = "SP2"}),
                 ErrorCode::kBadInput, "design.glb", "holds SP1");
}

TEST_F(JobFolder, OpensAtTheStepWhereItWasLeft) {
  {
    auto job = open();
    ASSERT_TRUE(job);
    ASSERT_TRUE(job->add(0, check("ok", Outcome::kAccept)));
    ASSERT_TRUE(job->add(1, check("not_ok", Outcome::kRedo)));
    ASSERT_TRUE(job->add(1, check("ok", Outcome::kAccept)));
    EXPECT_EQ(job->current_step(), 2);
  }
  auto job = open();
  ASSERT_TRUE(job) << job.error().message;
  EXPECT_EQ(job->current_step(), 2);
  ASSERT_EQ(job->records().size(), 3u);
  EXPECT_EQ(job->records()[1].part, job->file().order[1]);
  EXPECT_EQ(job->records()[1].joint, "W-101");
}

TEST_F(JobFolder, AWrongStepIsAcceptedByAReasonOnly) {
  auto job = open();
  ASSERT_TRUE(job);
  for (const char* status : {"not_ok", "not_measured", ""})
    expect_refused(job->add(0, check(status, Outcome::kAccept)), ErrorCode::kUsage, "",
                   "cannot be accepted");
  job::CheckRecord remark = check("ok", Outcome::kRemark);
  expect_refused(job->add(0, remark), ErrorCode::kUsage, "", "remark's text");
  expect_refused(job->add(2, check("ok", Outcome::kAccept)), ErrorCode::kUsage, "",
                 "step 1 (flange-1) comes first");
  expect_refused(job->add(99, check("ok", Outcome::kAccept)), ErrorCode::kUsage, "", "steps 1 to");
  EXPECT_TRUE(job->records().empty());
  job::CheckRecord by_reason = check("not_ok", Outcome::kAccept);
  by_reason.override_reason = "agreed with QC";
  ASSERT_TRUE(job->add(0, by_reason));
  EXPECT_EQ(job->current_step(), 1);
  EXPECT_EQ(job->records().back().override_reason, "agreed with QC");
  EXPECT_TRUE(job->add(1, check("suspicious", Outcome::kAccept)));
}

TEST_F(JobFolder, AMovedOrderIsKeptAndWhatStandsStays) {
  std::vector<std::string> order;
  {
    auto job = open();
    ASSERT_TRUE(job);
    order = job->file().order;
    const int last = static_cast<int>(order.size()) - 1;
    // A move to the very end never takes anything from the moved part, but may from the others.
    expect_refused(job->move_step(1, last), ErrorCode::kUsage, "", "join nothing that stands");
    ASSERT_TRUE(job->add(0, check("ok", Outcome::kAccept)));
    EXPECT_FALSE(job->move_step(0, 1));
    bool moved = false;
    for (int s = 1; s < last && !moved; ++s) moved = bool(job->move_step(s, s + 1));
    ASSERT_TRUE(moved) << "no two neighbours of the order can change places";
    EXPECT_NE(job->file().order, order);
    order = job->file().order;
  }
  EXPECT_EQ(open()->file().order, order);
}

TEST_F(JobFolder, IsWorkedOnByOneAndLookedAtByAll) {
  auto first = open();
  ASSERT_TRUE(first);
  const auto second = open();
  expect_refused(second, ErrorCode::kIo, "line.spooljob", "is open elsewhere");
  ASSERT_TRUE(first->add(0, check("ok", Outcome::kAccept)));
  auto looking = open(JobUse::kLook);
  ASSERT_TRUE(looking) << looking.error().message;
  EXPECT_EQ(looking->current_step(), 1);
  EXPECT_FALSE(looking->add(1, check("ok", Outcome::kAccept)));
  EXPECT_FALSE(looking->move_step(1, 2));
}

TEST_F(JobFolder, OfALaterSchemaOrAnotherDesignIsRefused) {
  edit("spoolsight-job/1", "spoolsight-job/2");
  expect_refused(open(), ErrorCode::kBadInput, "job.json", "spoolsight-job/2");
  edit("spoolsight-job/2", "shopping");
  expect_refused(open(), ErrorCode::kBadInput, "job.json", "no SpoolSight job");
  edit("shopping", "spoolsight-job/1");
  edit("\"flange-1\"", "\"flange-9\"");
  expect_refused(open(), ErrorCode::kBadInput, "job.json", "cannot be built");
  edit("\"flange-9\"", "\"flange-1\"");
  edit("\"design.glb\"", "\"../design.glb\"");
  expect_refused(open(), ErrorCode::kBadInput, "job.json", "job's folder");
  edit("../design.glb", "design.glb");
  ASSERT_TRUE(open());
  std::string bytes = *read_file(path_ / "design.glb");
  bytes.back() = static_cast<char>(bytes.back() ^ 1);
  write_file(path_ / "design.glb", bytes);
  expect_refused(open(), ErrorCode::kBadInput, "design.glb", "SHA-256");
}

}  // namespace
}  // namespace spool::test
