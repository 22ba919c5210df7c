// The job that the screen works on: its present step, the next part's ghost, checks into the
// journal.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/application/job_journal.h"
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

// For the thread of the screen; what writes the journal is journal(), which has a thread of its own
// once an application has the job.
class JobSession {
 public:
  // As job::Job::open() to work. `operator_name` may be empty: who checks has to say it then.
  [[nodiscard]] static Result<JobSession> open(const std::filesystem::path& folder,
                                               std::string operator_name);

  // What never changes: file, design, steps, folder.
  [[nodiscard]] const job::Job& job() const { return journal_->job(); }
  [[nodiscard]] JobJournal& journal() const { return *journal_; }
  // What the journal held when it was last heard of.
  [[nodiscard]] const JournalView& view() const { return view_; }
  void take(JournalView view) { view_ = std::move(view); }
  [[nodiscard]] const std::string& operator_name() const { return operator_name_; }
  void set_operator_name(std::string name) { operator_name_ = std::move(name); }

  [[nodiscard]] int steps() const { return static_cast<int>(job().steps().size()); }
  [[nodiscard]] int step() const { return view_.step; }  // from 0; steps(): all accepted
  [[nodiscard]] int part() const;                        // of the design; -1: all accepted
  // "step 4 of 11", "elbow_2 onto pipe_3 · W4, fab weld · cut 260.0 mm"
  [[nodiscard]] std::string step_words() const;
  [[nodiscard]] std::string part_words() const;
  [[nodiscard]] std::vector<bool> stands() const;  // one a part: accepted
  // Nothing for the base, which is put where it is put, and where all are accepted.
  [[nodiscard]] std::optional<StepGhost> ghost() const;

  // Another look was asked for: what the last check said decides nothing any more.
  void begin_check() { checked_.reset(); }
  // A capture of the step of `part` is in the journal.
  void take_check(Captured captured);
  // What was measured of the present step by the last check; null: it was not checked.
  [[nodiscard]] const job::CheckRecord* checked() const { return checked_ ? &*checked_ : nullptr; }
  // Why the step cannot be accepted at a touch; empty: it can.
  [[nodiscard]] std::string why_not_accept() const;
  // The check that the step is accepted on, which decides nothing any more here: for
  // journal().accept(). kUsage: why_not_accept().
  [[nodiscard]] Result<job::CheckRecord> give_accepted();

 private:
  JobSession(std::unique_ptr<JobJournal> journal, JournalView view, std::string operator_name)
      : journal_(std::move(journal)),
        view_(std::move(view)),
        operator_name_(std::move(operator_name)) {}

  std::unique_ptr<JobJournal> journal_;
  JournalView view_;
  std::string operator_name_;
  std::optional<job::CheckRecord> checked_;
};

}  // namespace spool
