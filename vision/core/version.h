// Which build this is: evidence must say what made it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace spool {

[[nodiscard]] std::string_view version();  // "0.1.0"
[[nodiscard]] std::string_view commit();   // twelve hexadecimal digits, or "unknown"

}  // namespace spool
