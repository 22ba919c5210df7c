// Numbers are given once and without gaps: by several processes, over kills, after failures.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/ncr/ncr_register.h"

#include <random>
#include <set>

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/refusal.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/write_file.h"
#include "vision/core/file_io.h"

namespace spool::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* kEndings[] = {".pdf", ".html", ".json", ".bcfzip"};

Result<std::vector<ncr::NcrFile>> four_files(const std::string& number) {
  std::vector<ncr::NcrFile> files;
  for (const char* ending : kEndings) files.push_back({number + ending, std::string(20000, 'x')});
  return files;
}

std::string numbered(int k) {
  const std::string digits = std::to_string(k);
  return "J-S-NCR-" + std::string(digits.size() < 3 ? 3 - digits.size() : 0, '0') + digits;
}

class NcrRegister : public ::testing::Test {
 protected:
  Result<ncr::Issued> issue(const fs::path& copy_to = {}) const {
    return ncr::issue_ncr(job_, "J-S", four_files, copy_to);
  }
  // How many reports there are; each is whole, and their numbers are 1 and on.
  int expect_whole() const {
    int count = 0;
    for (const auto& entry : fs::directory_iterator(job_ / "ncr"))
      if (entry.is_directory() && !entry.path().filename().string().starts_with(".")) ++count;
    for (int k = 1; k <= count; ++k) {
      const std::string number = numbered(k);
      for (const char* ending : kEndings) {
        const auto bytes = read_file(job_ / "ncr" / number / (number + ending));
        EXPECT_TRUE(bytes && bytes->size() == 20000U)
            << number << ending << ": a gap, or a report that is not whole";
      }
    }
    return count;
  }
  TemporaryFolder folder_;
  fs::path job_ = folder_.path() / "J.spooljob";
};

TEST_F(NcrRegister, CountsFromOneAndByShop) {
  fs::create_directory(job_);
  EXPECT_EQ(issue()->number, "J-S-NCR-001");
  EXPECT_EQ(issue()->number, "J-S-NCR-002");
  EXPECT_EQ(ncr::issue_ncr(job_, "J-T", four_files)->number, "J-T-NCR-001");
  EXPECT_EQ(issue()->number, "J-S-NCR-003");
  for (int k = 4; k <= 1000; ++k) fs::create_directory(job_ / "ncr" / numbered(k));
  EXPECT_EQ(issue()->number, "J-S-NCR-1001");
}

TEST_F(NcrRegister, ANumberIsNotGivenAgainWhenItsReportIsVoidOrGone) {
  ASSERT_TRUE(issue());
  ASSERT_TRUE(issue());
  ASSERT_TRUE(ncr::void_ncr(job_, "J-S-NCR-002", "wrong spool", "operator 1", "2026-11-29"));
  const auto json = nlohmann::json::parse(*read_file(job_ / "ncr/J-S-NCR-002/void.json"));
  EXPECT_EQ(json["reason"], "wrong spool");
  EXPECT_TRUE(fs::exists(job_ / "ncr/J-S-NCR-002/J-S-NCR-002.pdf"));
  EXPECT_EQ(issue()->number, "J-S-NCR-003");
  fs::remove_all(job_ / "ncr/J-S-NCR-003");
  EXPECT_EQ(issue()->number, "J-S-NCR-004");
}

TEST_F(NcrRegister, VoidsOnlyWhatIsThereOnceAndWithAReason) {
  ASSERT_TRUE(issue());
  const auto refused = [&](const char* number, const char* reason, const char* why) {
    const Status done = ncr::void_ncr(job_, number, reason, "", "");
    ASSERT_FALSE(done) << number;
    expect_sentence(done.error(), ErrorCode::kUsage, "", why);
  };
  refused("J-S-NCR-002", "r", "no report");
  refused("../ncr/J-S-NCR-001", "r", "no report");
  refused("J-S-NCR-001", "", "why");
  ASSERT_TRUE(ncr::void_ncr(job_, "J-S-NCR-001", "r", "", ""));
  refused("J-S-NCR-001", "r", "already");
}

