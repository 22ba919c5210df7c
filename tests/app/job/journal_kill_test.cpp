// A process that appends is killed at random moments: every check that had its id is there.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <cstdlib>
#include <random>
#include <string>
#include <string_view>
#include <utility>

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include "app/job/journal.h"
#include "tests/app/job/sample_check.h"
#include "tests/support/temporary_folder.h"

namespace spool::test {
namespace {

int kills = 30;  // --kills=N

using job::Journal;
using job::OpenFor;

// In the child: appends without end, and says each id once it has it.
[[noreturn]] void append_for_ever(const std::filesystem::path& path, int out) {
  auto journal = Journal::open(path, OpenFor::kWriting);
  if (!journal || !journal->damage().empty()) ::_exit(1);
  for (int seed = 1;; ++seed) {
    const auto id = journal->append(sample_check(seed));
    if (!id || ::write(out, &*id, sizeof *id) != sizeof *id) ::_exit(1);
  }
}

TEST(JournalKill, NothingThatHadItsIdIsLost) {
  const TemporaryFolder folder;
  std::filesystem::path path;
  std::mt19937 random(20261129);
  std::uniform_int_distribution<useconds_t> moment(1'000, 120'000);  // us
  constexpr int kKillsOfOne = 10;  // all of a journal is compared after every kill
  std::int64_t told = 0, written = 0;
  for (int kill = 0; kill < kills; ++kill) {
    if (kill % kKillsOfOne == 0) {
      path = folder.path() / ("journal_" + std::to_string(kill) + ".db");
      ASSERT_TRUE(Journal::create(path));
      written += std::exchange(told, 0);
    }
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) append_for_ever(path, ends[1]);
    ::close(ends[1]);
    ::usleep(moment(random));
    ASSERT_EQ(::kill(child, SIGKILL), 0);
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status)) << "the child ended by itself in round " << kill;
    for (std::int64_t id = 0; ::read(ends[0], &id, sizeof id) == sizeof id;) {
      EXPECT_GT(id, told);
      told = id;
    }
    ::close(ends[0]);
    auto journal = Journal::open(path, kill % 2 == 0 ? OpenFor::kReading : OpenFor::kWriting);
    ASSERT_TRUE(journal) << journal.error().message;
    ASSERT_EQ(journal->damage(), "");
    const auto records = journal->records();
    ASSERT_TRUE(records) << records.error().message;
    // One more than was told may have been committed when the kill came between commit and word.
    const auto count = static_cast<std::int64_t>(records->size());
    ASSERT_GE(count, told) << "round " << kill;
    ASSERT_LE(count, told + 1) << "round " << kill;
    for (std::int64_t i = 0; i < count; ++i) {
      const job::CheckRecord& record = (*records)[static_cast<std::size_t>(i)];
      ASSERT_EQ(record.id, i + 1);
      job::CheckRecord expected = sample_check(record.step);
      expected.id = record.id;
      ASSERT_EQ(text_of(record), text_of(expected));
    }
    told = count;
  }
  written += told;
  EXPECT_GT(written, kills) << "hardly anything was written before the kills";
  RecordProperty("checks", static_cast<int>(written));
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
