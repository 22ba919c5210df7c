// spoolsight-dimension-campaign: how often a dimension's error is within its stated uncertainty,
// and how often its verdict is right.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

#include "tools/campaign/campaign_options.h"
#include "tools/campaign/dimension_budget.h"
#include "tools/campaign/dimension_trial.h"
#include "tools/campaign/quantile.h"

namespace spool::campaign {
namespace {

struct Tally {
  std::size_t spools = 0, stated = 0, measured = 0, judged = 0, inside = 0;
  std::size_t bad = 0, bad_ok = 0;        // off by 4/3 of the tolerance or more, and called ok
  std::size_t good = 0, good_not_ok = 0;  // within half of it, and called not_ok
  std::size_t clear = 0, decided = 0;     // under a half or over one and a half, and decided
  std::size_t injected = 0, named = 0, innocent = 0;
  std::size_t rotations = 0, rotations_inside = 0;
  std::vector<double> length_u_mm, alignment_u_deg, alignment_4_u_deg, rotation_u_deg;
};

void add(const TriedDimension& tried, Tally& tally) {
  const Dimension& d = tried.stated;
  ++tally.stated;
  if (!d.is_measured) return;
  ++tally.measured;
  const double expanded = 2 * d.u.total();
  if (!d.is_angle && d.nominal <= 1) tally.length_u_mm.push_back(1000 * expanded);
  if (d.kind == "face_alignment")
    tally.alignment_u_deg.push_back(expanded * 180 / std::numbers::pi);
  if (d.kind == "face_alignment" && tried.nps >= 4)
    tally.alignment_4_u_deg.push_back(expanded * 180 / std::numbers::pi);
  if (d.kind == "rotation") tally.rotation_u_deg.push_back(expanded * 180 / std::numbers::pi);
  if (!tried.truth) return;
  if (d.kind == "rotation") {
    ++tally.rotations;
    tally.rotations_inside += std::abs(d.deviation - *tried.truth) <= expanded ? 1U : 0U;
  }
  ++tally.judged;
  tally.inside += std::abs(d.deviation - *tried.truth) <= expanded ? 1U : 0U;
  const double share = std::abs(*tried.truth) / d.tolerance;
  const bool ok = d.status == Verdict::kOk, not_ok = d.status == Verdict::kNotOk;
  if (share >= 4.0 / 3) tally.bad_ok += ok ? 1U : 0U, ++tally.bad;
  if (share <= 0.5) tally.good_not_ok += not_ok ? 1U : 0U, ++tally.good;
  if (share < 0.5 || share > 1.5) tally.decided += ok || not_ok ? 1U : 0U, ++tally.clear;
}

void add(const TriedSpool& tried, Tally& tally) {
  ++tally.spools;
  for (const TriedDimension& each : tried.dimensions) add(each, tally);
  for (const Defect& defect : tried.defects) {
    ++tally.injected;
    tally.named += std::ranges::count(tried.wrong_parts, defect.part) > 0 ? 1U : 0U;
    for (const std::string& part : tried.wrong_parts)
      tally.innocent += part != defect.part ? 1U : 0U;
  }
}

void print_each(const TriedSpool& tried, int seed) {
  for (const auto& [stated, truth, nps] : tried.dimensions) {
    if (!stated.is_measured || !truth) continue;
    const double unit = stated.is_angle ? 180 / std::numbers::pi : 1000;
    std::printf("  %d %-14s %-45s truth %+7.3f, said %+7.3f ± %.3f %s, allowed %.3f: %s%s\n", seed,
                stated.kind.c_str(), stated.name.c_str(), unit * *truth, unit * stated.deviation,
                2 * unit * stated.u.total(), stated.is_angle ? "deg" : "mm",
                unit * stated.tolerance, std::string(name(stated.status)).c_str(),
                std::abs(stated.deviation - *truth) > 2 * stated.u.total() ? " OUTSIDE U" : "");
  }
}

Result<int> campaign(const CampaignOptions& wanted, bool with_budget) {
  std::printf(
      "| %-28s | spools | dimensions | measured %% | with a truth | within U %% | U of lengths to "
      "1 m, "
      "mm p50 / p95 | U of face alignment, deg p50 | bad called ok | good called not ok | clear "
      "and "
      "decided %% | injected named / of (others) | U of face alignment from NPS 4, deg p50 | "
      "rotations within U, U deg p50 |\n",
      "row");
  for (const DimensionRow& row : dimension_rows()) {
    if (!wanted.wants(row.name)) continue;
    Tally tally;
    BudgetTable budget;
    for (int seed = wanted.first; seed < wanted.past_last(); ++seed) {
      const auto tried = run_dimensions(row, static_cast<std::uint32_t>(seed));
      if (!tried) return tried.error();
      if (wanted.each) print_each(*tried, seed);
      if (with_budget) budget.print_each(*tried, seed);
      add(*tried, tally);
    }
    std::printf(
        "| %-28s | %zu | %zu | %.1f | %zu | %.1f | %.2f / %.2f | %.2f | %zu of %zu | %zu of %zu | "
        "%.1f of %zu | %zu / %zu (%zu) | %.2f | %zu of %zu, %.2f |\n",
        row.name.c_str(), tally.spools, tally.stated, percent(tally.measured, tally.stated),
        tally.judged, percent(tally.inside, tally.judged), quantile(tally.length_u_mm, 0.5),
        quantile(tally.length_u_mm, 0.95), quantile(tally.alignment_u_deg, 0.5), tally.bad_ok,
        tally.bad, tally.good_not_ok, tally.good, percent(tally.decided, tally.clear), tally.clear,
        tally.named, tally.injected, tally.innocent, quantile(tally.alignment_4_u_deg, 0.5),
        tally.rotations_inside, tally.rotations, quantile(tally.rotation_u_deg, 0.5));
    if (with_budget) budget.print_usual(row.name);
    std::fflush(stdout);
  }
  return 0;
}

}  // namespace
}  // namespace spool::campaign

int main(int argc, char** argv) {
  using namespace spool::campaign;
  CLI::App app{
      "Inspects spools as shops build them and prints how often the error of a dimension is within "
      "its stated uncertainty, and how often its verdict is right."};
  CampaignOptions wanted{.seeds = 20};
  bool with_budget = false;
  spool::add_common_options(app, "spoolsight-dimension-campaign");
  add_campaign_options(app, "dimension", wanted);
  app.add_flag("--budget", with_budget,
               "What the uncertainty of each dimension is made of, and the medians of each kind");
  return spool::run_program(app, argc, argv, [&] { return campaign(wanted, with_budget); });
}
