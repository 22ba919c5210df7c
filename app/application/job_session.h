// The job that the screen works on: its present step, the next part's ghost, checks into the
// journal.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/job/job.h"
#include "vision/core/pose.h"
#include "vision/core/result.h"

namespace spool {

// Where the present step's part belongs; m, design frame.
struct StepGhost {
  int part = -1;
  Pose T_design_part = Pose::Identity();
  bool is_as_built = false;  // on what was measured of its neighbours; else as drawn
  // Off the drawing's place by more than what was measured is sure of (k = 2).
  bool differs = false;
};

// One thread. The job is held alone while it lives.
class JobSession {
 public:
  // As job::Job::open() to work. `operator_name` may be empty: the journal then says nothing of
  // who.
  [[nodiscard]] static Result<JobSession> open(const std::filesystem::path& folder,
                                               std::string operator_name);

  [[nodiscard]] const job::Job& job() const { return job_; }
  [[nodiscard]] int steps() const { return static_cast<int>(job_.steps().size()); }
  [[nodiscard]] int step() const { return job_.current_step(); }  // from 0; steps(): all accepted
  [[nodiscard]] int part() const;                                 // of the design; -1: all accepted
  // "step 4 of 11", "elbow_2 onto pipe_3 · W4, fab weld · cut 260.0 mm"
  [[nodiscard]] std::string step_words() const;
  [[nodiscard]] std::string part_words() const;
  [[nodiscard]] std::vector<bool> stands() const;  // one a part: accepted
  // Nothing for the base, which is put where it is put, and where all are accepted.
  [[nodiscard]] std::optional<StepGhost> ghost() const;

  // Another look was asked for: what the last check said decides nothing any more.
  void begin_check() { checked_.reset(); }
  // The numbers of the step of `part`, which the look was asked for, out of the report written of
  // it: a check that decides nothing yet. -1: belongs to no step. kBadInput: no report of this
  // design. kIo: the disk; nothing was taken then.
  [[nodiscard]] Status take_check(const std::filesystem::path& report, int part);
  // What was measured of the present step by the last check; null: it was not checked.
  [[nodiscard]] const job::CheckRecord* checked() const { return checked_ ? &*checked_ : nullptr; }
  // Why the step cannot be accepted at a touch; empty: it can.
  [[nodiscard]] std::string why_not_accept() const;
  // Accepts the step on its last check. kUsage: why_not_accept().
  [[nodiscard]] Status accept();

 private:
  JobSession(job::Job job, std::string operator_name)
      : job_(std::move(job)), operator_name_(std::move(operator_name)) {}

  job::Job job_;
  std::string operator_name_;
  std::optional<job::CheckRecord> checked_;
};

}  // namespace spool
