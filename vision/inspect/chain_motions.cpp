// Where a branch of the spool may be instead.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/inspect/chain_motions.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "vision/find/pose_search.h"

namespace spool {
namespace {

// As far as a pipe is tried too long or too short: by a share of the size, and by what a wrong line
// of a tape or of a cut list comes to (m).
constexpr double kSlide = 0.06, kSlideLeast = 0.15;
constexpr double kSlideStep = 0.5;  // of what a tried motion may miss
constexpr int kTurns = 180;         // of two degrees
constexpr int kSpins = 90;          // of four degrees
constexpr float kRoughGain = 0.2F;  // of a piece's surface that a motion has to win

// `move` moves the design; is the moved surface where the scan has points?
float met(const Eigen::Isometry3f& move, const Occupancy& occupancy, const PieceShape& shape) {
  return pose_score(move.inverse(), occupancy, shape.probes);
}

// What lies where the pipe would go on by `by_m`, as a share of the piece's samples.
float end_met(const MovedBranch& moved, double by_m, const Occupancy& occupancy) {
  std::size_t on = 0;
  for (const PipeEndPoint& each : moved.end) {
    if (double{each.along} > by_m) break;  // nearest first
    on += occupancy.is_near(each.point) ? 1U : 0U;
  }
  return static_cast<float>(on) / static_cast<float>(moved.shape.samples.size());
}

Eigen::Isometry3f turn_about(const JointFrame& frame, float angle) {
  Eigen::Isometry3f move = Eigen::Isometry3f::Identity();
  move.linear() = Eigen::AngleAxisf(angle, frame.outward).toRotationMatrix();
  move.translation() = frame.point - move.linear() * frame.point;
  return move;
}

}  // namespace

void keep_promising(std::vector<ChainMotion>& motions, std::size_t count) {
  std::stable_sort(motions.begin(), motions.end(),
                   [](const ChainMotion& a, const ChainMotion& b) { return a.gain > b.gain; });
  if (motions.size() > count) motions.resize(count);
}

std::vector<Eigen::Isometry3f> hung_at(const JointFrame& own, const JointFrame& frame) {
  Eigen::Isometry3f carry = Eigen::Isometry3f::Identity();
  carry.linear() =
      Eigen::Quaternionf::FromTwoVectors(own.outward, frame.outward).toRotationMatrix();
  carry.translation() = frame.point - carry.linear() * own.point;
  std::vector<Eigen::Isometry3f> spins;
  spins.reserve(kSpins);
  for (int i = 0; i < kSpins; ++i)
    spins.push_back(
        turn_about(frame, 2 * std::numbers::pi_v<float> * static_cast<float>(i) / kSpins) * carry);
  return spins;
}

std::vector<ChainMotion> chain_motions(const MovedBranch& moved, const Occupancy& occupancy,
                                       double size_m) {
  const JointBranch& branch = moved.branch;
  const PieceShape& shape = moved.shape;
  const float here = met(Eigen::Isometry3f::Identity(), occupancy, shape);
  std::vector<ChainMotion> all;
  if (here > 1 - kRoughGain && moved.end.empty()) return all;
  constexpr float kPi = std::numbers::pi_v<float>;
  std::vector<ChainMotion> some;
  const auto take = [&](PieceFault fault, const Eigen::Isometry3f& move, int hangs_at = -1,
                        float more = 0) {
    const float gain = met(move, occupancy, shape) + more - here;
    if (gain > kRoughGain) some.push_back({moved.place, fault, move, gain, hangs_at});
  };
  const auto keep = [&](std::size_t count) {
    keep_promising(some, count);
    all.insert(all.end(), some.begin(), some.end());
    some.clear();
  };
  for (int i = 1; i < kTurns && branch.turns; ++i)
    take(PieceFault::kTurned, turn_about(branch.frame, 2 * kPi * static_cast<float>(i) / kTurns));
  keep(3);
  const double farthest = std::max(kSlide * size_m, kSlideLeast);
  const int slides = static_cast<int>(std::ceil(farthest / (kSlideStep * kRoughMotion * size_m)));
  for (int i = -slides; i <= slides && branch.turns; ++i) {
    const double by = farthest * i / slides;
    if (i == 0 || -by > branch.most_shorter_m) continue;
    Eigen::Isometry3f move = Eigen::Isometry3f::Identity();
    move.translation() = static_cast<float>(by) * branch.frame.outward;
    take(i > 0 ? PieceFault::kTooLong : PieceFault::kTooShort, move, -1,
         end_met(moved, by, occupancy));
  }
  keep(3);
  for (const auto& [frame, joint] : branch.others)
    for (const Eigen::Isometry3f& move : hung_at(branch.frame, frame))
      take(PieceFault::kExchanged, move, joint);
  keep(3);
  return all;
}

}  // namespace spool
