// A form that is being filled in, kept in the job until its report is written.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

#include "vision/core/result.h"

namespace spool::ncr {

struct NcrDraft {
  std::int64_t capture = 0;                   // evidence/000001 that it is on
  std::string shop;                           // of the number that it will get
  std::map<std::string, std::string> fields;  // key of the form to what a person said
};

// JOB/ncr/draft-000001.json. It is no record of anything: verify names it in a note, whatever it
// holds.
[[nodiscard]] std::filesystem::path draft_path(const std::filesystem::path& job_folder,
                                               std::int64_t capture);

// Whole or not at all. kIo.
[[nodiscard]] Status write_draft(const std::filesystem::path& job_folder, const NcrDraft& draft);
// An empty draft where there is none, or none of ours: what it says is only a start.
[[nodiscard]] NcrDraft read_draft(const std::filesystem::path& job_folder, std::int64_t capture);
// Its report is written. What cannot be removed is only a start again.
void remove_draft(const std::filesystem::path& job_folder, std::int64_t capture);

}  // namespace spool::ncr
