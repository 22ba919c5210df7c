// The command `spoolsight-job ncr`: a non-conformance report on the job's spool, or a void one.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/job_ncr.h"

#include <filesystem>
#include <iostream>
#include <memory>
#include <string>

#include "app/job/job.h"
#include "app/ncr/ncr_writer.h"

namespace spool::tools {
namespace {

struct NcrOptions {
  std::string job, report, shop, fields, operator_name, out, units = "mm", void_number, reason;
};

Result<int> write_report(const NcrOptions& options) {
  if (options.report.empty() || options.shop.empty())
    return Error{ErrorCode::kUsage, "ncr: give --report and --shop (or --void and --reason)"};
  const auto job = job::Job::open(options.job, job::JobUse::kLook);
  if (!job) return job.error();
  const auto prefix = ncr::number_prefix(options.job, options.shop);
  if (!prefix) return prefix.error();
  ncr::OperatorInput input{options.operator_name, {}, job::utc_text(job::now().wall_s)};
  input.lengths = options.units == "mm" ? LengthStyle::kMillimetre : LengthStyle::kFeetInch;
  if (!options.fields.empty()) {
    auto fields = ncr::read_fields(options.fields);
    if (!fields) return fields.error();
    input.fields = *std::move(fields);
  }
  auto evidence = ncr::read_evidence(options.report, job->file().design_sha256);
  if (!evidence) return evidence.error();
  const auto document = ncr::fill_form(*job, options.job, *std::move(evidence), input);
  if (!document) return document.error();
  const auto issued = ncr::write_ncr(*document, options.job, *prefix, options.out);
  if (!issued) return issued.error();
  std::cout << issued->number << "\n";
  std::cerr << "written to " << issued->folder.string() << "\n";
  return 0;
}

Result<int> make_void(const NcrOptions& options) {
  const auto job = job::Job::open(options.job, job::JobUse::kLook);
  if (!job) return job.error();
  if (Status done = ncr::void_ncr(options.job, options.void_number, options.reason,
                                  options.operator_name, job::utc_text(job::now().wall_s));
      !done)
    return done.error();
  std::cout << options.void_number << " is void\n";
  return 0;
}

}  // namespace

std::function<Result<int>()> add_ncr_command(CLI::App& app) {
  const auto o = std::make_shared<NcrOptions>();
  CLI::App* ncr = app.add_subcommand("ncr", "Write a non-conformance report, and print its number");
  ncr->add_option("job", o->job, "The job's folder")->required()->type_name("NAME.spooljob");
  ncr->add_option("--report", o->report, "The folder that spoolsight-inspect wrote")
      ->type_name("DIR");
  ncr->add_option("--shop", o->shop, "The shop, as it stands in the number JOB-SHOP-NCR-NNN")
      ->type_name("TEXT");
  ncr->add_option("--fields", o->fields, "What is to stand in the form's fields, by key")
      ->type_name("FIELDS.json");
  ncr->add_option("--operator", o->operator_name, "Who writes it")->type_name("NAME");
  ncr->add_option("--out", o->out, "A folder that gets a copy, beside the job's own ncr/")
      ->type_name("DIR");
  ncr->add_option("--units", o->units, "Display of lengths in PDF and HTML")
      ->check(CLI::IsMember({"mm", "ft-in"}))
      ->capture_default_str();
  CLI::Option* number =
      ncr->add_option("--void", o->void_number, "Mark this report as void; its number stays used")
          ->type_name("NUMBER");
  ncr->add_option("--reason", o->reason, "Why it is void")->needs(number)->type_name("TEXT");
  return [o] { return o->void_number.empty() ? write_report(*o) : make_void(*o); };
}

}  // namespace spool::tools
