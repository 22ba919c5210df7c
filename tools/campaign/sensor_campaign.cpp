// spoolsight-sensor-campaign: how often a scan contradicts a sensor's calibration that is wrong,
// and one that is right.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstdio>
#include <vector>

#include "tools/campaign/campaign_options.h"
#include "tools/campaign/dimension_trial.h"
#include "tools/campaign/quantile.h"

namespace spool::campaign {
namespace {

std::vector<DimensionRow> sensor_rows() {
  std::vector<DimensionRow> rows;
  for (DimensionRow row : dimension_rows()) {
    if (!row.name.ends_with(", calibrated") && row.name != "laser, uncalibrated") continue;
    if (row.single_frame) row.request.kind = ObjectKind::kRandomSpool;  // the small one is of NPS 2
    rows.push_back(row);
    for (const double error : {0.01, -0.01}) {
      DimensionRow wrong = row;
      wrong.scale_u = row.scale_u > 0.001 ? 0 : row.scale_u;  // the error itself, not one about it
      wrong.stated_scale_u = row.scale_u;
      wrong.scale_error = error;
      wrong.name += error > 0 ? ", 1 % long" : ", 1 % short";
      rows.push_back(wrong);
    }
    if (!row.single_frame) continue;
    DimensionRow bent = row;
    bent.corner_warp_m = 0.005;
    bent.name += ", bent 5 mm";
    rows.push_back(bent);
  }
  return rows;
}

struct Tally {
  std::size_t spools = 0, checked = 0, scale = 0, warp = 0, ok = 0, within = 0;
  std::vector<double> left_percent, found_u_percent;
};

void add(const TriedSpool& tried, Tally& tally) {
  ++tally.spools;
  tally.scale += tried.scale && tried.scale->is_contradicted ? 1U : 0U;
  tally.warp += tried.warp && tried.warp->is_contradicted ? 1U : 0U;
  tally.ok += tried.status == Verdict::kOk ? 1U : 0U;
  if (!tried.scale) return;
  ++tally.checked;
  tally.within +=
      std::abs(tried.true_scale - 1 - tried.scale->correction) <= 2 * tried.scale->scale_u ? 1U
                                                                                           : 0U;
  tally.left_percent.push_back(100 * tried.scale->scale_u);
  tally.found_u_percent.push_back(100 * tried.scale->found_u);
}

void print_each(const TriedSpool& tried, int seed) {
  std::printf("  %d NPS %g, %d flanges, true %.4f", seed, tried.largest_nps, tried.flanges,
              tried.true_scale);
  if (tried.scale)
    std::printf(", found %+.4f ± %.4f, statistic %.1f, chi2 %.1f of %d", tried.scale->found,
                tried.scale->found_u, tried.scale->statistic, tried.scale->chi_square,
                tried.scale->freedom);
  if (tried.warp)
    std::printf(", corner %.1f ± %.1f mm, %.1f over %.1f", 1000 * tried.warp->corner_m,
                1000 * tried.warp->corner_u_m, tried.warp->statistic, tried.warp->limit);
  std::printf("\n");
  if (!tried.scale) return;
  for (const Gauge& gauge : tried.scale->gauges)
    std::printf("      %-16s %6.1f mm: %+6.2f ± %.2f mm (piece %.2f)\n",
                std::string(name(gauge.kind)).c_str(), 1000 * gauge.nominal_m,
                1000 * (gauge.measured_m - gauge.nominal_m), 1000 * gauge.u_m,
                1000 * gauge.tolerance_u_m);
}

Result<int> campaign(const CampaignOptions& wanted) {
  std::printf(
      "| row | spools of NPS 4 and up with two flanges | with gauges | scale contradicted %% | "
      "warp "
      "contradicted %% | called ok | gauges' own u, %% p50 | scale_u left, %% p50 | truth within 2 "
      "scale_u, %% |\n");
  for (const DimensionRow& row : sensor_rows()) {
    if (!wanted.wants(row.name)) continue;
    Tally tally;
    for (int seed = wanted.first; seed < wanted.past_last(); ++seed) {
      const auto tried = run_dimensions(row, static_cast<std::uint32_t>(seed));
      if (!tried) return tried.error();
      if (tried->largest_nps < 4 || tried->flanges < 2) continue;
      if (wanted.each) print_each(*tried, seed);
      add(*tried, tally);
    }
    std::printf("| %s | %zu | %zu | %.1f | %.1f | %zu | %.2f | %.2f | %.1f |\n", row.name.c_str(),
                tally.spools, tally.checked, percent(tally.scale, tally.spools),
                percent(tally.warp, tally.spools), tally.ok, quantile(tally.found_u_percent, 0.5),
                quantile(tally.left_percent, 0.5), percent(tally.within, tally.checked));
    std::fflush(stdout);
  }
  return 0;
}

}  // namespace
}  // namespace spool::campaign

int main(int argc, char** argv) {
  return spool::campaign::campaign_main(
      argc, argv, "spoolsight-sensor-campaign",
      "Inspects spools scanned by sensors whose calibration is right or wrong and prints how often "
      "the scan contradicts it.",
      "sensor", spool::campaign::campaign, {.seeds = 20});
}
