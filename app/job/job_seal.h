// seal.json: what the files of a job's own folder were when it was last closed.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/job/file_facts.h"
#include "vision/core/result.h"

namespace spool::job {

inline constexpr char kSealFile[] = "seal.json";

// Files of the job's own folder that a seal does not hold: the lock, the seal, and what SQLite
// keeps beside an open journal.
[[nodiscard]] bool is_unsealed(const std::string& file);

// True for what a program leaves in the job's folder that dies while it writes job.json or the
// seal.
[[nodiscard]] bool is_half_written(const std::string& file);
// Removes that. Only for who holds the job's lock.
void clear_half_written(const std::filesystem::path& folder);

// Writes seal.json over every other file that lies in the folder itself (evidence/ has entries of
// its own). It is dated with the time that it holds. kIo: nothing changed.
[[nodiscard]] Status write_seal(const std::filesystem::path& folder);

// What is not as it was sealed, the seal itself included; empty where all is. A missing seal is
// "removed".
[[nodiscard]] std::vector<Change> seal_changes(const std::filesystem::path& folder);

// True where the last program that worked on the job ended without closing it, or still works: its
// seal is then older than the journal.
[[nodiscard]] bool is_open_or_abandoned(const std::filesystem::path& folder);

// Seals a job when it goes, if it is to: not a job that was altered behind our back, whose old seal
// is what still tells.
class SealOnClose {
 public:
  explicit SealOnClose(std::filesystem::path folder) : folder_(std::move(folder)) {}
  SealOnClose(const SealOnClose&) = delete;
  SealOnClose& operator=(const SealOnClose&) = delete;
  ~SealOnClose() { (void)write_seal(folder_); }  // a seal that cannot be written is a stale one

 private:
  std::filesystem::path folder_;
};

}  // namespace spool::job
