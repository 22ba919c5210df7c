// The commands of spoolsight-job.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "app/job/job.h"
#include "vision/core/result.h"

namespace spool::tools {

// All flags of all commands, as they stand on the command line.
struct JobOptions {
  std::string job, design, spool, out, gap_rule = "none";
  double root_gap_mm = 0;
  std::vector<int> move;
  int step = 0;
  std::string report, outcome, phase = "after-tack", remark, operator_name, override_reason,
                               picture;
  std::string scan, key;
  bool csv = false, jsonl = false;
};

// Each does what its name says and prints it on stdout; 0, or the Error to end with.
[[nodiscard]] Result<int> make(const JobOptions& options);
[[nodiscard]] Result<int> show(const JobOptions& options);
[[nodiscard]] Result<int> order(const JobOptions& options);
[[nodiscard]] Result<int> check(const JobOptions& options);
[[nodiscard]] Result<int> write_out(const JobOptions& options);
[[nodiscard]] Result<int> salvage(const JobOptions& options);
[[nodiscard]] Result<int> charts(const JobOptions& options);
// In job_capture.cpp.
[[nodiscard]] Result<int> capture(const JobOptions& options);
[[nodiscard]] Result<int> keygen(const JobOptions& options);

// The job, open for work; what its user has to know of it goes to stderr.
[[nodiscard]] Result<job::Job> work_on(const JobOptions& options);
// The check of options.step as the report has it, with what the flags make of it. kUsage: no such
// step.
[[nodiscard]] Result<job::CheckRecord> check_of(const JobOptions& options, const job::Job& job,
                                                const std::string& report);

}  // namespace spool::tools
