// The four statuses, and which of two is worse.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace spool {

enum class Verdict { kOk, kSuspicious, kNotOk, kNotMeasured };
[[nodiscard]] std::string_view name(
    Verdict verdict);  // "ok", "suspicious", "not_ok", "not_measured"
// The worse of two in the order not_ok, suspicious, not_measured, ok (ARCHITECTURE, Command lines).
[[nodiscard]] Verdict worse(Verdict a, Verdict b);

}  // namespace spool
