// The command `spoolsight-job ncr`: a non-conformance report on the job's spool, or a void one.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include <CLI/CLI.hpp>

#include "vision/core/result.h"

namespace spool::tools {

// Adds the command to `app`; what it gives is to be called where the command was parsed.
[[nodiscard]] std::function<Result<int>()> add_ncr_command(CLI::App& app);

}  // namespace spool::tools
