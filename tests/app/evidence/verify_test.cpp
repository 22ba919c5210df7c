// Whatever is done to a job's files is told, by name: hundreds of flipped bits, files and entries
// removed, swapped, added, re-dated.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/evidence/verify.h"

#include <algorithm>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/app/evidence/sample_job.h"
#include "tests/support/write_file.h"
#include "vision/core/file_io.h"

namespace spool::test {
namespace {

namespace fs = std::filesystem;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class Verify : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    sample_ = std::make_unique<SampleJob>();
    for (int seed = 1; seed <= 3; ++seed) {
      const auto captured = sample_->capture(seed);
      ASSERT_TRUE(captured) << captured.error().message;
      ASSERT_EQ(captured->number, seed);
    }
  }
  static void TearDownTestSuite() { sample_.reset(); }
  static std::unique_ptr<SampleJob> sample_;
};
std::unique_ptr<SampleJob> Verify::sample_;

TEST_F(Verify, AJobAsItWasLeftIsIntact) {
  EXPECT_THAT(told(sample_->path()), IsEmpty());
  EXPECT_THAT(told(sample_->copy()), IsEmpty());
  const auto verified = evidence::verify_job(sample_->path());
  ASSERT_TRUE(verified);
  EXPECT_EQ(verified->entries, 3);
  EXPECT_EQ(verified->files, 12);
  EXPECT_EQ(verified->signed_entries, 0);
}

TEST_F(Verify, OneFlippedBitAnywhereIsNamed) {
  const fs::path job = sample_->copy();
  std::mt19937 random(20261129);
  int flips = 0;
  for (const std::string& file : job_files(job)) {
    const auto bits = 8 * fs::file_size(job / file);
    std::uniform_int_distribution<std::size_t> any(0, bits - 1);
    for (int i = 0; i < 25; ++i, ++flips) {
      const std::size_t bit = any(random);
      flip_bit(job / file, bit);
      EXPECT_THAT(told(job), Contains("changed " + file)) << "bit " << bit;
      flip_bit(job / file, bit);
    }
  }
  EXPECT_GT(flips, 400);
  EXPECT_THAT(told(job), IsEmpty()) << "all bits are back";
}

TEST_F(Verify, EveryFileThatIsRemovedIsNamed) {
  for (const std::string& file : job_files(sample_->path())) {
    const fs::path job = sample_->copy();
    fs::remove(job / file);
    EXPECT_THAT(told(job), Contains("removed " + file));
  }
}

TEST_F(Verify, EveryEntryThatIsRemovedIsNamed) {
  for (const char* entry : {"evidence/000001", "evidence/000002", "evidence/000003"}) {
    const fs::path job = sample_->copy();
    fs::remove_all(job / entry);
    EXPECT_THAT(told(job), ElementsAre(std::string("removed ") + entry));
    // Without a journal the entries after it still tell that one is missing, if there are any.
    fs::remove(job / "journal.db");
    EXPECT_THAT(told(job), Contains("removed journal.db"));
    if (std::string(entry) != "evidence/000003") {
      EXPECT_THAT(told(job), Contains(std::string("removed ") + entry));
    }
  }
}

TEST_F(Verify, WhatWasSwappedIsNamedWithItsOldName) {
  const fs::path job = sample_->copy();
  const fs::path a = job / "evidence/000001/points.ply", b = job / "evidence/000002/points.ply";
  fs::rename(a, job / "c");
  fs::rename(b, a);
  fs::rename(job / "c", b);
  EXPECT_THAT(told(job), ElementsAre("changed evidence/000001/points.ply",
                                     "changed evidence/000002/points.ply"));
  EXPECT_THAT(evidence::verify_job(job)->changes[0].text,
              HasSubstr("recorded as evidence/000002/points.ply"));
  const fs::path other = sample_->copy();
  fs::rename(other / "evidence/000001", other / "c");
  fs::rename(other / "evidence/000003", other / "evidence/000001");
  fs::rename(other / "c", other / "evidence/000003");
  const auto lines = told(other);
  EXPECT_THAT(lines, Contains("changed evidence/000001/entry.json"));
  EXPECT_THAT(lines, Contains("changed evidence/000003/entry.json"));
}

