// spoolsight-job: a job on one spool from the command line: make, show, order, check, export,
// salvage.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/job/job.h"

#include <cassert>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/common/cli.h"
#include "app/job/job_export.h"
#include "app/job/report_check.h"
#include "app/job/salvage_job.h"
#include "tools/job_text.h"

namespace spool::tools {
namespace {

struct JobOptions {
  std::string job, design, spool, out, gap_rule = "none";
  double root_gap_mm = 0;
  std::vector<int> move;
  int step = 0;
  std::string report, outcome, phase = "after-tack", remark, operator_name, override_reason,
                               picture;
  bool csv = false, jsonl = false;
};

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

Result<int> check(const JobOptions& options) {
  auto job = work_on(options);
  if (!job) return job.error();
  if (options.step < 1 || options.step > static_cast<int>(job->steps().size()))
    return Error{ErrorCode::kUsage,
                 "--step: the job has steps 1 to " + std::to_string(job->steps().size())};
  const int part = job->steps()[static_cast<std::size_t>(options.step - 1)].part;
  auto record =
      job::check_from_report(options.report, job->design().parts[static_cast<std::size_t>(part)],
                             job->file().design_sha256);
  if (!record) return record.error();
  record->outcome = job::parse_outcome(options.outcome).value_or(job::Outcome::kRedo);
  record->phase = job::parse_phase(options.phase).value_or(job::Phase::kAfterTack);
  record->remark = options.remark;
  record->operator_name = options.operator_name;
  record->override_reason = options.override_reason;
  record->picture = options.picture;
  record->at = job::now();
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

Result<int> salvage(const JobOptions& options) {
  const auto salvaged = job::salvage_job(options.job);
  if (!salvaged) return salvaged.error();
  std::cout << "salvaged " << salvaged->found.checks << " checks with " << salvaged->found.numbers
            << " numbers, the last of them check " << salvaged->found.last_id
            << "; the damaged journal is kept as " << salvaged->kept.string() << "\n";
  return 0;
}

CLI::App* command(CLI::App& app, const char* name, const char* what, std::string& job) {
  CLI::App* made = app.add_subcommand(name, what);
  made->add_option("job", job, "The job's folder")->required()->type_name("NAME.spooljob");
  return made;
}

}  // namespace
}  // namespace spool::tools

int main(int argc, char** argv) {
  namespace tools = spool::tools;
  CLI::App app{"Keeps a job on one spool: its order of assembly and the journal of its checks."};
  tools::JobOptions o;
  spool::add_common_options(app, "spoolsight-job");
  app.require_subcommand(1);
  CLI::App* make = app.add_subcommand("new", "Make a job from a design");
  make->add_option("design", o.design, "Design: .pcf or .glb")->required()->type_name("FILE");
  make->add_option("--spool", o.spool, "The spool, as spoolsight-convert --info names it");
  make->add_option("-o,--out", o.out, "The folder to make; else FILE-SPOOL.spooljob here");
  make->add_option("--gap-rule", o.gap_rule, "What is done about root gaps in cut lengths")
      ->check(CLI::IsMember({"none", "subtract", "model-has-gaps"}));
  make->add_option("--root-gap-mm", o.root_gap_mm, "Root gap of butt welds, mm")
      ->check(spool::non_negative_number());
  CLI::App* show =
      tools::command(app, "show", "Print steps, checks and where the job stands", o.job);
  CLI::App* order = tools::command(app, "order", "Move a step to another place", o.job);
  order->add_option("--move", o.move, "Step, and the place it goes to, from 1")
      ->required()
      ->expected(2)
      ->type_name("N M");
  CLI::App* check = tools::command(app, "check", "Write a check of a step into the journal", o.job);
  check->add_option("--step", o.step, "The step, from 1")->required();
  check->add_option("--report", o.report, "report.json of spoolsight-inspect")->required();
  check->add_option("--outcome", o.outcome, "What is made of it")
      ->required()
      ->check(CLI::IsMember({"accept", "remark", "redo"}));
  check->add_option("--phase", o.phase, "When it was measured")
      ->check(CLI::IsMember({"before-tack", "after-tack", "before-weld", "after-weld"}))
      ->capture_default_str();
  check->add_option("--remark", o.remark, "Needed for the outcome remark")->type_name("TEXT");
  check->add_option("--operator", o.operator_name, "Who checked")->type_name("NAME");
  check->add_option("--picture", o.picture, "A picture's file below the job's evidence/");
  check
      ->add_option("--override", o.override_reason,
                   "Why a step that is not_ok, not_measured or before its time is accepted")
      ->type_name("REASON");
  CLI::App* out = tools::command(app, "export", "Write all checks to stdout", o.job);
  out->add_flag("--csv", o.csv, "A row a number");
  out->add_flag("--jsonl", o.jsonl, "A JSON object a line: checks, then joints");
  CLI::App* salvage =
      tools::command(app, "salvage", "Copy what can be read of a damaged journal", o.job);
  app.footer(
      "Exit code: 0 done; 64 usage or not accepted, 65 bad input, 70 internal, 74 read or write "
      "failed.");
  return spool::run_program(app, argc, argv, [&]() -> spool::Result<int> {
    if (make->parsed()) return tools::make(o);
    if (show->parsed()) return tools::show(o);
    if (order->parsed()) return tools::order(o);
    if (check->parsed()) return tools::check(o);
    if (out->parsed()) return tools::write_out(o);
    assert(salvage->parsed());
    return tools::salvage(o);
  });
}
