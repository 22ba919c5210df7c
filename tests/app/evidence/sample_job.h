// A job with captures of made-up files: enough for what is done to evidence.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/evidence/capture.h"
#include "app/evidence/verify.h"
#include "tests/support/temporary_folder.h"

namespace spool::test {

class SampleJob {
 public:
  SampleJob();

  // Of step 1, with three files and one in a folder of the entry, all different by `seed`.
  [[nodiscard]] evidence::CaptureRequest request(int seed) const;
  // Opens the job, captures, closes it.
  [[nodiscard]] Result<evidence::Captured> capture(int seed, const std::string& key = "") const;

  [[nodiscard]] std::filesystem::path path() const { return folder_.path() / "line.spooljob"; }
  [[nodiscard]] std::filesystem::path outside(const std::string& name) const {
    return folder_.path() / name;
  }
  // A fresh copy of the job, times kept, under another name; the one before is gone.
  [[nodiscard]] std::filesystem::path copy() const;

 private:
  TemporaryFolder folder_;
};

// Every plain file below a job, relative, but the lock and what SQLite keeps beside a journal.
[[nodiscard]] std::vector<std::string> job_files(const std::filesystem::path& job);

// What verify says of it: "changed journal.db", one a change.
[[nodiscard]] std::vector<std::string> told(const std::filesystem::path& job,
                                            const std::string& signer = "");

// Turns one bit, keeps the file's time.
void flip_bit(const std::filesystem::path& file, std::size_t bit);
// Moves a file's time (s).
void redate(const std::filesystem::path& file, double by_s);

}  // namespace spool::test
