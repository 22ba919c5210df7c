// The results of a check in words and numbers ready to be shown.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "app/common/length_text.h"
#include "app/evidence/result_rows.h"
#include "app/ui/results_state.h"
#include "vision/design/design_model.h"
#include "vision/inspect/inspection.h"

namespace spool {

[[nodiscard]] ui::StatusMark mark_of(Verdict verdict);

// Numbers with their unit and U (k = 2). `row` is of that inspection's rows. Signs are those of the
// report, with a true minus.
[[nodiscard]] ui::ResultLine result_line(const DesignModel& design, const Inspection& inspection,
                                         const evidence::ResultRow& row, LengthStyle style);
[[nodiscard]] ui::ResultDetail result_detail(const DesignModel& design,
                                             const Inspection& inspection,
                                             const evidence::ResultRow& row, LengthStyle style);

// A true minus is as wide as a plus: numbers do not jump when their sign changes.
[[nodiscard]] std::string with_minus(std::string text);

// How probable it is that something lies within its limit: "more than 19 in 20", "about 6 in 10".
[[nodiscard]] std::string chance_text(double probability);

// "just now", "12 s ago", "3 min ago", "2 h ago" of seconds, 0 or more.
[[nodiscard]] std::string age_text(double seconds);

// "centre_to_face", "E2/centre to F3/face" as they are said: "E2 centre to F3 face".
[[nodiscard]] std::string dimension_title(const std::string& kind, const std::string& name);

}  // namespace spool
