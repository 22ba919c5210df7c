// A process that captures is killed at random moments: every capture is whole or absent, and the
// chain holds.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <cstdlib>
#include <optional>
#include <random>
#include <string>
#include <string_view>

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/app/evidence/sample_job.h"

namespace spool::test {
namespace {

int kills = 20;  // --kills=N

// In the child: captures without end, and says each number once it has it. Every few captures the
// job is closed and opened, as a person does.
[[noreturn]] void capture_for_ever(const SampleJob& sample, int out) {
  for (int seed = 1;; ++seed) {
    auto job = job::Job::open(sample.path(), job::JobUse::kWork);
    if (!job || !job->alterations().empty()) ::_exit(1);
    for (int i = 0; i < 3; ++i) {
      const auto captured = evidence::capture(*job, sample.request(seed + i));
      if (!captured ||
          ::write(out, &captured->number, sizeof captured->number) != sizeof captured->number)
        ::_exit(1);
    }
  }
}

TEST(CaptureKill, LeavesEveryCaptureWholeOrAbsentAndTheChainHolds) {
  std::optional<SampleJob> job;
  constexpr int kKillsOfOne = 20;  // all of a job is verified after every kill
  std::mt19937 random(20261129);
  std::uniform_int_distribution<useconds_t> moment(5'000, 400'000);  // us
  std::int64_t told_last = 0, captures = 0;
  int waiting = 0, begun = 0;
  for (int kill = 0; kill < kills; ++kill) {
    if (kill % kKillsOfOne == 0) {
      job.emplace();
      told_last = 0;
    }
    const SampleJob& sample = *job;
    const std::int64_t before = told_last;
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) capture_for_ever(sample, ends[1]);
    ::close(ends[1]);
    ::usleep(moment(random));
    ASSERT_EQ(::kill(child, SIGKILL), 0);
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status)) << "the child ended by itself in round " << kill;
    for (std::int64_t number = 0; ::read(ends[0], &number, sizeof number) == sizeof number;) {
      EXPECT_EQ(number, told_last + 1) << "a gap or a number twice in round " << kill;
      told_last = number;
    }
    ::close(ends[0]);
    const auto verified = evidence::verify_job(sample.path());
    ASSERT_TRUE(verified) << verified.error().message;
    for (const auto& change : verified->changes)
      ADD_FAILURE() << "round " << kill << ": " << change.file << " " << change.text;
    // One more than was told may be in the journal when the kill came before the word.
    ASSERT_GE(verified->entries, told_last) << "round " << kill;
    ASSERT_LE(verified->entries, told_last + 1) << "round " << kill;
    ASSERT_EQ(verified->files, 4 * verified->entries) << "round " << kill;
    told_last = verified->entries;
    captures += told_last - before;
    for (const std::string& note : verified->notes) {
      waiting += note.find("waits for its name") != std::string::npos ? 1 : 0;
      begun += note.find("broken off") != std::string::npos ? 1 : 0;
    }
  }
  EXPECT_GT(captures, kills / 4) << "hardly anything was captured before the kills";
  // The next one clears away what was begun, and closes the job.
  ASSERT_TRUE(job->capture(1));
  const auto verified = evidence::verify_job(job->path());
  ASSERT_TRUE(verified);
  EXPECT_TRUE(verified->changes.empty());
  EXPECT_THAT(verified->notes, ::testing::IsEmpty());
  RecordProperty("captures", static_cast<int>(captures));
  std::printf("%d kills, %ld captures, %d broken off, %d waiting for their name\n", kills,
              static_cast<long>(captures), begun, waiting);
}

}  // namespace
}  // namespace spool::test

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  constexpr std::string_view kOption = "--kills=";
  for (int i = 1; i < argc; ++i) {
    if (std::string_view(argv[i]).starts_with(kOption))
      spool::test::kills = std::atoi(argv[i] + kOption.size());
  }
  return RUN_ALL_TESTS();
}
