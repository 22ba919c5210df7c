// A job on one spool: a folder with its design, order and journal, that one program works on.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/job/job_file.h"
#include "app/job/job_lock.h"
#include "app/job/job_seal.h"
#include "app/job/journal.h"
#include "vision/design/design_model.h"
#include "vision/guide/assembly_step.h"

namespace spool::job {

struct NewJob {
  std::filesystem::path design;  // .pcf or .glb
  std::string spool;             // "" where the file has one spool only
  guide::GapPolicy gaps;
};

// Makes the folder NAME.spooljob: job.json, design.glb (of a piping file its spool alone), the
// piping file as source.pcf, journal.db, evidence/. It appears whole or not at all. kBadInput: the
// design, a spool that is not in it (those that are, are named); kUsage: another ending; kIo: the
// folder is there already or cannot be written.
[[nodiscard]] Status create_job(const std::filesystem::path& folder, const NewJob& job);

// The folder's parts, beside its name.
[[nodiscard]] std::filesystem::path journal_path(const std::filesystem::path& folder);

enum class JobUse { kLook, kWork };

// One thread. To look takes no lock and changes nothing; to work holds the job alone.
class Job {
 public:
  // kBadInput: no job, a later version, a design that is not the one the job was made with (its
  // SHA-256), an order that does not fit it; kIo: held elsewhere, not readable. A damaged journal
  // is no error: damage() says it, and nothing can be added.
  [[nodiscard]] static Result<Job> open(const std::filesystem::path& folder, JobUse use);

  [[nodiscard]] const JobFile& file() const { return file_; }
  [[nodiscard]] const DesignModel& design() const { return design_; }
  [[nodiscard]] const std::vector<guide::AssemblyStep>& steps() const { return steps_; }
  [[nodiscard]] const std::vector<CheckRecord>& records() const { return records_; }
  [[nodiscard]] const std::string& damage() const { return journal_.damage(); }
  [[nodiscard]] const std::string& taken_over_from() const { return taken_over_from_; }
  // What was altered since the job was last closed; of a job opened for work only. Its seal is then
  // left as it is.
  [[nodiscard]] const std::vector<Change>& alterations() const { return alterations_; }
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  [[nodiscard]] int current_step() const;  // from 0; as many as there are steps: all accepted
  [[nodiscard]] std::string joint_text(int step) const;  // the welds it makes, "W5+W6"

  // Moves a step (both from 0) and writes job.json. kUsage: where nothing that stands would be
  // joined, and among steps that are accepted already.
  [[nodiscard]] Status move_step(int from, int to);

  // Appends a check of a step (from 0); fills step, part and joint. It is on the disk once this
  // returns. kUsage: an acceptance of a part that is not_ok, not_measured or without a status, or
  // of a step before its time, without an override's reason; a remark without text.
  [[nodiscard]] Result<std::int64_t> add(int step, CheckRecord record);

  // The record as add() would write it, or why it would not; writes nothing.
  [[nodiscard]] Result<CheckRecord> as_added(int step, CheckRecord record) const;
  // Appends what as_added() gave, and its capture, in one transaction: both or neither.
  [[nodiscard]] Result<std::int64_t> add_captured(const CheckRecord& record,
                                                  const CaptureRow& capture);
  // The id of the next check; all captures so far.
  [[nodiscard]] Result<std::int64_t> next_check();
  [[nodiscard]] Result<std::vector<CaptureRow>> captures() { return journal_.captures(); }

 private:
  Job(Journal journal, std::filesystem::path folder)
      : journal_(std::move(journal)), folder_(std::move(folder)) {}
  [[nodiscard]] Status set_order(const std::vector<std::string>& names);

  // In the order in which they may go: the journal is closed, the seal written, the lock given
  // back.
  std::optional<JobLock> lock_;
  std::unique_ptr<SealOnClose> seal_;
  Journal journal_;
  std::filesystem::path folder_;
  std::vector<Change> alterations_;
  std::string taken_over_from_;
  JobFile file_;
  DesignModel design_;
  std::vector<int> order_;  // parts of design_
  std::vector<guide::AssemblyStep> steps_;
  std::vector<CheckRecord> records_;
};

}  // namespace spool::job
