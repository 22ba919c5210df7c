// The checks of a job for other programs: CSV, and JSON lines.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "app/job/check_record.h"
#include "app/job/job_file.h"

namespace spool::job {

// One row a number, the check's own columns repeated; a check without numbers has one row. RFC
// 4180, a head line, lengths in metres and angles in radians as `unit` says. A text that a
// spreadsheet would take for a formula gets a ' before it. Pure.
[[nodiscard]] std::string csv_text(const JobFile& job, const std::vector<CheckRecord>& records);

// One JSON object a line: "event": "check" for each, with all that the journal has, then "event":
// "joint" for each joint with tries, seconds and shrinkage. What is not UTF-8 is replaced. Pure.
[[nodiscard]] std::string json_lines(const JobFile& job, const std::vector<CheckRecord>& records);

}  // namespace spool::job
