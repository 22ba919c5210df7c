// spoolsight-convert --isometric: the sheet of a design, with a job's states if one is given.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "vision/core/result.h"
#include "vision/design/design_model.h"

namespace spool::tools {

struct IsometricFlags {
  std::string out, job, date;
  double swing_radius_mm = 1000;
  bool feet_inches = false;
};

void add_isometric_flags(CLI::App& app, IsometricFlags& flags);

// Flags that make no sense, before anything is read.
[[nodiscard]] Status check(const IsometricFlags& flags);

// Draws and writes; prints what was written on stdout and warnings on stderr. Root gaps are the
// job's, else `root_gap_m` off each butt weld where it is over 0. kBadInput: a design that does not
// say what its parts are, a job on another design.
[[nodiscard]] Status write_isometric(const DesignModel& design, const IsometricFlags& flags,
                                     double root_gap_m);

}  // namespace spool::tools
