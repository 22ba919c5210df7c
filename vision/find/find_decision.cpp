// From poses that were weighed to what may be said: found, found in several ways, or not found.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/find/find_decision.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "vision/find/symmetry.h"

namespace spool {
namespace {

// A pose is believed where the scan near it is the design (of what it explains, clutter that
// happens to lie there, three standard deviations of its count included, is a fifth at most), where
// that is a third of the design or nearly, and where it holds the design in place.
constexpr double kMostChance = 0.20;
constexpr double kLeastCoverage = 0.30;
// Two poses are told apart by the points that only one explains. Where another comes this near, the
// scan has to show nearly half of the design for the difference to be the design's.
constexpr double kRival = 0.80;
constexpr double kCoverageWithRival = 0.45;
// This near, it is no difference at all: one point in fifty, or three standard deviations of a
// count of points that are not independent.
constexpr double kAlike = 0.02;
// What the camera saw through is not there: half of it may be missing or elsewhere, not more. Nor
// can what lies behind floor or walls have been scanned, but a spool may go through a wall.
constexpr double kLeastThere = 0.5, kMostBehind = 0.5;
constexpr std::size_t kMostOthers = 8;  // more ways than that is no finding
// Two pipes that meet lie about in any shop, most at a right angle, and many with a flange on one
// of them: a single length that agrees by chance is then all that speaks for the design. Where not
// most of it shows, two lengths or angles have to agree. Three runs of it are enough (the length of
// the middle one, and how the outer ones stand to each other), each with so much of what is
// explained and so many points.
constexpr int kLeastRuns = 3, kLeastAgreeing = 2;
constexpr double kMostOfIt = 0.70;
constexpr double kOfRun = 0.05;
constexpr double kRunPoints = 10;

bool is_pure(const PoseEvidence& pose) {
  return pose.chance + 3 * std::sqrt(pose.chance) <=
         kMostChance * static_cast<double>(pose.explained);
}

bool is_as_good(const PoseEvidence& other, const PoseEvidence& best) {
  const double less = best.excess() - other.excess();
  return less <=
         std::max(kAlike * best.excess(), 3 * std::sqrt(std::max(1.0, 0.05 * best.excess())));
}

// Runs of the design with points on them, and how many of the design's lengths these bear out: on
// each as many as there are stops beyond the first. Of a run that is no line of joints nobody knows
// where it stops; its own length is taken to be one.
struct Runs {
  int in_sight = 0, lengths = 0;
};

Runs runs_of(const FinderModel& model, const PoseEvidence& pose) {
  std::vector<double> on(static_cast<std::size_t>(model.runs.count), 0);
  for (std::size_t p = 0; p < model.runs.of_part.size() && p < pose.per_part.size(); ++p)
    if (model.runs.of_part[p] >= 0)
      on[static_cast<std::size_t>(model.runs.of_part[p])] += pose.per_part[p];
  const double least = std::max(kRunPoints, kOfRun * static_cast<double>(pose.explained));
  std::vector<int> stops(on.size(), 0);
  for (std::size_t p = 0; p < model.runs.at.size() && p < pose.shows_stop.size(); ++p)
    for (const int run : model.runs.at[p])
      stops[static_cast<std::size_t>(run)] += pose.shows_stop[p];
  Runs runs;
  for (std::size_t run = 0; run < on.size(); ++run) {
    if (on[run] < least) continue;
    ++runs.in_sight;
    const bool is_line = !model.runs.lines[run].direction.isZero();
    runs.lengths += is_line ? std::max(0, stops[run] - 1) : 1;
  }
  return runs;
}

// Whether more of the design agrees than of any two pipes that meet.
bool is_more_than_two_pipes(const FinderModel& model, const PoseEvidence& pose) {
  const Runs runs = runs_of(model, pose);
  if (runs.in_sight >= kLeastRuns || pose.coverage >= kMostOfIt) return true;
  const bool is_nearly_half = pose.coverage >= kCoverageWithRival;
  const bool do_agree = runs.lengths >= kLeastAgreeing;
  // Of a design of one run or two there is no more to be had. Parts that no joints put in line, a
  // plate and its peg, are no pipes.
  if (model.runs.count < kLeastRuns) {
    const bool are_lines =
        std::any_of(model.runs.lines.begin(), model.runs.lines.end(),
                    [](const RunLine& line) { return !line.direction.isZero(); });
    if (runs.in_sight != model.runs.count) return !are_lines && is_nearly_half;
    return model.runs.count <= 1 || do_agree || is_nearly_half;
  }
  return do_agree && is_nearly_half;
}

std::string percent(double share) { return std::to_string(std::lround(100 * share)) + " %"; }

}  // namespace

FindDecision decide(const FinderModel& model, const std::vector<PoseEvidence>& poses) {
  FindDecision decision;
  if (poses.empty()) {
    decision.reason =
        "The design was not found in the scan; scan more of the spool, or pick three pairs.";
    return decision;
  }
  const PoseEvidence& best = poses.front();
  if (best.coverage < kLeastCoverage || !is_pure(best)) {
    decision.reason = "The design was not found in the scan: what fits best explains " +
                      percent(best.coverage) +
                      " of its surface and lies among clutter; scan more of the spool, or pick "
                      "three pairs.";
    return decision;
  }
  if (best.sighted.share_there() < kLeastThere) {
    decision.reason =
        "The design was not found in the scan: where what fits best has most of its steel, the "
        "camera saw what lies behind; look from another side, or pick three pairs.";
    return decision;
  }
  if (best.behind > kMostBehind) {
    decision.reason =
        "The design was not found in the scan: what fits best would lie mostly behind floor or "
        "walls; scan more of the spool, or pick three pairs.";
    return decision;
  }
  if (best.free_motions > model.free_motions) {
    decision.reason =
        "The design was not found in the scan: what fits best does not hold it in place, as a "
        "single pipe does not; scan an end, a branch or a flange as well, or pick three pairs.";
    return decision;
  }
  if (!is_more_than_two_pipes(model, best)) {
    decision.reason =
        "The design was not found in the scan: what fits best is no more than two pipes that meet, "
        "as many do; scan more of the spool, or pick three pairs.";
    return decision;
  }
  // Elsewhere, or only turned by a symmetry: that is the same place, seen in another way.
  double rival = 0;
  std::size_t elsewhere = 0;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    const bool is_other = is_as_good(poses[i], best);
    if (!is_other && poses[i].excess() <= kRival * best.excess()) break;  // best first
    const bool is_same_place =
        lays_on_itself(model, poses[i].T_design_scan * best.T_design_scan.inverse());
    if (!is_same_place) {
      rival = std::max(rival, poses[i].excess() / best.excess());
      elsewhere += is_other ? 1U : 0U;
    }
    if (is_other && (!is_same_place || decision.others.size() < kMostOthers))
      decision.others.push_back(i);
  }
  if (elsewhere > kMostOthers || (rival > kRival && best.coverage < kCoverageWithRival)) {
    decision.reason =
        "The design was not found in the scan: what fits lies in several places about as well; "
        "scan more of the spool, or pick three pairs.";
    decision.others.clear();
    return decision;
  }
  decision.found = true;
  return decision;
}

}  // namespace spool
