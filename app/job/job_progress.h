// What the checks of a job add up to: which steps are accepted, tries and time a joint, shrinkage.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/job/check_record.h"

namespace spool::job {

// All of this is read off the records, in the order of their ids, and kept nowhere else. Pure; any
// thread.

enum class StepState { kOpen, kAccepted };

// By part: the outcome of its last check decides, so a redo opens a step that was accepted.
[[nodiscard]] std::vector<StepState> step_states(const std::vector<std::string>& order,
                                                 const std::vector<CheckRecord>& records);

// The first open step (from 0) of an order of part names; its size where all are accepted.
[[nodiscard]] int current_step(const std::vector<std::string>& order,
                               const std::vector<CheckRecord>& records);

// The last accepted record of a part; null where it is open.
[[nodiscard]] const CheckRecord* accepted_record(const std::string& part,
                                                 const std::vector<CheckRecord>& records);

// How far a weld drew a number: after the weld less before it.
struct Shrinkage {
  std::string number, unit;
  double change = 0, u = 0;  // u: both measurements' together, as if independent
};

struct JointHistory {
  std::string joint, part;
  int tries = 0;              // checks up to and with the first that was accepted
  int checks = 0;             // all
  int overrides = 0;          // accepted against the numbers
  double seconds = 0;         // from its first check to its last, as far as clocks tell
  bool time_is_whole = true;  // false: of some interval no clock tells (seconds is then too short)
  bool is_accepted = false;
  std::vector<Shrinkage> shrinkage;  // of numbers measured in the last check before and after it
};

// One entry for each joint that was checked, in the order of their first checks. Records after one
// another of one report are one check: its numbers as they came, and what was decided on them.
// "Before" is the
// last check before the last after-weld one, of phase before-weld, else after-tack.
[[nodiscard]] std::vector<JointHistory> joint_histories(const std::vector<CheckRecord>& records);

// The checks of a joint in their order. Of records after one another of one report, which are one
// check, the last: what was made of it.
[[nodiscard]] std::vector<const CheckRecord*> joint_checks(const std::string& joint,
                                                           const std::vector<CheckRecord>& records);

}  // namespace spool::job
