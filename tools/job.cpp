// spoolsight-job: a job on one spool from the command line: make, show, order, check, capture,
// report (ncr), export, charts, salvage, keygen.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <cassert>
#include <string>

#include <CLI/CLI.hpp>

#include "app/common/cli.h"
#include "tools/job_commands.h"
#include "tools/job_ncr.h"

namespace spool::tools {
namespace {

CLI::App* command(CLI::App& app, const char* name, const char* what, std::string& job) {
  CLI::App* made = app.add_subcommand(name, what);
  made->add_option("job", job, "The job's folder")->required()->type_name("NAME.spooljob");
  return made;
}

// What check and capture have in common.
void add_check_options(CLI::App& command, JobOptions& o, const char* report) {
  command.add_option("--step", o.step, "The step, from 1")->required();
  command.add_option("--report", o.report, report)->required();
  command.add_option("--outcome", o.outcome, "What is made of it")
      ->required()
      ->check(CLI::IsMember({"accept", "remark", "redo"}));
  command.add_option("--phase", o.phase, "When it was measured")
      ->check(CLI::IsMember({"before-tack", "after-tack", "before-weld", "after-weld"}))
      ->capture_default_str();
  command.add_option("--remark", o.remark, "Needed for the outcome remark")->type_name("TEXT");
  command
      .add_option("--override", o.override_reason,
                  "Why a step that is not_ok, not_measured or before its time is accepted")
      ->type_name("REASON");
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
  tools::add_check_options(*check, o, "report.json of spoolsight-inspect");
  check->add_option("--operator", o.operator_name, "Who checked")->type_name("NAME");
  check->add_option("--picture", o.picture, "A picture's file below the job's evidence/");
  CLI::App* capture = tools::command(
      app, "capture", "Write a check, and keep all that it rests on in evidence/", o.job);
  tools::add_check_options(*capture, o, "Folder that spoolsight-inspect wrote");
  capture->add_option("--operator", o.operator_name, "Who checked")->required()->type_name("NAME");
  capture->add_option("--scan", o.scan, "The scan of the report; else where the report says")
      ->type_name("PATH");
  capture->add_option("--key", o.key, "Key to sign with, of keygen")->type_name("FILE");
  CLI::App* keygen = app.add_subcommand("keygen", "Make a key to sign captures with");
  keygen->add_option("-o,--out", o.out, "The key's file; FILE.pub gets the public key")
      ->required()
      ->type_name("FILE");
  CLI::App* out = tools::command(app, "export", "Write all checks to stdout", o.job);
  out->add_flag("--csv", o.csv, "A row a number");
  out->add_flag("--jsonl", o.jsonl, "A JSON object a line: checks, then joints");
  CLI::App* charts = tools::command(
      app, "charts", "Draw tries and minutes by joint, and what each try measured", o.job);
  charts
      ->add_option("-o,--out", o.out,
                   "One .pdf, or of NAME.png the pages NAME-1.png, NAME-2.png ...")
      ->required()
      ->type_name("FILE.pdf");
  CLI::App* salvage =
      tools::command(app, "salvage", "Copy what can be read of a damaged journal", o.job);
  const auto ncr = tools::add_ncr_command(app);
  app.footer(
      "Exit code: 0 done; 64 usage or not accepted, 65 bad input, 70 internal, 74 read or write "
      "failed.");
  return spool::run_program(app, argc, argv, [&]() -> spool::Result<int> {
    if (make->parsed()) return tools::make(o);
    if (show->parsed()) return tools::show(o);
    if (order->parsed()) return tools::order(o);
    if (check->parsed()) return tools::check(o);
    if (capture->parsed()) return tools::capture(o);
    if (keygen->parsed()) return tools::keygen(o);
    if (out->parsed()) return tools::write_out(o);
    if (charts->parsed()) return tools::charts(o);
    if (app.got_subcommand("ncr")) return ncr();
    assert(salvage->parsed());
    return tools::salvage(o);
  });
}
