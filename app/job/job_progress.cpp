// What the checks of a job add up to: which steps are accepted, tries and time a joint, shrinkage.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/job/job_progress.h"

#include <algorithm>
#include <cmath>

namespace spool::job {
namespace {

const CheckRecord* last_of(const std::vector<const CheckRecord*>& checks, Phase phase,
                           std::int64_t before) {
  const CheckRecord* last = nullptr;
  for (const CheckRecord* check : checks) {
    if (check->phase == phase && check->id < before) last = check;
  }
  return last;
}

std::vector<Shrinkage> shrinkage_of(const std::vector<const CheckRecord*>& checks) {
  std::vector<Shrinkage> list;
  const CheckRecord* after = nullptr;
  for (const CheckRecord* check : checks) {
    if (check->phase == Phase::kAfterWeld) after = check;
  }
  if (after == nullptr) return list;
  const CheckRecord* before = last_of(checks, Phase::kBeforeWeld, after->id);
  if (before == nullptr) before = last_of(checks, Phase::kAfterTack, after->id);
  if (before == nullptr) return list;
  for (const CheckNumber& now : after->numbers) {
    const auto then = std::find_if(
        before->numbers.begin(), before->numbers.end(),
        [&](const CheckNumber& each) { return each.name == now.name && each.unit == now.unit; });
    if (then == before->numbers.end() || !then->measured || !now.measured) continue;
    list.push_back({now.name, now.unit, *now.measured - *then->measured,
                    std::hypot(now.u.value_or(0), then->u.value_or(0))});
  }
  return list;
}

// A check of its own, not another decision on the one before.
bool is_anew(const CheckRecord* before, const CheckRecord& check) {
  return before == nullptr || check.report_sha256.empty() ||
         check.report_sha256 != before->report_sha256;
}

}  // namespace

const CheckRecord* accepted_record(const std::string& part,
                                   const std::vector<CheckRecord>& records) {
  for (auto record = records.rbegin(); record != records.rend(); ++record) {
    if (record->part != part) continue;
    return record->outcome == Outcome::kRedo ? nullptr : &*record;
  }
  return nullptr;
}

std::vector<StepState> step_states(const std::vector<std::string>& order,
                                   const std::vector<CheckRecord>& records) {
  std::vector<StepState> states;
  for (const std::string& part : order)
    states.push_back(accepted_record(part, records) != nullptr ? StepState::kAccepted
                                                               : StepState::kOpen);
  return states;
}

int current_step(const std::vector<std::string>& order, const std::vector<CheckRecord>& records) {
  const auto states = step_states(order, records);
  return static_cast<int>(std::find(states.begin(), states.end(), StepState::kOpen) -
                          states.begin());
}

std::vector<JointHistory> joint_histories(const std::vector<CheckRecord>& records) {
  std::vector<JointHistory> histories;
  std::vector<std::vector<const CheckRecord*>> checks;
  for (const CheckRecord& record : records) {
    if (record.joint.empty()) continue;
    const auto known =
        std::find_if(histories.begin(), histories.end(),
                     [&](const JointHistory& each) { return each.joint == record.joint; });
    const auto at = static_cast<std::size_t>(known - histories.begin());
    if (known == histories.end()) {
      histories.push_back({record.joint, record.part});
      checks.emplace_back();
    }
    checks[at].push_back(&record);
  }
  for (std::size_t j = 0; j < histories.size(); ++j) {
    JointHistory& history = histories[j];
    const CheckRecord* before = nullptr;
    bool was_accepted = false;
    for (const CheckRecord* check : checks[j]) {
      const bool counts = is_anew(before, *check);
      if (counts) ++history.checks;
      if (counts && !was_accepted) ++history.tries;
      history.is_accepted = check->outcome != Outcome::kRedo;
      was_accepted = was_accepted || history.is_accepted;
      if (!check->override_reason.empty()) ++history.overrides;
      if (before != nullptr) {
        const auto seconds = seconds_between(before->at, check->at);
        history.seconds += seconds.value_or(0);
        history.time_is_whole = history.time_is_whole && seconds.has_value();
      }
      before = check;
    }
    history.shrinkage = shrinkage_of(checks[j]);
  }
  return histories;
}

std::vector<const CheckRecord*> joint_checks(const std::string& joint,
                                             const std::vector<CheckRecord>& records) {
  std::vector<const CheckRecord*> checks;
  for (const CheckRecord& record : records) {
    if (record.joint != joint) continue;
    if (is_anew(checks.empty() ? nullptr : checks.back(), record))
      checks.push_back(&record);
    else
      checks.back() = &record;
  }
  return checks;
}

}  // namespace spool::job
