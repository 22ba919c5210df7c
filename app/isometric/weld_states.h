// How far each weld of a job is, read off its journal.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "app/job/check_record.h"

namespace spool::isometric {

enum class WeldStage { kToDo, kTacked, kChecked, kWelded, kAccepted };
[[nodiscard]] std::string_view name(WeldStage stage);  // to do, tacked, checked, welded, accepted

struct WeldState {
  std::string weld;
  WeldStage stage = WeldStage::kToDo;
  // The hold point: who accepted the fit-up and on what day, before it was welded; "" nobody yet.
  std::string fit_up_by, fit_up_on;
};

// By the last check of the step that makes each weld. After tacking: tacked, and checked once that
// or a check before the weld was accepted; after the weld: welded, and accepted once that check
// was. A redo of the fit-up takes its signature back. Welds without a check are left out: they are
// to do. Records in the order of their ids. Pure; any thread.
[[nodiscard]] std::vector<WeldState> weld_states(const std::vector<job::CheckRecord>& records);

}  // namespace spool::isometric
