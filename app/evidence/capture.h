// A capture: everything that one check rests on, put into the job's evidence whole or not at all.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/evidence/entry.h"
#include "app/evidence/signing.h"
#include "app/job/job.h"

namespace spool::evidence {

struct StoredFile {
  std::filesystem::path from;
  std::string to;      // below the entry's folder, "report.json"
  std::string sha256;  // what it has to be; "" whatever it is
};

struct CaptureRequest {
  int step = 0;            // from 0
  job::CheckRecord check;  // as job::check_from_report() gives it, with outcome and operator
  std::string state;       // the one state that report, pictures and frames are of
  std::vector<StoredFile> files;
  // Writes what is no file yet (the frames) into the folder it is given; `bytes` about as many.
  std::function<Status(const std::filesystem::path&)> write_more;
  std::uint64_t more_bytes = 0;
  std::map<std::string, std::string> options;  // for replay; files relative to the entry
  nlohmann::json context;                      // pose, datum, rules, sensor, software
  std::string picture;                         // one of `files`, for the journal; "" none
  std::optional<SigningKey> key;
};

struct Captured {
  std::int64_t number = 0, check_id = 0;
  std::string entry_sha256;
  std::filesystem::path folder;
};

// Longest name of an operator, in bytes of UTF-8.
inline constexpr std::size_t kMaxNameBytes = 400;

// Prepared under a hidden name, every file and folder synced; then the check and the entry's
// SHA-256 go into the journal in one transaction, which is the moment from which the capture is
// there; then the folder gets its name (a death between the two is made good by the next capture,
// and verify knows it). The job has to be open for work: its lock is what numbers rest on. Whatever
// fails leaves nothing behind. kUsage: no operator, or what Job::add() would not take; kBadInput: a
// file that is not what `sha256` says; kIo: no space (asked before anything is written), no
// permission. The caller keeps the frames until this has returned.
[[nodiscard]] Result<Captured> capture(job::Job& job, const CaptureRequest& request);

// Finishes captures that the journal has and that did not get their name, and clears away what was
// only begun. Called by capture().
[[nodiscard]] Status settle_captures(job::Job& job);

// "evidence/.capture-000001": where entry `number` is prepared.
[[nodiscard]] std::string staging_name(std::int64_t number);

}  // namespace spool::evidence
