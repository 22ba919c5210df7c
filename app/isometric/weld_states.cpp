// How far each weld of a job is, read off its journal.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/isometric/weld_states.h"

#include <algorithm>
#include <sstream>

namespace spool::isometric {
namespace {

using job::Outcome;
using job::Phase;

void apply(const job::CheckRecord& record, WeldState& state) {
  const bool is_accepted = record.outcome != Outcome::kRedo;
  switch (record.phase) {
    case Phase::kBeforeTack:
      // Taken apart again, or not put together yet.
      state = {state.weld, WeldStage::kToDo, "", ""};
      return;
    case Phase::kAfterTack:
    case Phase::kBeforeWeld:
      state = {state.weld, is_accepted ? WeldStage::kChecked : WeldStage::kTacked, "", ""};
      if (!is_accepted) return;
      state.fit_up_by = record.operator_name;
      state.fit_up_on = job::utc_text(record.at.wall_s).substr(0, 10);
      return;
    case Phase::kAfterWeld:
      state.stage = is_accepted ? WeldStage::kAccepted : WeldStage::kWelded;
      return;
  }
}

}  // namespace

std::string_view name(WeldStage stage) {
  switch (stage) {
    case WeldStage::kToDo:
      return "to do";
    case WeldStage::kTacked:
      return "tacked";
    case WeldStage::kChecked:
      return "checked";
    case WeldStage::kWelded:
      return "welded";
    case WeldStage::kAccepted:
      return "accepted";
  }
  return "to do";
}

std::vector<WeldState> weld_states(const std::vector<job::CheckRecord>& records) {
  std::vector<WeldState> states;
  for (const job::CheckRecord& record : records) {
    std::istringstream welds(record.joint);
    for (std::string weld; std::getline(welds, weld, '+');) {
      if (weld.empty()) continue;
      auto state = std::find_if(states.begin(), states.end(),
                                [&](const WeldState& each) { return each.weld == weld; });
      if (state == states.end()) state = states.insert(state, {weld, WeldStage::kToDo, "", ""});
      apply(record, *state);
    }
  }
  return states;
}

}  // namespace spool::isometric
