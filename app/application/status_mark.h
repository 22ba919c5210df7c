// The mark of a status as reports and the journal spell it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "app/ui/screen_state.h"

namespace spool {

// Anything that is no status of ours: not measured.
[[nodiscard]] inline ui::StatusMark mark_of_status(std::string_view status) {
  return status == "ok"           ? ui::StatusMark::kOk
         : status == "suspicious" ? ui::StatusMark::kSuspicious
         : status == "not_ok"     ? ui::StatusMark::kNotOk
                                  : ui::StatusMark::kNotMeasured;
}

}  // namespace spool
