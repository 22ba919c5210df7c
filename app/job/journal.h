// The journal of a job: every check that was made, appended and never changed.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/job/check_record.h"
#include "app/job/sqlite.h"
#include "vision/core/result.h"

namespace spool::job {

inline constexpr int kJournalVersion = 2;  // PRAGMA user_version; the schema is in journal_schema.h

// SQLite with a write-ahead log and synchronous=FULL: what append() gave an id is on the disk, and
// a process or a machine that dies at any moment loses nothing but what had none yet. One thread at
// a time; readers may be other processes.
class Journal {
 public:
  // An empty one. kIo where there is a file already or the folder takes none.
  [[nodiscard]] static Result<Journal> create(const std::filesystem::path& path);

  // kReading: no writing, whatever the file allows. A damaged file opens for reading in either
  // case and says so (damage()). kBadInput: missing, of another program, or of a later version.
  [[nodiscard]] static Result<Journal> open(const std::filesystem::path& path, OpenFor use);

  // "" for a sound file, else what is wrong with it.
  [[nodiscard]] const std::string& damage() const { return damage_; }

  // Writes a check as one transaction and gives its id. kIo: the disk; nothing of it is in the
  // journal then. kBadInput: the journal is damaged or open for reading.
  [[nodiscard]] Result<std::int64_t> append(const CheckRecord& record);

  // The same, with its capture in the same transaction: both are in the journal, or neither.
  // kUsage: the id that `capture` names is not the one the check gets, or its number is not the
  // next (the first id and number after those there are).
  [[nodiscard]] Result<std::int64_t> append(const CheckRecord& record, const CaptureRow& capture);

  // The id that the next check gets. Ids of checks that were salvaged away are not given again.
  [[nodiscard]] Result<std::int64_t> next_id();

  // Of the file: 1 had no captures.
  [[nodiscard]] std::int64_t version() const { return version_; }

  // All captures by number; none in a journal of version 1.
  [[nodiscard]] Result<std::vector<CaptureRow>> captures();

  // All checks in the order of writing. Of a damaged file kBadInput; salvage() gives what there is.
  [[nodiscard]] Result<std::vector<CheckRecord>> records();

  struct Salvaged {
    std::int64_t checks = 0, numbers = 0, captures = 0;  // copied
    std::int64_t last_id = 0;                            // the highest id that was found
  };
  // Copies every check of `damaged` that can be read, ids kept, into the new journal `fresh`.
  // `damaged` is only read. kBadInput where not even its tables can be found.
  [[nodiscard]] static Result<Salvaged> salvage(const std::filesystem::path& damaged,
                                                const std::filesystem::path& fresh);

 private:
  Journal(Database database, std::filesystem::path path)
      : database_(std::move(database)), path_(std::move(path)) {}
  [[nodiscard]] Status write(const CheckRecord& record);
  [[nodiscard]] Status write(const CaptureRow& capture);   // that has to follow
  [[nodiscard]] Status insert(const CaptureRow& capture);  // wherever it belongs
  [[nodiscard]] Result<std::int64_t> append(const CheckRecord& record, const CaptureRow* capture);

  Database database_;
  std::filesystem::path path_;
  std::string damage_;
  std::int64_t version_ = kJournalVersion;
  bool is_writable_ = false;
};

}  // namespace spool::job
