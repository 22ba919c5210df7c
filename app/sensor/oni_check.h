// Whether an .oni file can be played without harm: found out in a child process.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "vision/core/result.h"

namespace spool::sensor {

// Some damaged headers crash OpenNI2's reader. So the program spoolsight-oni-check beside this one
// first plays the recording to its end at full speed, with its memory and time limited. A recording
// that passed is remembered by its SHA-256, for this process and in the user's cache folder
// ($XDG_CACHE_HOME/spoolsight or ~/.cache/spoolsight) where that can be written. kBadInput for a
// file that is missing, empty, damaged or does not come to an end.
[[nodiscard]] Status check_oni(const std::string& path);

}  // namespace spool::sensor
