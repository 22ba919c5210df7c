// The application on a job whose checks become captures, and a disk that is full at will.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <csignal>
#include <filesystem>
#include <string>

#include <sys/resource.h>

#include <gtest/gtest.h>

#include "app/evidence/verify.h"
#include "tests/app/application/job_bench.h"

namespace spool::test {

// While it lives no file may grow beyond so many bytes: as on a disk that is full.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) {
    std::signal(SIGXFSZ, SIG_IGN);
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit now{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &now);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;
  ~FullDisk() { ::setrlimit(RLIMIT_FSIZE, &before_); }

 private:
  rlimit before_{};
};

class EvidenceOnScreen : public JobOnScreen {
 protected:
  void check() {
    press("Check");
    for (int i = 0; i < 6; ++i) step();
  }
  [[nodiscard]] std::filesystem::path entry(const char* name) const {
    return path_ / "evidence" / name;
  }
  // Everything of the job as it was recorded; said after the application has closed it.
  void expect_intact() {
    app_.reset();
    const auto verified = evidence::verify_job(path_, {});
    ASSERT_TRUE(verified) << verified.error().message;
    for (const auto& change : verified->changes)
      ADD_FAILURE() << change.file << ": " << change.text;
  }
  void type(const std::string& keys) {
    for (const char key : keys) press(std::string("Key ") + key);
  }
  void expect_thumbs() const {
    for (const auto& [name, rect] : screen_["targets"].items()) {
      EXPECT_GE(rect[2].get<double>(), ui::kTargetDp - 0.5) << name << " of " << screen_["screen"];
      EXPECT_GE(rect[3].get<double>(), ui::kTargetDp - 0.5) << name << " of " << screen_["screen"];
      EXPECT_GE(rect[0].get<double>(), 0) << name;
      EXPECT_LE(rect[0].get<double>() + rect[2].get<double>(), screen_["width"].get<double>() + 0.5)
          << name;
      EXPECT_LE(rect[1].get<double>() + rect[3].get<double>(),
                screen_["height"].get<double>() + 0.5)
          << name;
    }
  }
};

}  // namespace spool::test
