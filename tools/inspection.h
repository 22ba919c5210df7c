// One design, one scan, one folder with what was found.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tools/inspect_options.h"
#include "vision/core/result.h"

namespace spool::tools {

// Reads, inspects, writes options.out, prints a summary on stdout; gives the exit code by status
// (ARCHITECTURE, Command lines). Errors are those of the flags and files.
[[nodiscard]] Result<int> inspect(const InspectOptions& options);

}  // namespace spool::tools