TEST_F(Verify, EveryDateThatWasMovedIsNamed) {
  for (const std::string& file : job_files(sample_->path())) {
    for (const double by_s : {-86400.0, 3.0}) {
      const fs::path job = sample_->copy();
      redate(job / file, by_s);
      EXPECT_THAT(told(job), ElementsAre("re-dated " + file)) << by_s << " s";
    }
    const fs::path job = sample_->copy();
    redate(job / file, 1.5);  // as a file system that keeps every other second may
    EXPECT_THAT(told(job), IsEmpty()) << file;
  }
}

TEST_F(Verify, ADateThatWasEditedIsNamed) {
  const fs::path job = sample_->copy(), entry = job / "evidence/000002/entry.json";
  const auto time = fs::last_write_time(entry);
  std::string text = *read_file(entry);
  const auto at = text.find("\"time\": \"2");
  ASSERT_NE(at, std::string::npos);
  text.replace(at + 9, 4, "2019");
  write_file(entry, text);
  fs::last_write_time(entry, time);
  EXPECT_THAT(told(job), ElementsAre("changed evidence/000002/entry.json"));
}

TEST_F(Verify, WhatWasAddedIsNamed) {
  for (const char* file : {"evidence/000002/other.png", "evidence/000004/entry.json", "note.txt",
                           "evidence/000002/scan/more/000001.png", "journal.db-wal"}) {
    const fs::path job = sample_->copy();
    write_file(job / file, "more");
    EXPECT_THAT(told(job), Contains(std::string("added ") + file));
  }
  const fs::path job = sample_->copy();
  fs::copy(job / "evidence/000003", job / "evidence/000004", fs::copy_options::recursive);
  EXPECT_THAT(told(job), Contains("added evidence/000004/entry.json"));
  fs::create_directories(sample_->copy() / "evidence/000009");
  EXPECT_THAT(told(job), ElementsAre("added evidence/000009/"));
}

TEST_F(Verify, ALinkInPlaceOfAFileOrFolderIsNotFollowed) {
  const fs::path job = sample_->copy(), file = job / "evidence/000001/points.ply";
  fs::rename(file, sample_->outside("points.ply"));
  fs::create_symlink(sample_->outside("points.ply"), file);
  EXPECT_THAT(told(job), ElementsAre("changed evidence/000001/points.ply"));
  const fs::path other = sample_->copy();
  fs::remove_all(sample_->outside("scan"));
  fs::rename(other / "evidence/000001/scan", sample_->outside("scan"));
  fs::create_directory_symlink(sample_->outside("scan"), other / "evidence/000001/scan");
  EXPECT_THAT(told(other), Contains("removed evidence/000001/scan/000000.png"));
}

TEST_F(Verify, WithoutSealOrJobFileSaysSo) {
  const fs::path job = sample_->copy();
  fs::remove(job / "seal.json");
  EXPECT_THAT(told(job), ElementsAre("removed seal.json"));
  const fs::path none = sample_->outside("nothing.spooljob");
  EXPECT_THAT(told(none), Contains(HasSubstr("is no job's folder")));
}

TEST_F(Verify, WorkDoesNotSealOverAnAlteration) {
  const fs::path job = sample_->copy();
  std::string text = *read_file(job / "job.json");  // what no digest but the seal's holds
  const auto at = text.find("\"root_gap_m\": 0.0");
  ASSERT_NE(at, std::string::npos);
  write_file(job / "job.json", text.replace(at, 17, "\"root_gap_m\": 0.1"));
  {
    auto opened = job::Job::open(job, job::JobUse::kWork);
    ASSERT_TRUE(opened) << opened.error().message;
    ASSERT_EQ(opened->alterations().size(), 1u);
    job::CheckRecord redo;
    redo.outcome = job::Outcome::kRedo;
    ASSERT_TRUE(opened->add(0, redo));
  }
  EXPECT_THAT(told(job), Contains("changed job.json"));
}

TEST_F(Verify, ACheckThatWasRewrittenInTheJournalIsNamedAlsoWhereTheSealIsStale) {
  const fs::path job = sample_->copy();
  write_file(job / "lock", "host h, process 1, since then\n");  // as of a program that died
  const std::string bytes = *read_file(job / "journal.db");
  int checks = 0;
  for (auto at = bytes.find("not_okoperator 1"); at != std::string::npos;
       at = bytes.find("not_okoperator 1", at + 1), ++checks) {
    std::string changed = bytes;
    changed.replace(at, 6, "all_ok");
    write_file(job / "journal.db", changed);
    EXPECT_THAT(told(job), Contains("changed journal.db")) << "the check at byte " << at;
  }
  EXPECT_EQ(checks, 3);
}

}  // namespace
}  // namespace spool::test
