// The journal: what goes in comes out, nothing changes, and what the disk does to it is told.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/job/journal.h"

#include <csignal>
#include <fstream>

#include <sys/resource.h>

#include <gtest/gtest.h>
#include <sqlite3.h>

#include "tests/app/job/sample_check.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/write_file.h"
#include "vision/core/file_io.h"

namespace spool::test {
namespace {

using job::Journal;
using job::OpenFor;

class JournalFile : public ::testing::Test {
 protected:
  // A journal of `count` sample checks, closed again.
  void fill(int count) const {
    auto journal = Journal::create(path_);
    ASSERT_TRUE(journal) << journal.error().message;
    for (int i = 1; i <= count; ++i) ASSERT_TRUE(journal->append(sample_check(i)));
  }
  // As another program would, past our code; the message of its failure.
  std::string sql(const std::string& text) const {
    sqlite3* handle = nullptr;
    EXPECT_EQ(sqlite3_open(path_.c_str(), &handle), SQLITE_OK);
    char* message = nullptr;
    sqlite3_exec(handle, text.c_str(), nullptr, nullptr, &message);
    const std::string said = message == nullptr ? "" : message;
    sqlite3_free(message);
    sqlite3_close(handle);
    return said;
  }
  TemporaryFolder folder_;
  std::filesystem::path path_ = folder_.path() / "journal.db";
  std::filesystem::path fresh_ = folder_.path() / "salvaged.db";
};

TEST_F(JournalFile, GivesBackWhatWasWritten) {
  fill(3);
  auto journal = Journal::open(path_, OpenFor::kReading);
  ASSERT_TRUE(journal) << journal.error().message;
  const auto records = journal->records();
  ASSERT_TRUE(records) << records.error().message;
  ASSERT_EQ(records->size(), 3u);
  for (int i = 1; i <= 3; ++i) {
    job::CheckRecord expected = sample_check(i);
    expected.id = i;
    EXPECT_EQ(text_of((*records)[std::size_t(i - 1)]), text_of(expected));
  }
}

TEST_F(JournalFile, SyncsEveryCommitToALog) {
  auto journal = Journal::create(path_);
  ASSERT_TRUE(journal->append(sample_check()));
  EXPECT_TRUE(std::filesystem::exists(path_.string() + "-wal"));
  EXPECT_EQ(sql("UPDATE checks SET remark = ''"), "a check is never changed");
  EXPECT_EQ(sql("DELETE FROM checks"), "a check is never deleted");
  EXPECT_EQ(sql("UPDATE numbers SET u = 0"), "a check is never changed");
  EXPECT_EQ(sql("DELETE FROM numbers"), "a check is never deleted");
}

TEST_F(JournalFile, ACheckIsThereWithAllItsNumbersOrNot) {
  fill(1);
  auto journal = Journal::open(path_, OpenFor::kWriting);
  ASSERT_TRUE(journal);
  job::CheckRecord odd = sample_check(2);
  odd.numbers.push_back({"speed", "other", "m/s"});  // a unit that the table refuses
  EXPECT_FALSE(journal->append(odd));
  EXPECT_EQ(journal->records()->size(), 1u);
  EXPECT_TRUE(journal->append(sample_check(2)));
  EXPECT_EQ(journal->records()->size(), 2u);
}

TEST_F(JournalFile, OpenForReadingTakesNothing) {
  fill(1);
  auto journal = Journal::open(path_, OpenFor::kReading);
  ASSERT_TRUE(journal);
  expect_refused(journal->append(sample_check()), ErrorCode::kBadInput, "journal.db",
                 "for reading");
}

TEST_F(JournalFile, OfALaterVersionIsRefusedByIt) {
  fill(1);
  sql("PRAGMA user_version = 3");
  expect_refused(Journal::open(path_, OpenFor::kWriting), ErrorCode::kBadInput, "journal.db",
                 "version 3");
  sql("PRAGMA application_id = 7");
  expect_refused(Journal::open(path_, OpenFor::kReading), ErrorCode::kBadInput, "journal.db",
                 "no SpoolSight journal");
}

TEST_F(JournalFile, ThatIsMissingOrThereAlreadyIsTold) {
  expect_refused(Journal::open(path_, OpenFor::kWriting), ErrorCode::kBadInput, "journal.db",
                 "is not there");
  fill(1);
  expect_refused(Journal::create(path_), ErrorCode::kIo, "journal.db", "is there already");
}

TEST_F(JournalFile, InAFolderThatIsNoneIsAnError) {
  write_file(folder_.path() / "file", "no folder");
  const auto journal = Journal::create(folder_.path() / "file" / "journal.db");
  expect_refused(journal, ErrorCode::kIo, "journal.db", "cannot be opened");
}

TEST_F(JournalFile, OnAFullDiskKeepsWhatItHasAndSaysSo) {
  fill(2);
  auto journal = Journal::open(path_, OpenFor::kWriting);
  ASSERT_TRUE(journal);
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  rlimit full = before;
  full.rlim_cur = 100 * 1024;  // the log may grow to this
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &full), 0);
  std::size_t written = 2;
  std::optional<Error> error;
  for (int i = 3; i < 1000 && !error; ++i) {
    const auto id = journal->append(sample_check(i));
    if (id)
      ++written;
    else
      error = id.error();
  }
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
  ASSERT_TRUE(error) << "a thousand checks fit into 100 KiB";
  expect_sentence(*error, ErrorCode::kIo, "journal.db", "space");
  // With space again it goes on, and nothing that had an id is lost.
  EXPECT_TRUE(journal->append(sample_check(5000)));
  EXPECT_EQ(journal->records()->size(), written + 1);
}

