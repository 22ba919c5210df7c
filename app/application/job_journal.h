// The job's journal and evidence on the one thread that writes them.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/evidence/scan_snapshot.h"
#include "app/job/job.h"
#include "vision/core/result.h"

namespace spool {

// What the journal holds, for the thread of the screen.
struct JournalView {
  std::vector<job::CheckRecord> records;
  std::vector<job::CaptureRow> captures;  // in the order of their numbers
  int step = 0;                           // the current one, from 0
};

// A check that is to become a capture: its report is written already.
struct CaptureOrder {
  std::filesystem::path report;  // the folder
  evidence::OneFrame frame;      // that the report is of
  int part = -1;                 // whose step was checked
  std::string operator_name;
};

struct Captured {
  std::int64_t number = 0;  // evidence/000001
  job::CheckRecord check;   // as it is in the journal
  JournalView journal;
};

// The job is held alone while this lives. What is marked (journal) is for one thread only, the one
// that the application does its jobs on: the journal's connection, the lock and the folders below
// evidence/ are used by no other. job() is for what never changes: file, design, steps, folder.
class JobJournal {
 public:
  // Reads the view as well; on the thread that opens the job, before any other uses this.
  [[nodiscard]] static Result<std::unique_ptr<JobJournal>> open(const std::filesystem::path& folder,
                                                                JournalView& view);
  [[nodiscard]] const job::Job& job() const { return job_; }

  // (journal) The check and all that its numbers rest on into the evidence, whole or not at all
  // (evidence::capture()); outcome redo: it decides nothing yet. Its errors, and kBadInput: no
  // report of this design.
  [[nodiscard]] Result<Captured> capture(const CaptureOrder& order);
  // (journal) Accepts a step, from 0, on a check of it. The errors of Job::add().
  [[nodiscard]] Result<JournalView> accept(int step, job::CheckRecord check);

 private:
  explicit JobJournal(job::Job job) : job_(std::move(job)) {}

  job::Job job_;
  JournalView view_;
};

}  // namespace spool