TEST_F(NcrRegister, AFailureUsesNoNumber) {
  ASSERT_TRUE(issue());
  const auto failed = ncr::issue_ncr(job_, "J-S", [](const std::string&) {
    return Result<std::vector<ncr::NcrFile>>(Error{ErrorCode::kInternal, "no ink"});
  });
  EXPECT_FALSE(failed);
  // A file where the copies' folder is to be.
  write_file(folder_.path() / "file", "");
  expect_refused(issue(folder_.path() / "file"), ErrorCode::kIo, "file", "");
  EXPECT_EQ(expect_whole(), 1);
  EXPECT_EQ(issue()->number, "J-S-NCR-002");
}

TEST_F(NcrRegister, WhereNothingCanBeWrittenItSaysSo) {
  fs::create_directory(job_);
  write_file(job_ / "ncr", "a file where the folder is to be");
  expect_refused(issue(), ErrorCode::kIo, "ncr", "");
}

TEST_F(NcrRegister, CopiesAreWhole) {
  const fs::path out = folder_.path() / "out";
  const auto issued = issue(out);
  ASSERT_TRUE(issued) << issued.error().message;
  for (const char* ending : kEndings)
    EXPECT_TRUE(fs::exists(out / issued->number / (issued->number + ending)));
  EXPECT_EQ(expect_whole(), 1);
}

TEST_F(NcrRegister, PrefixesAreLettersOfFileNames) {
  EXPECT_EQ(*ncr::number_prefix("a/3032.spooljob", "F01"), "3032-F01");
  EXPECT_EQ(*ncr::number_prefix("a/3032.spooljob/", "F01"), "3032-F01");
  EXPECT_EQ(*ncr::number_prefix("A b/é 1.spooljob", "F_1"), "___1-F_1");
  for (const std::string& shop :
       {std::string(), std::string("a/b"), std::string("é"), std::string(41, 'a')})
    expect_refused(ncr::number_prefix("J", shop), ErrorCode::kUsage, "--shop", "letters");
  expect_refused(ncr::number_prefix(std::string(250, 'j'), "S"), ErrorCode::kUsage, "", "too long");
}

TEST_F(NcrRegister, TwoProcessesShareTheNumbers) {
  fs::create_directory(job_);
  constexpr int kEach = 25;
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  pid_t children[2];
  for (pid_t& child : children) {
    child = ::fork();
    ASSERT_GE(child, 0);
    if (child != 0) continue;
    for (int k = 0; k < kEach; ++k) {
      const auto issued = issue();
      const int number = issued ? std::atoi(issued->number.substr(8).c_str()) : -1;
      if (::write(ends[1], &number, sizeof number) != sizeof number) ::_exit(1);
    }
    ::_exit(0);
  }
  ::close(ends[1]);
  std::multiset<int> given;
  for (int number = 0; ::read(ends[0], &number, sizeof number) == sizeof number;)
    given.insert(number);
  ::close(ends[0]);
  for (const pid_t child : children) {
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
  }
  ASSERT_EQ(given.size(), 2U * kEach);
  int expected = 0;
  for (const int each : given) EXPECT_EQ(each, ++expected);
  EXPECT_EQ(expect_whole(), 2 * kEach);
}

TEST_F(NcrRegister, AKillAtAnyMomentLeavesNoGapAndNoHalfReport) {
  fs::create_directory(job_);
  std::mt19937 random(20261129);
  std::uniform_int_distribution<useconds_t> moment(1'000, 250'000);  // us
  int told = 0;
  constexpr int kKills = 25;
  for (int kill = 0; kill < kKills; ++kill) {
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      for (;;) {
        const auto issued = issue();
        const int number = issued ? std::atoi(issued->number.substr(8).c_str()) : -1;
        if (::write(ends[1], &number, sizeof number) != sizeof number) ::_exit(1);
      }
    }
    ::close(ends[1]);
    ::usleep(moment(random));
    ASSERT_EQ(::kill(child, SIGKILL), 0);
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    for (int number = 0; ::read(ends[0], &number, sizeof number) == sizeof number;) {
      ASSERT_GT(number, told) << "given twice";
      told = number;
    }
    ::close(ends[0]);
    const int count = expect_whole();
    ASSERT_GE(count, told);
    ASSERT_LE(count, told + 1) << "one may have been done when its word was cut off";
    told = count;
  }
  EXPECT_GT(told, 0);
  EXPECT_TRUE(issue());
  for (const auto& entry : fs::directory_iterator(job_ / "ncr"))
    EXPECT_FALSE(entry.path().filename().string().starts_with(".part-")) << "left behind";
}

}  // namespace
}  // namespace spool::test