// Pages in the middle overwritten: what lies before and after is copied, the rest is told as gone.
TEST_F(JournalFile, DamagedOpensForReadingAndIsSalvaged) {
  fill(400);
  auto bytes = read_file(path_);
  ASSERT_TRUE(bytes);
  const std::string good = *bytes;
  for (std::size_t i = good.size() / 2; i < good.size() / 2 + 8192; ++i) (*bytes)[i] = '\x5a';
  write_file(path_, *bytes);
  auto journal = Journal::open(path_, OpenFor::kWriting);
  ASSERT_TRUE(journal) << journal.error().message;
  EXPECT_NE(journal->damage().find("is damaged"), std::string::npos) << journal->damage();
  expect_refused(journal->append(sample_check()), ErrorCode::kBadInput, "journal.db", "damaged");
  expect_refused(journal->records(), ErrorCode::kBadInput, "journal.db", "damaged");
  const auto salvaged = Journal::salvage(path_, fresh_);
  ASSERT_TRUE(salvaged) << salvaged.error().message;
  EXPECT_GT(salvaged->checks, 340);  // two pages of some ten checks each, and what they hide
  EXPECT_EQ(salvaged->last_id, 400);
  EXPECT_EQ(*read_file(path_), *bytes) << "the damaged file was changed";
  auto again = Journal::open(fresh_, OpenFor::kWriting);
  ASSERT_TRUE(again) << again.error().message;
  EXPECT_EQ(again->damage(), "");
  const auto records = again->records();
  ASSERT_TRUE(records);
  EXPECT_EQ(std::int64_t(records->size()), salvaged->checks);
  for (const job::CheckRecord& record : *records) {
    EXPECT_EQ(record.part, sample_check(int(record.id)).part);
    EXPECT_EQ(record.remark, sample_check().remark);
  }
  const auto next = again->append(sample_check(401));
  ASSERT_TRUE(next);
  EXPECT_EQ(*next, 401);
}

TEST_F(JournalFile, WhoseHeadIsGoneIsToldAndCannotBeSalvaged) {
  fill(3);
  auto bytes = read_file(path_);
  ASSERT_TRUE(bytes);
  for (std::size_t i = 0; i < 100; ++i) (*bytes)[i] = '\0';
  write_file(path_, *bytes);
  auto journal = Journal::open(path_, OpenFor::kReading);
  ASSERT_TRUE(journal) << journal.error().message;
  EXPECT_NE(journal->damage(), "");
  expect_refused(Journal::salvage(path_, fresh_), ErrorCode::kBadInput, "journal.db", "is damaged");
}

}  // namespace
}  // namespace spool::test
