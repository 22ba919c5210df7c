// spoolsight-thesis: the thesis's tables 4-5 to 5-4 from scenes of our own, its numbers beside
// them.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <iostream>
#include <string>
#include <vector>

#include "app/common/cli.h"
#include "app/common/progress.h"
#include "tools/thesis/declutter_tables.h"
#include "tools/thesis/finding_tables.h"

namespace spool::thesis {
namespace {

struct NamedTable {
  const char *name, *title;
};
constexpr NamedTable kFindingTables[] = {
    {"4-5", "density, pipe spool"},        {"4-6", "density, box frame"},
    {"4-7", "clutter, pipe spool"},        {"4-8", "clutter, box frame"},
    {"4-9", "completeness, pipe spool"},   {"4-10", "completeness, box frame"},
    {"4-11", "effectiveness, pipe spool"}, {"4-12", "effectiveness, box frame"}};

Result<int> print_tables(const std::vector<std::string>& chosen, const FindingBench& bench) {
  if (const auto error = validate(bench.finder)) return *error;
  Progress progress;
  const Watch watch{
      {}, [&](std::string_view stage, double fraction) { progress.report(stage, fraction); }};
  const auto wanted = [&](const std::string& name) {
    return chosen.empty() || std::find(chosen.begin(), chosen.end(), name) != chosen.end();
  };
  for (const NamedTable& table : kFindingTables) {
    if (!wanted(table.name)) continue;
    std::cout << "Table " << table.name << ": " << table.title << "\n";
    if (const Status status = print_finding_table(table.name, bench, std::cout, watch); !status)
      return status.error();
    std::cout << "\n";
  }
  if (wanted("5"))
    if (const Status status = print_declutter_tables(bench.seed, std::cout, watch); !status)
      return status.error();
  return 0;
}

}  // namespace
}  // namespace spool::thesis

int main(int argc, char** argv) {
  CLI::App app(
      "Prints the thesis's tables, measured on scenes of our own, with its numbers beside them.");
  spool::add_common_options(app, "spoolsight-thesis");
  spool::thesis::FindingBench bench;
  std::vector<std::string> tables;
  app.add_option("--table", tables, "4-5 to 4-12, or 5 for 5-1 to 5-4; any number; all by default")
      ->check(CLI::IsMember({"4-5", "4-6", "4-7", "4-8", "4-9", "4-10", "4-11", "4-12", "5"}));
  app.add_option("--seed", bench.seed, "Of the scenes and of the finder")->capture_default_str();
  app.add_option("--time-limit-s", bench.finder.time_limit_s, "t of Table 4-2, seconds a design")
      ->check(spool::positive_number())
      ->capture_default_str();
  app.add_option("--min-support", bench.finder.min_support, "lambda_s of Table 4-2")
      ->check(CLI::Range(0.01, 1.0))
      ->capture_default_str();
  app.add_option("--near-over-leaf", bench.finder.near_over_leaf,
                 "What supports a pose: model points within so many octree leaves of the scene")
      ->check(spool::positive_number())
      ->capture_default_str();
  app.add_option("--scenes", bench.effectiveness_scenes, "Scenes of tables 4-11 and 4-12 each")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  app.add_option("--success-limit-m", bench.success_limit_m,
                 "A found pose may put corners of the design's box off by this (m)")
      ->check(spool::positive_number())
      ->capture_default_str();
  return spool::run_program(app, argc, argv,
                            [&] { return spool::thesis::print_tables(tables, bench); });
}
