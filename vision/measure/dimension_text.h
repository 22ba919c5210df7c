// What is said of a dimension: its kind, its number, what would settle a doubt.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "vision/inspect/dimension.h"
#include "vision/measure/drawing.h"

namespace spool {

// "centre_to_face": centre before face before end, as people say it.
[[nodiscard]] std::string kind_between(NodeKind a, NodeKind b);

// "12.3 mm" or "0.45°" of m or rad.
[[nodiscard]] std::string number_text(double value, bool is_angle);

// What would settle it: the largest part of the doubt, unless the number itself lies at the limit.
[[nodiscard]] std::string advice_on(const Dimension& dimension);

// What a part or a finding is told to be by a dimension: kind, name and reason.
[[nodiscard]] std::string told_by(const Dimension& dimension);

}  // namespace spool
