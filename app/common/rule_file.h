// A shop's own tolerances from a JSON file.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "vision/core/result.h"
#include "vision/measure/rules.h"

namespace spool {

// {"name": "…",
//  "length_by_nps":    {"clause": "…", "steps": [{"up_to_nps": 10, "tolerance_mm": 3}, …]},
//  "length_by_length": {"clause": "…", "steps": [{"up_to_mm": 1000, "tolerance_mm": 2}, …]},
//  "alignment":        {"clause": "…", "slope": 0.0039,
//                       "steps": [{"up_to_mm": 400, "tolerance_mm": 0.8}, …]},
//  "angle":            {"clause": "…", "steps": [{"up_to_mm": 400, "tolerance_deg": 0.5}, …]},
//  "rotation":         {"clause": "…", "reading": "stricter|arc|level",
//                       "steps": [{"up_to_mm": 400, "tolerance_mm": 1.5}, …]},
//  "fitting_allowance_mm": 2}
// All but the name may be missing; a table's last step may leave up_to out: for all beyond.
// kBadInput names the file and what is wrong: a tolerance that is not over zero, steps that do not
// ascend, a key that is not known (a rule that is spelled wrong would else not be judged by).
[[nodiscard]] Result<RuleSet> read_rules(const std::filesystem::path& path);

// A standard that is known by name, else a file: what --standard takes.
[[nodiscard]] Result<RuleSet> rules_of(const std::string& name_or_file);

}  // namespace spool
