// The commands of spoolsight-job, but capture.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/job_commands.h"

#include <filesystem>
#include <iostream>

#include "app/isometric/job_charts.h"
#include "app/job/job_export.h"
#include "app/job/report_check.h"
#include "app/job/salvage_job.h"
#include "tools/job_text.h"
#include "tools/plain_text.h"

namespace spool::tools {

Result<int> make(const JobOptions& options) {
  const auto rule = guide::parse_gap_rule(options.gap_rule);
  const std::filesystem::path folder =
      options.out.empty()
          ? std::filesystem::path(std::filesystem::path(options.design).stem().string() +
                                  (options.spool.empty() ? "" : "-" + options.spool) + ".spooljob")
          : std::filesystem::path(options.out);
  const job::NewJob made{options.design,
                         options.spool,
                         {rule.value_or(guide::GapRule::kNone), options.root_gap_mm / 1000}};
  if (Status done = job::create_job(folder, made); !done) return done.error();
  std::cout << "made " << folder.string() << "\n";
  return 0;
}

Result<int> show(const JobOptions& options) {
  const auto job = job::Job::open(options.job, job::JobUse::kLook);
  if (!job) return job.error();
  std::cout << job_text(*job);
  return job->damage().empty() ? Result<int>(0)
                               : Result<int>(Error{ErrorCode::kBadInput, job->damage()});
}

Result<job::Job> work_on(const JobOptions& options) {
  auto job = job::Job::open(options.job, job::JobUse::kWork);
  if (job && !job->taken_over_from().empty())
    std::cerr << "taken over from " << job->taken_over_from() << ", which ended without closing\n";
  if (job && !job->alterations().empty())
    std::cerr << "warning: the job was altered since it was closed: "
              << plain_text(job->alterations().front().file + " " + job->alterations().front().text)
              << "; spoolsight-inspect --verify tells all\n";
  return job;
}

Result<int> order(const JobOptions& options) {
  auto job = work_on(options);
  if (!job) return job.error();
  if (Status done = job->move_step(options.move[0] - 1, options.move[1] - 1); !done)
    return done.error();
  std::cout << job_text(*job);
  return 0;
}

Result<job::CheckRecord> check_of(const JobOptions& options, const job::Job& job,
                                  const std::string& report) {
  if (options.step < 1 || options.step > static_cast<int>(job.steps().size()))
    return Error{ErrorCode::kUsage,
                 "--step: the job has steps 1 to " + std::to_string(job.steps().size())};
  const int part = job.steps()[static_cast<std::size_t>(options.step - 1)].part;
  auto record = job::check_from_report(report, job.design().parts[static_cast<std::size_t>(part)],
                                       job.file().design_sha256);
  if (!record) return record.error();
  record->outcome = job::parse_outcome(options.outcome).value_or(job::Outcome::kRedo);
  record->phase = job::parse_phase(options.phase).value_or(job::Phase::kAfterTack);
  record->remark = options.remark;
  record->operator_name = options.operator_name;
  record->override_reason = options.override_reason;
  record->picture = options.picture;
  record->at = job::now();
  return record;
}

Result<int> check(const JobOptions& options) {
  auto job = work_on(options);
  if (!job) return job.error();
  const auto record = check_of(options, *job, options.report);
  if (!record) return record.error();
  const auto id = job->add(options.step - 1, *record);
  if (!id) return id.error();
  std::cout << "check " << *id << " of step " << options.step
            << " is in the journal: " << options.outcome << ", measured " << record->status << "\n";
  return 0;
}

Result<int> write_out(const JobOptions& options) {
  if (options.csv == options.jsonl)
    return Error{ErrorCode::kUsage, "export: give one of --csv and --jsonl"};
  const auto job = job::Job::open(options.job, job::JobUse::kLook);
  if (!job) return job.error();
  if (!job->damage().empty()) return Error{ErrorCode::kBadInput, job->damage()};
  std::cout << (options.csv ? job::csv_text(job->file(), job->records())
                            : job::json_lines(job->file(), job->records()));
  return 0;
}

Result<int> charts(const JobOptions& options) {
  const auto job = job::Job::open(options.job, job::JobUse::kLook);
  if (!job) return job.error();
  const auto charts = isometric::charts_of(*job);
  if (!charts) return charts.error();
  const auto written = isometric::write_pages(
      isometric::chart_pages(*charts), "Tries and minutes " + charts->title.spool, options.out);
  if (!written) return written.error();
  for (const std::string& file : *written) std::cout << "written to " << file << "\n";
  return 0;
}

Result<int> salvage(const JobOptions& options) {
  const auto salvaged = job::salvage_job(options.job);
  if (!salvaged) return salvaged.error();
  std::cout << "salvaged " << salvaged->found.checks << " checks with " << salvaged->found.numbers
            << " numbers, the last of them check " << salvaged->found.last_id
            << "; the damaged journal is kept as " << salvaged->kept.string() << "\n";
  return 0;
}

}  // namespace spool::tools
