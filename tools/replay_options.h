// The flags of an inspection as a report and an entry keep them, so that it can be made again.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "tools/inspect_options.h"
#include "vision/core/result.h"

namespace spool::tools {

// Flags whose value may be a file.
[[nodiscard]] const std::vector<std::string>& file_flags();  // pairs pose standard calibration

// All flags that the numbers depend on, but design and scan, which a report names anyhow; of files
// also NAME_sha256. kBadInput: a file that cannot be read.
[[nodiscard]] Result<std::map<std::string, std::string>> options_text(
    const InspectOptions& options);

// The other way round; designs and out are left to the caller. kBadInput: a key or a value that is
// none of ours. `where` stands for the file in the sentence.
[[nodiscard]] Result<InspectOptions> options_from(const std::map<std::string, std::string>& text,
                                                  const std::string& where);

}  // namespace spool::tools
