// The numbers of a check out of an inspection's report.json.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "app/job/check_record.h"
#include "vision/core/result.h"
#include "vision/design/design_model.h"

namespace spool::job {

// Status, dimensions that begin or end at `part`, its size checks and its pose as built
// (T_design_part from pose_error, where the report has it). `design_sha256` is the job's design:
// numbers of another are refused. kBadInput: no report, of another schema or design, without the
// part.
[[nodiscard]] Result<CheckRecord> check_from_report(const std::filesystem::path& report,
                                                    const Part& part,
                                                    const std::string& design_sha256);

}  // namespace spool::job
