// spoolsight-bench: runs the registered benchmarks; google-benchmark's own flags choose which
// and how.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <cstdio>
#include <string>
#include <string_view>

#include <benchmark/benchmark.h>

#include "vision/core/version.h"

int main(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    if (std::string_view(argv[i]) != "--version") continue;
    std::string line = "spoolsight-bench " + std::string(spool::version()) + " (commit " +
                       std::string(spool::commit()) + ")\n";
    std::fputs(line.c_str(), stdout);
    return 0;
  }
  benchmark::AddCustomContext("commit", std::string(spool::commit()));
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv))
    return 64;  // usage, as every program of ours
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
