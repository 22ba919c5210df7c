// The command line of spoolsight-inspect and what follows from it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "vision/core/length_unit.h"
#include "vision/core/result.h"
#include "vision/inspector.h"

namespace spool::tools {

// The flags as they stand on the command line.
struct InspectOptions {
  std::vector<std::string> designs;
  std::string scan;
  std::optional<std::int64_t> frame;  // the first if unset
  std::string align;                  // empty: by what else is given
  std::string pairs, pose;
  // No flag: of an entry whose pose was come by in the app, and how (a method's name).
  std::string posed_by;
  std::string datum;  // part names with commas between
  std::string standard = "pfi-es3";
  std::string design_unit, scan_unit;
  std::string units = "mm";
  std::string calibration;
  std::string sensor_check;  // a view of a wall in place of design and scan
  std::uint32_t seed = 1;
  std::string out;
};

void add_inspect_options(CLI::App& app, InspectOptions& options);

// The method's name by the rule of ARCHITECTURE, Command lines.
[[nodiscard]] std::string method_text(const InspectOptions& options);

// The method by the rule of ARCHITECTURE, Command lines (pose, else three-point, else
// find) with its files read, the rules' too; kUsage where flags contradict each other,
// kBadInput for the files.
[[nodiscard]] Result<InspectorOptions> inspector_options(const InspectOptions& options);

// kUsage where a flag is missing that an inspection needs.
[[nodiscard]] Status check_given(const InspectOptions& options);

// kUsage for a flag combination that makes no sense, before any large file is read.
[[nodiscard]] Status check(const InspectOptions& options);

// The part names of --datum; else the design's own datums. kUsage names a part that is not in the
// design.
[[nodiscard]] Result<std::vector<std::string>> datum_parts(const std::string& flag,
                                                           const DesignModel& model);

}  // namespace spool::tools
