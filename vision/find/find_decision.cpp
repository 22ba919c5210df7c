// From poses that were weighed to what may be said: found, found in several ways, or not found.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/find/find_decision.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

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
constexpr std::size_t kMostOthers = 8;  // more ways than that is no finding
// Another pose is of another piece where this share of the best's points is explained by it alone.
constexpr double kOtherPiece = 0.05;
constexpr double kLeastOfBest = 0.3;
// Of a part's points: where a pose explains less of what another explains, the part is elsewhere.
constexpr double kPartThere = 0.85;
constexpr std::uint32_t kPartPoints = 10;

bool is_pure(const PoseEvidence& pose) {
  return pose.chance + 3 * std::sqrt(pose.chance) <=
         kMostChance * static_cast<double>(pose.explained);
}

bool is_as_good(const PoseEvidence& other, const PoseEvidence& best) {
  const double less = best.excess() - other.excess();
  return less <=
         std::max(kAlike * best.excess(), 3 * std::sqrt(std::max(1.0, 0.05 * best.excess())));
}

// Explained by `other` and not by `best`.
std::size_t only_by(const PoseEvidence& other, const PoseEvidence& best) {
  std::vector<std::uint32_t> only;
  std::set_difference(other.points.begin(), other.points.end(), best.points.begin(),
                      best.points.end(), std::back_inserter(only));
  return only.size();
}

// Poses that each explain another piece of the scan, the best among them: the spool is not as
// designed between the pieces.
std::vector<std::size_t> pieces(const FinderModel& model, const std::vector<PoseEvidence>& poses) {
  std::vector<std::size_t> some(1, 0);
  const PoseEvidence& best = poses.front();
  for (std::size_t i = 1; i < poses.size(); ++i) {
    const PoseEvidence& other = poses[i];
    if (other.coverage < kLeastCoverage || !is_pure(other) ||
        other.free_motions > model.free_motions || other.excess() < kLeastOfBest * best.excess())
      continue;
    if (static_cast<double>(only_by(other, best)) > kOtherPiece * best.excess()) some.push_back(i);
  }
  return some;
}

// The pose that is meant where there are several pieces: the one that takes the fewest joints to be
// wrong, else the one that holds the datum, which all else is measured from, else the best.
std::size_t meant(const FinderModel& model, const std::vector<PoseEvidence>& poses) {
  const std::vector<std::size_t> some = pieces(model, poses);
  if (some.size() == 1) return 0;
  // A part is where a pose has it if the pose explains most of what any explains there.
  std::vector<std::uint32_t> most(model.parts, 0);
  for (const std::size_t i : some)
    for (std::size_t p = 0; p < model.parts; ++p) most[p] = std::max(most[p], poses[i].per_part[p]);
  const auto is_there = [&](std::size_t pose, int part) {
    const auto p = static_cast<std::size_t>(part);
    return most[p] < kPartPoints ||
           static_cast<double>(poses[pose].per_part[p]) > kPartThere * most[p];
  };
  std::size_t meant = 0;
  std::array<int, 2> least{};
  for (const std::size_t i : some) {
    std::array<int, 2> cost{0, 0};
    for (const auto& [a, b] : model.joints) cost[0] += is_there(i, a) != is_there(i, b) ? 1 : 0;
    for (const int part : model.datums) cost[1] += is_there(i, part) ? 0 : 1;
    if (i == 0 || cost < least) {
      least = cost;
      meant = i;
    }
  }
  return meant;
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
  if (best.free_motions > model.free_motions) {
    decision.reason =
        "The design was not found in the scan: what fits best does not hold it in place, as a "
        "single pipe does not; scan an end, a branch or a flange as well, or pick three pairs.";
    return decision;
  }
  decision.best = meant(model, poses);
  double rival = 0;
  for (std::size_t i = 1; i < poses.size() && decision.best == 0; ++i) {
    rival = std::max(rival, poses[i].excess() / best.excess());
    if (is_as_good(poses[i], best)) decision.others.push_back(i);
  }
  if (decision.others.size() > kMostOthers ||
      (rival > kRival && best.coverage < kCoverageWithRival)) {
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
