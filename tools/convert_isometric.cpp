// spoolsight-convert --isometric: the sheet of a design, with a job's states if one is given.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/convert_isometric.h"

#include <algorithm>
#include <filesystem>
#include <iostream>

#include "app/common/cli.h"
#include "app/isometric/sheet.h"
#include "app/job/job.h"

namespace spool::tools {
namespace {

// States and gaps of a job, whose design has to have the welds of this one.
Status take_job(const std::string& folder, const DesignModel& design,
                isometric::SheetOptions& options) {
  const Result<job::Job> job = job::Job::open(folder, job::JobUse::kLook);
  if (!job) return job.error();
  for (const Joint& joint : job->design().joints) {
    const bool is_there = std::any_of(
        design.joints.begin(), design.joints.end(),
        [&](const Joint& each) { return each.weld == joint.weld && each.type == joint.type; });
    if (!is_there)
      return Error{ErrorCode::kBadInput, folder + " is a job on another design: " + design.path +
                                             " has no weld " + joint.weld + " of this kind"};
  }
  if (!job->damage().empty())
    return Error{ErrorCode::kBadInput,
                 folder + ": the journal is damaged (" + job->damage() +
                     "), so it does not tell how far the welds are; salvage it first"};
  options.gaps = job->file().gaps;
  options.states = isometric::weld_states(job->records());
  return {};
}

}  // namespace

void add_isometric_flags(CLI::App& app, IsometricFlags& flags) {
  app.add_option("--isometric", flags.out,
                 "The two-sided isometric with cut sheet and weld map: one .pdf, or of NAME.png "
                 "the pages NAME-1.png, NAME-2.png ...")
      ->type_name("FILE.pdf");
  app.add_option("--job", flags.job, "Of an isometric: the job that says how far its welds are")
      ->type_name("FOLDER");
  app.add_option("--date", flags.date, "Of an isometric: the date in its title block, as it is")
      ->type_name("TEXT");
  app.add_option("--swing-radius-mm", flags.swing_radius_mm,
                 "Of an isometric: how far a piece on the shop's rolls may reach from their axis")
      ->check(positive_number())
      ->capture_default_str()
      ->type_name("MM");
  app.add_flag("--feet-inches", flags.feet_inches,
               "Of an isometric: lengths in feet, inches and sixteenths");
}

Status check(const IsometricFlags& flags) {
  if (flags.out.empty()) {
    if (!flags.job.empty() || !flags.date.empty() || flags.feet_inches)
      return Error{ErrorCode::kUsage,
                   "--job, --date and --feet-inches are of --isometric FILE.pdf"};
    return {};
  }
  const std::string ending = std::filesystem::path(flags.out).extension().string();
  if (ending != ".pdf" && ending != ".png")
    return Error{ErrorCode::kUsage,
                 "--isometric " + flags.out + ": an isometric is written as .pdf or .png"};
  return {};
}

Status write_isometric(const DesignModel& design, const IsometricFlags& flags, double root_gap_m) {
  isometric::SheetOptions options;
  options.date = flags.date;
  options.feet_inches = flags.feet_inches;
  options.rolls.swing_radius_m = flags.swing_radius_mm / 1000;
  if (root_gap_m > 0) options.gaps = {guide::GapRule::kSubtract, root_gap_m};
  if (!flags.job.empty()) {
    if (Status taken = take_job(flags.job, design, options); !taken) return taken;
  }
  const Result<isometric::Sheet> sheet = isometric::make_sheet(design, options);
  if (!sheet) return sheet.error();
  const Result<std::vector<std::string>> written = isometric::write_sheet(*sheet, flags.out);
  if (!written) return written.error();
  for (const std::string& warning : sheet->warnings) std::cerr << "warning: " << warning << "\n";
  for (const std::string& file : *written) std::cout << "written to " << file << "\n";
  return {};
}

}  // namespace spool::tools
