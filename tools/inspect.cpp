// spoolsight-inspect: one design, one scan, one folder with what was found; or what was captured,
// verified or made again.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>

#include "app/common/cli.h"
#include "tools/inspect_evidence.h"
#include "tools/inspect_options.h"
#include "tools/inspection.h"

int main(int argc, char** argv) {
  namespace tools = spool::tools;
  CLI::App app{"Compares a scan of a pipe spool with its design and writes a report."};
  tools::InspectOptions options;
  tools::EvidenceOptions evidence;
  spool::add_common_options(app, "spoolsight-inspect");
  tools::add_inspect_options(app, options);
  tools::add_evidence_options(app, evidence);
  return spool::run_program(app, argc, argv, [&]() -> spool::Result<int> {
    if (!evidence.verify.empty()) return tools::verify(evidence);
    if (!evidence.replay.empty()) return tools::replay(evidence, options.out);
    if (options.sensor_check.empty())
      if (auto given = tools::check_given(options); !given) return given.error();
    return tools::inspect(options);
  });
}
