// What GL says went wrong, as a Status.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "vision/core/result.h"

namespace spool::render {

// Takes every pending GL error; kInternal with the first one's name and `doing` ("drawing the
// overlay"). GL thread only.
[[nodiscard]] Status gl_status(std::string_view doing);

}  // namespace spool::render
