// What was understood of a Piping Component File, as text for people.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "vision/piping/pipework.h"

namespace spool::tools {

// Pipelines, spools, parts, welds, cut list (mm, with take-offs and this root gap in m), supports
// and the problems with their line numbers; `path` heads it. Names of parts are those of the
// design.
[[nodiscard]] std::string pcf_info(const std::string& path, const piping::Pipework& pipework,
                                   double root_gap);

}  // namespace spool::tools
