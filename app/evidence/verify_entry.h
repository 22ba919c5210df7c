// One entry of a job's evidence against what the journal, the entry before and itself say of it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>

#include "app/evidence/entry.h"
#include "app/evidence/verify.h"

namespace spool::evidence {

// Where an entry lies, and what is expected of it.
struct EntryPlace {
  std::filesystem::path folder;  // evidence/000001, or where it waits for that name
  std::string prefix;            // "evidence/000001/", as it is named in answers
  std::int64_t number = 0;
  std::string previous_sha256;         // of the entry before, as the journal has it or as it is
  std::optional<job::CaptureRow> row;  // nothing where the journal cannot be read
};

struct EntryVerdict {
  std::optional<Entry> entry;   // nothing where it cannot be read
  std::string sha256;           // of the entry.json that is there; "" none
  std::set<std::string> files;  // names that belong there, relative to the job
};

// Adds to `verified` what is wrong. `recorded` collects SHA-256 and name of every recorded file, so
// that verify can tell what was swapped.
[[nodiscard]] EntryVerdict verify_entry(const EntryPlace& place, const VerifyOptions& options,
                                        std::map<std::string, std::string>& recorded,
                                        Verified& verified);

}  // namespace spool::evidence
