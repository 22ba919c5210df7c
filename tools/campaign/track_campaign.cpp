// spoolsight-track-campaign: how well the tracker follows hand-held sequences of known truth.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/common/cli.h"
#include "tools/campaign/campaign_options.h"
#include "tools/campaign/quantile.h"
#include "tools/campaign/track_trial.h"

namespace spool::campaign {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kReachM = 0.003, kReachRad = 0.3 * kDegree;  // what `good` claims
constexpr double kWrongM = 0.03, kWrongRad = 3 * kDegree;     // another place altogether

struct Wanted : CampaignOptions {
  int frames = 0;  // at most; 0: all
};

struct Tally {
  std::size_t seen = 0, lost = 0, good = 0, within = 0, good_and_within = 0, wrong_good = 0;
  std::vector<double> off_mm, off_deg, fit_ms, fuse_ms, prepare_ms, end_mm, back_mm, back_s;
  std::size_t cells = 0;
};

bool is_within(const TrackedFrame& frame) {
  return frame.off_m <= kReachM && frame.off_rad <= kReachRad;
}

// Seconds from `event_s` to the first good pose that is no other place, or nothing found: 99.
double seconds_back(const TrackRun& run, double event_s) {
  for (const TrackedFrame& frame : run.frames)
    if (frame.seconds >= event_s && frame.quality == PoseQuality::kGood && frame.off_m < kWrongM)
      return frame.seconds - event_s;
  return 99;
}

void add(const TrackRow& row, const TrackRun& run, Tally& tally) {
  const double event_s = std::max(row.covered_to_s, row.jump_at_s);
  for (const TrackedFrame& frame : run.frames) {
    const bool is_tracked = frame.quality != PoseQuality::kLost;
    const bool is_good = frame.quality == PoseQuality::kGood;
    tally.wrong_good += is_good && (frame.off_m > kWrongM || frame.off_rad > kWrongRad) ? 1U : 0U;
    tally.cells = std::max(tally.cells, frame.cells);
    tally.fit_ms.push_back(frame.fit_ms);
    tally.fuse_ms.push_back(frame.fuse_ms);
    tally.prepare_ms.push_back(frame.prepare_ms);
    // The second after an event is the way back, which has a column of its own.
    const bool is_event = event_s >= 0 && frame.seconds >= event_s && frame.seconds < event_s + 1;
    if (frame.is_covered || is_event) continue;
    ++tally.seen;
    tally.lost += is_tracked ? 0U : 1U;
    if (!is_tracked) continue;
    tally.good += is_good ? 1U : 0U;
    tally.within += is_within(frame) ? 1U : 0U;
    tally.good_and_within += is_good && is_within(frame) ? 1U : 0U;
    tally.off_mm.push_back(1000 * frame.off_m);
    tally.off_deg.push_back(frame.off_rad / kDegree);
  }
  if (event_s >= 0) tally.back_s.push_back(seconds_back(run, event_s));
  if (row.seconds > 0 || run.frames.empty()) return;
  // The far end is half way; the last frame is the first place again.
  tally.end_mm.push_back(1000 * run.frames[run.frames.size() / 2].off_m);
  tally.back_mm.push_back(1000 * run.frames.back().off_m);
}

void print_frames(const TrackRun& run) {
  for (const TrackedFrame& frame : run.frames)
    std::printf(
        "  %7.3f s %-4s off %7.2f mm %6.3f deg, sigma %6.2f mm %6.3f deg, score %.2f, "
        "fit %5.1f ms, fuse %5.1f ms, %zu cells; %s\n",
        frame.seconds, std::string(name(frame.quality)).c_str(), 1000 * frame.off_m,
        frame.off_rad / kDegree, 1000 * frame.sigma_m, frame.sigma_rad / kDegree, frame.score,
        frame.fit_ms, frame.fuse_ms, frame.cells, frame.reason.c_str());
}

Result<int> campaign(const Wanted& wanted) {
  std::printf(
      "| %-14s | frames | lost %% | mm p50 / p95 | deg p95 | good in reach %% | reach marked good "
      "%% "
      "| wrong good | back s max | far end / first end mm | prepare / fit / fuse ms (p99 fit) | "
      "cells "
      "|\n",
      "sequence");
  for (const TrackRow& row : track_rows()) {
    if (!wanted.wants(row.name)) continue;
    Tally tally;
    for (int seed = wanted.first; seed < wanted.past_last(); ++seed) {
      const TrackRun run = run_track(row, static_cast<std::uint32_t>(seed), wanted.frames);
      if (wanted.each) print_frames(run);
      add(row, run, tally);
    }
    std::printf(
        "| %-14s | %6zu | %6.2f | %5.2f / %5.2f | %7.3f | %15.1f | %19.1f | %10zu | %10.2f | %9.2f "
        "/ "
        "%9.2f | %4.1f / %4.1f / %4.1f (%5.1f) | %6zu |\n",
        row.name.c_str(), tally.seen, percent(tally.lost, tally.seen), quantile(tally.off_mm, 0.5),
        quantile(tally.off_mm, 0.95), quantile(tally.off_deg, 0.95),
        percent(tally.good_and_within, tally.good), percent(tally.good_and_within, tally.within),
        tally.wrong_good, quantile(tally.back_s, 1), quantile(tally.end_mm, 1),
        quantile(tally.back_mm, 1), quantile(tally.prepare_ms, 0.5), quantile(tally.fit_ms, 0.5),
        quantile(tally.fuse_ms, 0.5), quantile(tally.fit_ms, 0.99), tally.cells);
    std::fflush(stdout);
  }
  return 0;
}

}  // namespace
}  // namespace spool::campaign

int main(int argc, char** argv) {
  CLI::App app{"Tracks hand-held sequences of known truth and prints how far off the poses were."};
  spool::campaign::Wanted wanted;
  spool::add_common_options(app, "spoolsight-track-campaign");
  spool::campaign::add_campaign_options(app, "frame", wanted);
  app.add_option("--frames", wanted.frames, "At most so many frames of each; 0: all")
      ->capture_default_str()
      ->type_name("N");
  return spool::run_program(app, argc, argv, [&] { return spool::campaign::campaign(wanted); });
}
