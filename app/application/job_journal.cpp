// The job's journal and evidence on the one thread that writes them.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/application/job_journal.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/evidence/report_capture.h"
#include "app/job/report_check.h"

namespace spool {

Result<std::unique_ptr<JobJournal>> JobJournal::open(const std::filesystem::path& folder,
                                                     JournalView& view) {
  Result<job::Job> job = job::Job::open(folder, job::JobUse::kWork);
  if (!job) return job.error();
  if (!job->damage().empty())
    return Error{ErrorCode::kBadInput, folder.string() + ": its journal is damaged (" +
                                           job->damage() +
                                           "); salvage it with spoolsight-job salvage"};
  std::unique_ptr<JobJournal> journal(new JobJournal(std::move(*job)));
  Result<std::vector<job::CaptureRow>> captures = journal->job_.captures();
  if (!captures) return captures.error();
  view = journal->view_ = {journal->job_.records(), std::move(*captures),
                           journal->job_.current_step()};
  return journal;
}

Result<Captured> JobJournal::capture(const CaptureOrder& order) {
  const auto of = std::ranges::find(job_.steps(), order.part, &guide::AssemblyStep::part);
  if (of == job_.steps().end())
    return Error{ErrorCode::kUsage, "what was checked is the part of no step"};
  Result<job::CheckRecord> check = job::check_from_report(
      order.report / "report.json", job_.design().parts[static_cast<std::size_t>(order.part)],
      job_.file().design_sha256);
  if (!check) return check.error();
  check->outcome = job::Outcome::kRedo;
  check->operator_name = order.operator_name;
  Result<evidence::CaptureRequest> request = evidence::report_request(order.report);
  if (!request) return request.error();
  request->step = static_cast<int>(of - job_.steps().begin());
  request->check = *std::move(check);
  if (Status added = evidence::add_frame(order.frame, order.report.string(), *request); !added)
    return added.error();
  const Result<evidence::Captured> captured = evidence::capture(job_, *request);
  if (!captured) return captured.error();
  // Nothing may fail from here on: it would be captured a second time.
  view_.records = job_.records();
  const job::CheckRecord& added = view_.records.back();
  view_.captures.push_back({.number = captured->number,
                            .check_id = captured->check_id,
                            .entry_sha256 = captured->entry_sha256,
                            .signer = "",
                            .wall_s = std::floor(added.at.wall_s)});
  return Captured{captured->number, added, view_};
}

Result<JournalView> JobJournal::accept(int step, job::CheckRecord check) {
  check.id = 0;  // a row of its own
  check.outcome = job::Outcome::kAccept;
  check.at = job::now();
  if (const Result<std::int64_t> id = job_.add(step, std::move(check)); !id) return id.error();
  view_.records = job_.records();
  view_.step = job_.current_step();
  return view_;
}

}  // namespace spool
