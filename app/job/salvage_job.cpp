// Puts what can be read of a damaged journal in its place, and keeps the damaged one.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/job/salvage_job.h"

#include <string>

#include "app/job/job.h"
#include "app/job/job_seal.h"
#include "vision/core/file_io.h"

namespace spool::job {
namespace {

Status copy_whole(const std::filesystem::path& from, const std::filesystem::path& to) {
  const auto bytes = read_file(from);
  if (!bytes) return bytes.error();
  return write_file_whole(to, *bytes);
}

}  // namespace

Result<SalvagedJob> salvage_job(const std::filesystem::path& folder) {
  const auto lock = JobLock::take(folder / "lock");
  if (!lock) return lock.error();
  const std::filesystem::path path = journal_path(folder);
  const std::filesystem::path log = path.string() + "-wal";
  {
    const auto journal = Journal::open(path, OpenFor::kReading);
    if (!journal) return journal.error();
    if (journal->damage().empty())
      return Error{ErrorCode::kUsage, path.string() + ": is sound, there is nothing to salvage"};
  }
  SalvagedJob salvaged;
  std::error_code code;
  for (int n = 1; salvaged.kept.empty() || std::filesystem::exists(salvaged.kept, code); ++n)
    salvaged.kept = folder / ("journal.damaged-" + std::to_string(n) + ".db");
  const bool has_log = std::filesystem::exists(log, code);
  if (has_log) {
    if (Status done = copy_whole(log, salvaged.kept.string() + "-wal"); !done) return done.error();
  }
  if (Status done = copy_whole(path, salvaged.kept); !done) return done.error();
  const std::filesystem::path fresh = folder / "journal.salvaged.db";
  for (const char* end : {"", "-wal", "-shm"})
    std::filesystem::remove(fresh.string() + end, code);  // of a salvage that died
  const auto found = Journal::salvage(path, fresh);
  if (!found) return found.error();
  salvaged.found = *found;
  // The old log would be taken for the new file's.
  for (const char* end : {"-wal", "-shm"}) std::filesystem::remove(path.string() + end, code);
  std::filesystem::rename(fresh, path, code);
  if (code)
    return Error{ErrorCode::kIo, path.string() + ": cannot be replaced (" + code.message() +
                                     "); what was salvaged is in " + fresh.string()};
  // A person asked for it: what it is now is what later changes are told from.
  if (Status done = write_seal(folder); !done) return done.error();
  return salvaged;
}

}  // namespace spool::job
