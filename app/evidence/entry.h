// entry.json: what one capture holds, made from, and follows.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/job/check_record.h"
#include "app/job/file_facts.h"
#include "vision/core/result.h"

namespace spool::evidence {

inline constexpr char kEntryFile[] = "entry.json";
inline constexpr char kSignatureFile[] = "entry.sig";

struct Entry {
  std::int64_t number = 0;      // from 1, the folder evidence/000001
  std::string previous_sha256;  // of the entry.json before; "" of the first
  std::string state;            // the one state that all of it is of
  double time_s = 0;            // since 1970, UTC, whole seconds
  std::string spool;
  job::CheckRecord check;     // step, part, joint, phase, outcome, operator ...; id as it will get
  std::string checks_sha256;  // over all checks of the journal, its own the last
  std::string design, design_sha256;           // file of the job
  std::map<std::string, std::string> options;  // that replay takes; files relative to the entry
  nlohmann::json context;                      // pose, datum, rules, sensor, software: the report's
  std::vector<job::FileFacts> files;           // all but entry.json and entry.sig
};

// "000001"; nothing else is an entry's folder.
[[nodiscard]] std::string entry_name(std::int64_t number);

[[nodiscard]] std::string entry_text(const Entry& entry);
// kBadInput: no entry, of a later schema, or with names that lead out of its folder. `name` stands
// for the file in sentences. Of the check only id, step, part and operator are read.
[[nodiscard]] Result<Entry> parse_entry(const std::string& text, const std::string& name);
// The same from folder/entry.json, at most 4 MiB.
[[nodiscard]] Result<Entry> read_entry(const std::filesystem::path& folder);

}  // namespace spool::evidence
