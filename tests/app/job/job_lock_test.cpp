// The lock of a job between processes: refused by name, given back, taken over from the dead.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/job/job_lock.h"

#include <string>

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include "tests/support/refusal.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/write_file.h"

namespace spool::test {
namespace {

using job::JobLock;

// A process that holds the lock until it is killed; returns once it has it.
pid_t holder_of(const std::filesystem::path& file) {
  int ends[2];
  EXPECT_EQ(::pipe(ends), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    const auto lock = JobLock::take(file);
    const char has = lock ? '1' : '0';
    (void)!::write(ends[1], &has, 1);
    for (;;) ::pause();
  }
  char has = '0';
  EXPECT_EQ(::read(ends[0], &has, 1), 1);
  EXPECT_EQ(has, '1');
  ::close(ends[0]);
  ::close(ends[1]);
  return child;
}

void end(pid_t child) {
  EXPECT_EQ(::kill(child, SIGKILL), 0);
  int status = 0;
  EXPECT_EQ(::waitpid(child, &status, 0), child);
}

TEST(JobLock, RefusesASecondAndNamesTheHolder) {
  const TemporaryFolder folder;
  const pid_t child = holder_of(folder.path() / "lock");
  for (int i = 0; i < 2; ++i) {
    const auto second = JobLock::take(folder.path() / "lock");
    expect_refused(second, ErrorCode::kIo, folder.path().string(),
                   "process " + std::to_string(child));
    if (!second) {
      EXPECT_NE(second.error().message.find("host "), std::string::npos);
      EXPECT_NE(second.error().message.find("since 20"), std::string::npos);
    }
  }
  end(child);
}

TEST(JobLock, OfADeadHolderIsTakenOver) {
  const TemporaryFolder folder;
  const pid_t child = holder_of(folder.path() / "lock");
  end(child);
  const auto lock = JobLock::take(folder.path() / "lock");
  ASSERT_TRUE(lock) << lock.error().message;
  EXPECT_NE(lock->taken_over_from().find("process " + std::to_string(child)), std::string::npos);
}

TEST(JobLock, IsGivenBackWithoutATrace) {
  const TemporaryFolder folder;
  { ASSERT_TRUE(JobLock::take(folder.path() / "lock")); }
  const auto lock = JobLock::take(folder.path() / "lock");
  ASSERT_TRUE(lock);
  EXPECT_EQ(lock->taken_over_from(), "");
}

TEST(JobLock, WhereNoFileCanBeIsAnError) {
  const TemporaryFolder folder;
  write_file(folder.path() / "file", "no folder");
  expect_refused(JobLock::take(folder.path() / "file" / "lock"), ErrorCode::kIo, "lock",
                 "cannot be locked");
}

}  // namespace
}  // namespace spool::test
