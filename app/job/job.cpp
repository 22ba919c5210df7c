// A job on one spool: a folder with its design, order and journal, that one program works on.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/job/job.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "app/job/job_progress.h"
#include "vision/core/file_digest.h"
#include "vision/design/design_reader.h"
#include "vision/guide/assembly_order.h"

namespace spool::job {

namespace {

// 1 where it cannot be told: what is wrong with the journal its own opening says.
std::int64_t journal_version(const std::filesystem::path& folder) {
  auto database = Database::open(journal_path(folder), OpenFor::kReading);
  if (!database) return 1;
  const auto version = database->integer("PRAGMA user_version");
  return version ? *version : 1;
}

}  // namespace

Result<Job> Job::open(const std::filesystem::path& folder, JobUse use) {
  auto file = read_job_file(folder / "job.json");
  if (!file) return file.error();
  std::optional<JobLock> lock;
  if (use == JobUse::kWork) {
    auto taken = JobLock::take(folder / "lock");
    if (!taken) return taken.error();
    clear_half_written(folder);
    lock.emplace(*std::move(taken));
    file = read_job_file(folder / "job.json");  // as the holder before us left it
    if (!file) return file.error();
  }
  const std::vector<Change> alterations =
      lock && lock->taken_over_from().empty() ? seal_changes(folder) : std::vector<Change>{};
  const bool had_seal = std::filesystem::exists(folder / kSealFile);
  const std::filesystem::path design_file = folder / file->design;
  const auto sha256 = sha256_file(design_file);
  if (!sha256) return sha256.error();
  if (*sha256 != file->design_sha256)
    return Error{ErrorCode::kBadInput,
                 design_file.string() +
                     ": is not the design that the job was made with (its SHA-256 is another); "
                     "put that back, or make a new job"};
  auto design = read_design(design_file);
  if (!design) return design.error();
  const bool is_first = !had_seal && journal_version(folder) == 1;  // made before there were seals
  auto journal = Journal::open(journal_path(folder),
                               use == JobUse::kWork ? OpenFor::kWriting : OpenFor::kReading);
  if (!journal) return journal.error();
  Job job(*std::move(journal), folder);
  if (lock) {
    job.taken_over_from_ = lock->taken_over_from();
    job.lock_.emplace(*std::move(lock));
    if (!is_first) job.alterations_ = alterations;
    if (job.alterations_.empty()) job.seal_ = std::make_unique<SealOnClose>(folder);
  }
  job.file_ = *std::move(file);
  job.design_ = *std::move(design);
  if (Status set = job.set_order(job.file_.order); !set) return set.error();
  if (job.damage().empty()) {
    auto records = job.journal_.records();
    if (!records) return records.error();
    job.records_ = *std::move(records);
  }
  return job;
}

Status Job::set_order(const std::vector<std::string>& names) {
  std::vector<int> order;
  for (const std::string& each : names) {
    const auto part = std::find_if(design_.parts.begin(), design_.parts.end(),
                                   [&](const Part& known) { return known.name == each; });
    order.push_back(part == design_.parts.end() ? -1
                                                : static_cast<int>(part - design_.parts.begin()));
  }
  const auto faults = guide::order_faults(design_, order);
  if (!faults.empty())
    return Error{ErrorCode::kBadInput, fmt::format("{}: \"order\" cannot be built at step {}: {}",
                                                   (folder_ / "job.json").string(),
                                                   faults.front().step + 1, faults.front().reason)};
  order_ = order;
  steps_ = guide::assembly_steps(design_, order_, file_.gaps);
  return {};
}

int Job::current_step() const { return job::current_step(file_.order, records_); }

std::string Job::joint_text(int step) const {
  std::string text;
  const guide::AssemblyStep& made = steps_.at(static_cast<std::size_t>(step));
  for (const guide::StepJoint& joint : made.joints) {
    // What has no number is named by what it joins.
    const std::string own =
        joint.weld.empty()
            ? fmt::format("{}-{}",
                          design_.parts[static_cast<std::size_t>(joint.end.neighbour)].name,
                          design_.parts[static_cast<std::size_t>(made.part)].name)
            : joint.weld;
    text += (text.empty() ? "" : "+") + own;
  }
  return text;
}

Status Job::move_step(int from, int to) {
  if (!lock_)
    return Error{ErrorCode::kUsage, folder_.string() + ": the job is open for looking only"};
  const auto order = guide::move_step(design_, order_, from, to);
  if (!order) return order.error();
  // What stands was put up in its order: neither it nor its place can be changed any more.
  const auto states = step_states(file_.order, records_);
  for (int s = std::min(from, to); s <= std::max(from, to); ++s) {
    if (states[static_cast<std::size_t>(s)] == StepState::kAccepted)
      return Error{ErrorCode::kUsage,
                   fmt::format("step {} ({}) is accepted already; only steps after it can be moved",
                               s + 1, file_.order[static_cast<std::size_t>(s)])};
  }
  JobFile changed = file_;
  changed.order.clear();
  for (const int part : *order)
    changed.order.push_back(design_.parts[static_cast<std::size_t>(part)].name);
  if (Status written = write_job_file(folder_ / "job.json", changed); !written) return written;
  file_ = std::move(changed);
  return set_order(file_.order);
}

Result<CheckRecord> Job::as_added(int step, CheckRecord record) const {
  if (step < 0 || step >= static_cast<int>(steps_.size()))
    return Error{ErrorCode::kUsage, fmt::format("the job has steps 1 to {}", steps_.size())};
  const auto place = static_cast<std::size_t>(step);
  record.step = step + 1;
  record.part = file_.order[place];
  record.joint = joint_text(step);
  const bool is_accepted = record.outcome != Outcome::kRedo;
  if (record.outcome == Outcome::kRemark && record.remark.empty())
    return Error{ErrorCode::kUsage, "an acceptance with a remark needs the remark's text"};
  const bool has_override = !record.override_reason.empty();
  if (has_override && !is_accepted)
    return Error{ErrorCode::kUsage, "a redo overrides nothing; leave the override out"};
  if (is_accepted && !has_override) {
    const int current = current_step();
    if (step > current)
      return Error{ErrorCode::kUsage,
                   fmt::format("step {} ({}) comes first; accept that, or give the reason for an "
                               "override",
                               current + 1, file_.order[static_cast<std::size_t>(current)])};
    // Suspicious is what a person at the table may decide; evidence against it, or none, is not.
    if (record.status != "ok" && record.status != "suspicious")
      return Error{
          ErrorCode::kUsage,
          fmt::format("{} is {} and cannot be accepted; correct it, or give the reason for "
                      "an override",
                      record.part, record.status.empty() ? "not_measured" : record.status)};
  }
  return record;
}

Result<std::int64_t> Job::add(int step, CheckRecord record) {
  auto checked = as_added(step, std::move(record));
  if (!checked) return checked.error();
  const auto id = journal_.append(*checked);
  if (!id) return id.error();
  checked->id = *id;
  records_.push_back(*std::move(checked));
  return *id;
}

Result<std::int64_t> Job::next_check() {
  if (!lock_)
    return Error{ErrorCode::kUsage, folder_.string() + ": the job is open for looking only"};
  return journal_.next_id();
}

Result<std::int64_t> Job::add_captured(const CheckRecord& record, const CaptureRow& capture) {
  const auto id = journal_.append(record, capture);
  if (!id) return id.error();
  records_.push_back(record);
  records_.back().id = *id;
  return *id;
}

}  // namespace spool::job
