// spoolsight-part-campaign: how far from the truth the mean deviation of each part is after three
// seconds of a hand-held camera at 1.0 m or less.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstdio>
#include <vector>

#include "tools/campaign/campaign_options.h"
#include "tools/campaign/part_trial.h"
#include "tools/campaign/quantile.h"

namespace spool::campaign {
namespace {

constexpr double kReachM = 0.0005;

struct Tally {
  std::size_t runs = 0, unseen = 0, parts = 0, within = 0, inside_u = 0;
  std::vector<double> off_mm, moved_off_mm, u_mm, seen;
};

void add(const std::vector<TriedPart>& tried, Tally& tally) {
  ++tally.runs;
  for (const TriedPart& part : tried) {
    const double off = std::abs(part.mean_m - part.truth_m);
    ++tally.parts;
    tally.within += off <= kReachM ? 1U : 0U;
    tally.inside_u += off <= part.u_m ? 1U : 0U;
    tally.off_mm.push_back(1000 * off);
    if (part.is_off) tally.moved_off_mm.push_back(1000 * off);
    tally.u_mm.push_back(1000 * part.u_m);
    tally.seen.push_back(100 * part.coverage);
  }
}

Result<int> campaign(const CampaignOptions& wanted) {
  std::printf(
      "| %-24s | runs | parts | mm p50 / p95 | of the one moved p50 / max | within 0.5 mm %% "
      "| within U %% | U mm p50 / p95 | known %% p50 |\n",
      "look");
  for (const PartRow& row : part_rows()) {
    if (!wanted.wants(row.name)) continue;
    Tally tally;
    for (int seed = wanted.first; seed < wanted.past_last(); ++seed) {
      const auto tried = run_part(row, static_cast<std::uint32_t>(seed));
      if (!tried) {
        std::fprintf(stderr, "seed %d: %s\n", seed, tried.error().message.c_str());
        ++tally.unseen;
        continue;
      }
      if (wanted.each)
        for (const TriedPart& part : *tried)
          std::printf("  %d %-12s%s truth %+6.2f mm, said %+6.2f ± %.2f mm, %3.0f %% known\n", seed,
                      part.name.c_str(), part.is_off ? " MOVED" : "      ", 1000 * part.truth_m,
                      1000 * part.mean_m, 1000 * part.u_m, 100 * part.coverage);
      add(*tried, tally);
    }
    std::printf(
        "| %-24s | %4zu | %5zu | %5.2f / %5.2f | %11.2f / %5.2f | %15.1f | %10.1f | %5.2f / "
        "%5.2f | %11.0f |\n",
        row.name.c_str(), tally.runs, tally.parts, quantile(tally.off_mm, 0.5),
        quantile(tally.off_mm, 0.95), quantile(tally.moved_off_mm, 0.5),
        quantile(tally.moved_off_mm, 1), percent(tally.within, tally.parts),
        percent(tally.inside_u, tally.parts), quantile(tally.u_mm, 0.5), quantile(tally.u_mm, 0.95),
        quantile(tally.seen, 0.5));
    std::fflush(stdout);
  }
  return 0;
}

}  // namespace
}  // namespace spool::campaign

int main(int argc, char** argv) {
  return spool::campaign::campaign_main(
      argc, argv, "spoolsight-part-campaign",
      "Looks at spools of which one part stands a little off and prints how far the mean deviation "
      "of each part is from the truth.",
      "part", spool::campaign::campaign);
}
