// Where a design is in a scan: draw pairs, refine what fits, weigh it, decide.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/find/finder.h"

#include <algorithm>
#include <cmath>

#include "vision/core/parallel.h"
#include "vision/find/field_icp.h"
#include "vision/find/find_decision.h"
#include "vision/find/find_scene.h"
#include "vision/find/pose_search.h"

namespace spool {
namespace {

constexpr std::size_t kLeastPoints = 60;
constexpr int kMostRounds = 10;
constexpr std::size_t kPairsPerRound = 192;
constexpr std::size_t kRefinedPerRound = 8;
// A pose that explains more than the best so far would be drawn at least as often; after seven
// draws of the best, that it was never drawn has a chance of e^-7, under one in a thousand.
constexpr int kEnoughHits = 7;

constexpr const char* kStopped = "The search was stopped before it was done.";

// The most promising hypotheses, one of each chunk of pairs, so that each is an independent draw.
std::vector<PoseHypothesis> to_refine(const std::vector<PoseHypothesis>& hypotheses) {
  std::vector<PoseHypothesis> some;
  for (const PoseHypothesis& hypothesis : hypotheses) {
    const bool known = std::any_of(some.begin(), some.end(), [&](const PoseHypothesis& other) {
      return other.chunk == hypothesis.chunk;
    });
    if (!known) some.push_back(hypothesis);
    if (some.size() == kRefinedPerRound) break;
  }
  return some;
}

// Counts `pose` as one more draw of a pose that is known, or adds it.
void add_pose(const FinderModel& model, PoseEvidence pose, std::vector<PoseEvidence>& poses) {
  for (PoseEvidence& known : poses) {
    if (displacement_m(model, known.T_design_scan.cast<float>(), pose.T_design_scan.cast<float>()) >
        model.same_m())
      continue;
    pose.hits = known.hits + 1;
    if (pose.excess() > known.excess()) known = pose;
    known.hits = pose.hits;
    return;
  }
  pose.hits = 1;
  poses.push_back(pose);
}

void sort_poses(std::vector<PoseEvidence>& poses) {
  std::stable_sort(poses.begin(), poses.end(), [](const PoseEvidence& a, const PoseEvidence& b) {
    return a.excess() > b.excess();
  });
}

std::vector<PoseEvidence> refine_and_weigh(const FinderModel& model, const FindScene& scene,
                                           const std::vector<Eigen::Isometry3f>& rough,
                                           const FieldIcpOptions& refining, const Watch& watch) {
  std::vector<PoseEvidence> weighed(rough.size());
  parallel_chunks(rough.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end && !watch.cancelled(); ++i) {
      const FieldIcpResult icp =
          refine_on_field(scene.points(), model.samples, model.field, rough[i], refining);
      weighed[i] = weigh_pose(model, scene, icp.T_design_scan, refining.end_gate_m);
    }
  });
  return weighed;
}

// What a design that resembles itself could be mistaken for is tried on purpose.
std::vector<Eigen::Isometry3f> rivals(const FinderModel& model, const PoseEvidence& pose) {
  std::vector<Eigen::Isometry3f> rough;
  for (const SelfLikeness& alike : model.alike)
    rough.push_back((alike.motion * pose.T_design_scan).cast<float>());
  return rough;
}

}  // namespace

FindResult find_design(const FinderModel& model, std::span<const Eigen::Vector3f> scan,
                       const FindOptions& options, const Watch& watch) {
  FindResult result;
  if (model.levels.empty()) {
    result.reason =
        "The design has no surface to go by; export it with triangles or with normals, or pick "
        "three pairs.";
    return result;
  }
  // A scan too sparse to tell its own noise is no noisier for that.
  const double noise = std::min(options.noise_m, 0.003 * model.size_m);
  FindScene scene(model, scan, noise, watch, options.sight);
  result.scan_points = scene.finite();
  result.was_thinned = scene.was_thinned();
  result.thinned_to = scene.points().size();
  result.planes = static_cast<int>(scene.planes().size());
  if (watch.cancelled()) {
    result.reason = kStopped;
    return result;
  }
  if (scene.points().size() < kLeastPoints) {
    result.reason =
        "The scan has too few points off floor and walls to find anything in; scan the spool "
        "again.";
    return result;
  }
  const double gate = std::max(3 * noise, 0.002 * model.size_m);
  const FieldIcpOptions refining{
      .iterations = 15, .start_gate_m = 1.3 * model.rough_m(), .end_gate_m = gate};
  std::vector<PoseEvidence>& poses = result.tried;
  FindDecision decision = decide(model, poses);
  while (result.rounds < kMostRounds && !watch.cancelled()) {
    watch.report("find", static_cast<double>(result.rounds) / kMostRounds);
    for (std::size_t level = 0; level < model.levels.size(); ++level) {
      const std::uint64_t draw =
          static_cast<std::uint64_t>(result.rounds) * model.levels.size() + level;
      const std::vector<PoseHypothesis> drawn = to_refine(search_poses(
          model.levels[level].pairs, scene.elements(level, watch), scene.occupancy(), model.probes,
          {.pairs = kPairsPerRound, .seed = options.seed * 1009 + draw}, watch));
      std::vector<Eigen::Isometry3f> rough;
      for (const PoseHypothesis& hypothesis : drawn) rough.push_back(hypothesis.T_design_scan);
      for (PoseEvidence& pose : refine_and_weigh(model, scene, rough, refining, watch))
        add_pose(model, std::move(pose), poses);
    }
    ++result.rounds;
    sort_poses(poses);
    decision = decide(model, poses);
    // With the last round, also what was drawn less often has to stand up to its rivals.
    if (!decision.found || (poses.front().hits < kEnoughHits && result.rounds < kMostRounds))
      continue;
    for (PoseEvidence& pose :
         refine_and_weigh(model, scene, rivals(model, poses.front()), refining, watch))
      add_pose(model, std::move(pose), poses);
    sort_poses(poses);
    decision = decide(model, poses);
    if (decision.found) break;
  }
  if (watch.cancelled()) {
    result.reason = kStopped;
    return result;
  }
  result.found = decision.found;
  result.reason = decision.reason;
  if (!poses.empty()) result.best = poses.front();
  for (const std::size_t other : decision.others) result.others.push_back(poses[other]);
  return result;
}

}  // namespace spool
