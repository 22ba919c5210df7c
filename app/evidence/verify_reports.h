// What of a job's non-conformance reports is not as it was written: ncr/NUMBER/ against files.json.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>

#include "app/evidence/verify.h"

namespace spool::evidence {

// The list of a report's files, in its folder: {"schema", "files": [{"name", "bytes", "sha256"}]}.
inline constexpr const char* kReportFiles = "files.json";
inline constexpr const char* kReportFilesSchema = "spoolsight-ncr-files/1";

// Adds to `verified` what was changed or removed of the reports that JOB/ncr/register.json knows.
// The register holds the SHA-256 of each list and the number that was given last; whoever writes
// both anew is not noticed. Gives the names, relative to the job, that belong there. `recorded` as
// in verify_entry(). Any thread.
[[nodiscard]] std::set<std::string> verify_reports(const std::filesystem::path& job_folder,
                                                   std::map<std::string, std::string>& recorded,
                                                   Verified& verified);

}  // namespace spool::evidence
