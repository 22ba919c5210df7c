// A capture: its number, its name, what it refuses, and that a failure leaves nothing.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/evidence/capture.h"

#include <csignal>

#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/app/evidence/sample_job.h"
#include "tests/support/refusal.h"
#include "tests/support/write_file.h"
#include "vision/core/file_digest.h"
#include "vision/core/file_io.h"

namespace spool::test {
namespace {

namespace fs = std::filesystem;
using evidence::capture;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::size_t entries_in(const fs::path& job) {
  std::size_t count = 0;
  for ([[maybe_unused]] const auto& each : fs::directory_iterator(job / "evidence")) ++count;
  return count;
}

job::Job opened(const SampleJob& sample) {
  auto job = job::Job::open(sample.path(), job::JobUse::kWork);
  EXPECT_TRUE(job) << job.error().message;
  return *std::move(job);
}

TEST(Capture, HoldsItsFilesAndFollowsTheOneBefore) {
  const SampleJob sample;
  const auto first = sample.capture(1), second = sample.capture(2);
  ASSERT_TRUE(first && second);
  const auto entry = evidence::read_entry(second->folder);
  ASSERT_TRUE(entry) << entry.error().message;
  EXPECT_EQ(entry->number, 2);
  EXPECT_EQ(entry->previous_sha256, *sha256_file(first->folder / "entry.json"));
  EXPECT_EQ(entry->state, "state 2");
  EXPECT_EQ(entry->check.operator_name, "operator 1");
  EXPECT_EQ(entry->options.at("scan"), "scan");
  EXPECT_EQ(*read_file(second->folder / "points.ply"), *read_file(sample.outside("points.ply2")));
  EXPECT_EQ(*read_file(second->folder / "scan/000000.png"), "frame 2");
  const job::Job job = opened(sample);
  ASSERT_EQ(job.records().size(), 2u);
  EXPECT_EQ(job.records()[1].picture, "000002/overlay_1.png");
}

TEST(Capture, NeedsAName) {
  const SampleJob sample;
  job::Job job = opened(sample);
  auto request = sample.request(1);
  for (const char* name : {"", "  \t"}) {
    request.check.operator_name = name;
    expect_refused(capture(job, request), ErrorCode::kUsage, "who checked", "name");
  }
  request.check.operator_name = "\xc3\x28";
  expect_refused(capture(job, request), ErrorCode::kUsage, "operator's name", "UTF-8");
  request.check.operator_name = std::string(evidence::kMaxNameBytes + 1, 'a');
  expect_refused(capture(job, request), ErrorCode::kUsage, "operator's name", "shorten");
  EXPECT_EQ(entries_in(sample.path()), 0u);
}

TEST(Capture, TakesALongNameWithAccents) {
  const SampleJob sample;
  auto request = sample.request(1);
  request.check.operator_name.clear();
  while (request.check.operator_name.size() + 2 <= evidence::kMaxNameBytes)
    request.check.operator_name += "\xc3\xa9";  // é
  {
    job::Job job = opened(sample);
    const auto captured = capture(job, request);
    ASSERT_TRUE(captured) << captured.error().message;
    EXPECT_EQ(evidence::read_entry(captured->folder)->check.operator_name,
              request.check.operator_name);
  }
  EXPECT_THAT(told(sample.path()), IsEmpty());
}

TEST(Capture, OfAFileThatIsAnotherByNowLeavesNothing) {
  const SampleJob sample;
  {
    job::Job job = opened(sample);
    auto request = sample.request(1);
    request.files[0].sha256 = sha256_hex("something else");
    expect_refused(capture(job, request), ErrorCode::kBadInput, "report.json1", "inspect again");
    request = sample.request(1);
    request.files.push_back({sample.outside("missing"), "missing", ""});
    expect_refused(capture(job, request), ErrorCode::kBadInput, "missing", "cannot be read");
    request = sample.request(1);
    request.check.outcome = job::Outcome::kAccept;  // not_ok, and no reason given
    expect_refused(capture(job, request), ErrorCode::kUsage, "flange-1", "cannot be accepted");
    EXPECT_TRUE(job.records().empty());
  }
  EXPECT_EQ(entries_in(sample.path()), 0u);
  EXPECT_THAT(told(sample.path()), IsEmpty());
}

TEST(Capture, WithoutSpaceIsRefusedBeforeAnythingIsWritten) {
  const SampleJob sample;
  {
    job::Job job = opened(sample);
    auto request = sample.request(1);
    request.more_bytes = std::uint64_t{1} << 60U;
    bool is_asked = false;
    request.write_more = [&](const fs::path&) {
      is_asked = true;
      return Status{};
    };
    expect_refused(capture(job, request), ErrorCode::kIo, "evidence", "nothing was written");
    EXPECT_FALSE(is_asked);
  }
  EXPECT_EQ(entries_in(sample.path()), 0u);
  EXPECT_THAT(told(sample.path()), IsEmpty());
}

// Space that is gone only while it is written: files may not grow beyond a limit.
TEST(Capture, ThatTheDiskEndsUnderLeavesNothing) {
  const SampleJob sample;
  const pid_t child = ::fork();
  if (child == 0) {
    ::signal(SIGXFSZ, SIG_IGN);
    auto job = job::Job::open(sample.path(), job::JobUse::kWork);
    if (!job) ::_exit(2);
    const auto request = sample.request(1);
    const rlimit limit{2000, 2000};  // bytes; the sample's files have 3000
    ::setrlimit(RLIMIT_FSIZE, &limit);
    const auto captured = capture(*job, request);
    const bool is_told = !captured && captured.error().code == ErrorCode::kIo &&
                         captured.error().message.find("cannot be written") != std::string::npos;
    ::_exit(is_told ? 0 : 1);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_EQ(WEXITSTATUS(status), 0);
  EXPECT_EQ(entries_in(sample.path()), 0u);
  EXPECT_THAT(told(sample.path()), IsEmpty());
  const auto next = sample.capture(2);
  ASSERT_TRUE(next);
  EXPECT_EQ(next->number, 1);
}

// A file system of 1 MB that is full in truth; only who may mount one can try it.
TEST(Capture, OnAFullFileSystemIsRefusedWithTheReason) {
  const SampleJob sample;
  const fs::path disk = sample.outside("disk");
  fs::create_directory(disk);
  if (::mount("tmpfs", disk.c_str(), "tmpfs", 0, "size=1m") != 0)
    GTEST_SKIP() << "no right to mount a small file system";
  {
    const fs::path path = disk / "line.spooljob";
    fs::copy(sample.path(), path, fs::copy_options::recursive);
    for (const auto& each : fs::directory_iterator(sample.path())) {
      if (each.is_regular_file())
        fs::last_write_time(path / each.path().filename(), each.last_write_time());
    }
    {
      auto job = job::Job::open(path, job::JobUse::kWork);
      ASSERT_TRUE(job) << job.error().message;
      expect_refused(capture(*job, sample.request(1)), ErrorCode::kIo, "evidence", "MB are free");
    }
    EXPECT_EQ(entries_in(path), 0u);
    EXPECT_THAT(told(path), IsEmpty());
  }
  ::umount(disk.c_str());
}

TEST(Capture, OfTwoProcessesGetNumbersWithoutGapOrRepeat) {
  const SampleJob sample;
  constexpr int kProcesses = 2, kEach = 8;
  for (int p = 0; p < kProcesses; ++p) {
    if (::fork() != 0) continue;
    for (int done = 0; done < kEach;) {
      const auto captured = sample.capture(100 * p + done);
      if (captured)
        ++done;
      else if (captured.error().message.find("open elsewhere") == std::string::npos)
        ::_exit(1);
    }
    ::_exit(0);
  }
  for (int p = 0; p < kProcesses; ++p) {
    int status = 0;
    ::wait(&status);
    EXPECT_EQ(status, 0);
  }
  job::Job job = opened(sample);
  const auto captures = job.captures();
  ASSERT_TRUE(captures);
  ASSERT_EQ(captures->size(), std::size_t{kProcesses * kEach});
  for (std::size_t i = 0; i < captures->size(); ++i)
    EXPECT_EQ((*captures)[i].number, static_cast<std::int64_t>(i + 1));
  EXPECT_EQ(entries_in(sample.path()), captures->size());
}

TEST(Capture, IsSignedAndWhatIsDoneToTheSignatureIsTold) {
  const SampleJob sample;
  const auto key = sample.outside("shop.key").string(),
             other = sample.outside("other.key").string();
  const auto signer = evidence::make_key(key), stranger = evidence::make_key(other);
  ASSERT_TRUE(signer && stranger);
  ASSERT_TRUE(sample.capture(1, key));
  ASSERT_TRUE(sample.capture(2, key));
  EXPECT_THAT(told(sample.path(), *signer), IsEmpty());
  EXPECT_EQ(evidence::verify_job(sample.path())->signers, std::set<std::string>{*signer});
  EXPECT_THAT(told(sample.path(), *stranger), ElementsAre("changed evidence/000001/entry.sig",
                                                          "changed evidence/000002/entry.sig"));
  fs::path job = sample.copy();
  fs::remove(job / "evidence/000002/entry.sig");
  EXPECT_THAT(told(job), ElementsAre("removed evidence/000002/entry.sig"));
  // A good signature of the stranger's over the same entry.
  job = sample.copy();
  const std::string text = *read_file(job / "evidence/000001/entry.json");
  write_file(job / "evidence/000001/entry.sig",
             "ed25519\n" + *stranger + "\n" + evidence::read_key(other)->sign(text) + "\n");
  EXPECT_THAT(told(job), ElementsAre("changed evidence/000001/entry.sig"));
  // The signature of another entry.
  job = sample.copy();
  fs::copy(job / "evidence/000002/entry.sig", job / "evidence/000001/entry.sig",
           fs::copy_options::overwrite_existing);
  EXPECT_THAT(told(job), ElementsAre("changed evidence/000001/entry.sig"));
  ASSERT_TRUE(sample.capture(3));
  EXPECT_THAT(told(sample.path()), IsEmpty()) << "an unsigned entry is no alteration";
  EXPECT_THAT(told(sample.path(), *signer), ElementsAre("removed evidence/000003/entry.sig"));
}

}  // namespace
}  // namespace spool::test
