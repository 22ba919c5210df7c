// job.json: which design, in which order, with which gaps.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "vision/core/result.h"
#include "vision/guide/cut_length.h"

namespace spool::job {

inline constexpr int kJobVersion = 1;  // "schema": "spoolsight-job/1"

struct JobFile {
  std::string spool;                  // as the design names it; "" it has no spools
  std::string design, design_sha256;  // file in the job's folder, that is worked with
  std::string source, source_sha256;  // the copy of the file it was made from; "" the same file
  std::string source_path;            // where that was
  std::string created;                // UTC
  std::vector<std::string> order;     // parts by name, first step first
  guide::GapPolicy gaps;
};

// kBadInput: missing, no such file, of a later schema version (named), a key that is wrong.
[[nodiscard]] Result<JobFile> read_job_file(const std::filesystem::path& path);
// Whole or not at all (write_file_whole()).
[[nodiscard]] Status write_job_file(const std::filesystem::path& path, const JobFile& file);

}  // namespace spool::job
