// spoolsight-live-campaign: how well the overlay stays on spools as built, on hand-held sequences
// of known truth.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

#include "tools/campaign/campaign_options.h"
#include "tools/campaign/live_trial.h"
#include "tools/campaign/quantile.h"

namespace spool::campaign {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kReachM = 0.003, kReachRad = 0.3 * kDegree;  // what `good` claims
constexpr double kWrongM = 0.03, kWrongRad = 3 * kDegree;     // another place altogether
constexpr double kSettling_s = 1;  // after the picks, and after a bump, are counted apart

bool is_within(const LiveFrame& frame) {
  return frame.off_m <= kReachM && frame.off_rad <= kReachRad;
}

// Seconds from the bump until the pose is right again and stays so for a third of a second.
double seconds_back(const std::vector<LiveFrame>& frames, double bump_s) {
  constexpr int kOnEnd = 10;
  int right = 0;
  for (const LiveFrame& frame : frames) {
    if (frame.seconds < bump_s) continue;
    const bool is_right = frame.quality != TrackQuality::kLost && frame.off_m < 2 * kReachM &&
                          frame.off_rad < 2 * kReachRad;
    right = is_right ? right + 1 : 0;
    if (right == kOnEnd) return frame.seconds - bump_s - (kOnEnd - 1) / 30.0;
  }
  return 99;
}

struct Tally {
  std::size_t runs = 0, unseen = 0, counted = 0, lost = 0, good = 0, within = 0, good_within = 0,
              wrong_good = 0, inside_u = 0, tracked = 0;
  std::vector<double> off_mm, off_deg, back_s, wall_ms;
};

void add(const LiveRow& row, const std::vector<LiveFrame>& frames, Tally& tally) {
  ++tally.runs;
  for (const LiveFrame& frame : frames) {
    const bool is_good = frame.quality == TrackQuality::kGood;
    tally.wall_ms.push_back(frame.wall_ms);
    tally.wrong_good += is_good && (frame.off_m > kWrongM || frame.off_rad > kWrongRad) ? 1U : 0U;
    const bool settles =
        frame.seconds < kSettling_s || (row.bump_at_s >= 0 && frame.seconds >= row.bump_at_s &&
                                        frame.seconds < row.bump_at_s + kSettling_s);
    if (settles) continue;
    ++tally.counted;
    if (frame.quality == TrackQuality::kLost) {
      ++tally.lost;
      continue;
    }
    ++tally.tracked;
    tally.off_mm.push_back(1000 * frame.off_m);
    tally.off_deg.push_back(frame.off_rad / kDegree);
    tally.good += is_good ? 1U : 0U;
    tally.within += is_within(frame) ? 1U : 0U;
    tally.good_within += is_good && is_within(frame) ? 1U : 0U;
    tally.inside_u += frame.off_m <= frame.u_m ? 1U : 0U;
  }
  if (row.bump_at_s >= 0) tally.back_s.push_back(seconds_back(frames, row.bump_at_s));
}

void print_frames(const std::vector<LiveFrame>& frames) {
  for (const LiveFrame& frame : frames)
    std::printf(
        "  %6.3f s %-4s off %7.2f mm %6.3f deg, U %5.2f mm %6.3f deg, camera %5.2f mm %6.3f deg, "
        "design %5.2f mm %6.3f deg, %5.1f ms%s %s\n",
        frame.seconds, std::string(name(frame.quality)).c_str(), 1000 * frame.off_m,
        frame.off_rad / kDegree, 1000 * frame.u_m, frame.u_rad / kDegree, 1000 * frame.camera_off_m,
        frame.camera_off_rad / kDegree, 1000 * frame.place_off_m, frame.place_off_rad / kDegree,
        frame.wall_ms, frame.was_moved ? " MOVED" : "", frame.hint.c_str());
}

Result<int> campaign(const CampaignOptions& wanted) {
  std::printf(
      "| %-24s | runs | lost %% | mm p50 / p95 | deg p95 | good in reach %% | in reach marked good "
      "%% "
      "| wrong good | within U %% | back s median / max | ms p50 / p99 |\n",
      "sequence");
  for (const LiveRow& row : live_rows()) {
    if (!wanted.wants(row.name)) continue;
    Tally tally;
    for (int seed = wanted.first; seed < wanted.past_last(); ++seed) {
      const auto frames = run_live(row, static_cast<std::uint32_t>(seed));
      if (!frames) {
        std::fprintf(stderr, "seed %d: %s\n", seed, frames.error().message.c_str());
        ++tally.unseen;
        continue;
      }
      if (wanted.each) print_frames(*frames);
      add(row, *frames, tally);
    }
    std::printf(
        "| %-24s | %4zu | %6.2f | %5.2f / %5.2f | %7.3f | %15.1f | %22.1f | %10zu | %10.1f | %8.2f "
        "/ "
        "%8.2f | %4.1f / %4.1f |\n",
        row.name.c_str(), tally.runs, percent(tally.lost, tally.counted),
        quantile(tally.off_mm, 0.5), quantile(tally.off_mm, 0.95), quantile(tally.off_deg, 0.95),
        percent(tally.good_within, tally.good), percent(tally.good_within, tally.within),
        tally.wrong_good, percent(tally.inside_u, tally.tracked), quantile(tally.back_s, 0.5),
        quantile(tally.back_s, 1), quantile(tally.wall_ms, 0.5), quantile(tally.wall_ms, 0.99));
    std::fflush(stdout);
  }
  return 0;
}

}  // namespace
}  // namespace spool::campaign

int main(int argc, char** argv) {
  return spool::campaign::campaign_main(
      argc, argv, "spoolsight-live-campaign",
      "Follows spools as built on hand-held sequences of known truth and prints how far off the "
      "camera's pose in "
      "the datum's frame was.",
      "frame", spool::campaign::campaign);
}
