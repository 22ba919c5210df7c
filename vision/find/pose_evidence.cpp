// What speaks for a pose: the scan points it explains, and how much of the design they vouch for.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/find/pose_evidence.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Geometry>

#include "vision/align/weak_directions.h"
#include "vision/core/median.h"
#include "vision/scan/point_spacing.h"

namespace spool {
namespace {

constexpr std::size_t kSpacingPlaces = 300;
constexpr std::size_t kSightedPlaces = 600;
constexpr double kSightGate = 0.01;  // of the size: a pose that was refined is off by less

// As far apart as the scan's points are where it is explained (m): the median distance of an
// explained point to its fourth neighbour in the whole scan. Were it the explained points' own
// distance, a few chance hits far apart would vouch for all between them.
double spacing_m(const FindScene& scene, const std::vector<std::uint32_t>& on, double most) {
  const std::size_t step = std::max<std::size_t>(1, on.size() / kSpacingPlaces);
  std::vector<Eigen::Vector3f> some;
  for (std::size_t i = 0; i < on.size(); i += step) some.push_back(scene.points()[on[i]]);
  return double{point_spacing(scene.index(), some, 1, static_cast<float>(most))};
}

// The share of the design's surface that no scan can show.
double behind(const FinderModel& model, const FindScene& scene,
              const Eigen::Isometry3f& T_scan_design, double gate_m) {
  if (scene.outer().empty()) return 0;
  const auto count =
      std::count_if(model.probes.begin(), model.probes.end(), [&](const Eigen::Vector3f& p) {
        return is_behind(scene.outer(), T_scan_design * p, gate_m);
      });
  return static_cast<double>(count) / static_cast<double>(model.probes.size());
}

// What the camera saw where the design's surface would face it.
Sighted sighted(const FinderModel& model, const Sight& sight,
                const Eigen::Isometry3f& T_scan_design, double gate_m) {
  const std::size_t step = model.samples.size() / kSightedPlaces + 1;
  const auto gate = static_cast<float>(gate_m);
  Sighted sighted;
  for (std::size_t s = 0; s < model.samples.size(); s += step)
    sighted.look(sight, T_scan_design * model.samples.points[s],
                 T_scan_design.linear() * model.samples.normals[s], gate);
  return sighted;
}

// Of which parts what stops a run shows: more than clutter would put there by chance, and as much
// as shows of the rest. `dense`: explained points to a sample of what they vouch for. Half of a
// stop is turned away from a single view, and the open end of a pipe that is cut where a branch
// would be lies on some of the branch.
std::vector<std::uint8_t> stops_in_sight(const FinderModel& model, const std::vector<double>& on,
                                         double chance, double dense) {
  constexpr double kLeast = 10;     // points
  constexpr double kOfStop = 0.25;  // of it
  std::vector<double> samples(model.parts, 0);
  for (std::size_t s = 0; s < model.is_stop.size(); ++s)
    if (model.is_stop[s] != 0) samples[static_cast<std::size_t>(model.part[s])] += 1;
  std::vector<std::uint8_t> shows(model.parts, 0);
  for (std::size_t p = 0; p < model.parts; ++p) {
    const double by_chance = chance * samples[p] / static_cast<double>(model.is_stop.size());
    const double least = kLeast + 2 * by_chance + 3 * std::sqrt(by_chance);
    shows[p] = on[p] >= std::max(least, kOfStop * dense * samples[p]) ? 1 : 0;
  }
  return shows;
}

}  // namespace

PoseEvidence weigh_pose(const FinderModel& model, const FindScene& scene,
                        const Eigen::Isometry3f& T_design_scan, double gate_m) {
  PoseEvidence evidence;
  evidence.T_design_scan = T_design_scan.cast<double>();
  evidence.T_design_scan.linear() =
      Eigen::Quaterniond(evidence.T_design_scan.linear()).normalized().toRotationMatrix();
  evidence.per_part.assign(model.parts, 0);
  std::vector<std::uint32_t> on;
  std::vector<Correspondence> matches;
  std::vector<Eigen::Vector3f> on_design;
  std::size_t round_it = 0;
  std::vector<float> distances;
  std::vector<double> on_stops(model.parts, 0);
  const double reach = model.field.reach_m();
  const auto gate = static_cast<float>(gate_m);
  const auto beside2 =
      static_cast<float>(std::pow(model.beside_m() + model.field.cell_m(), 2) + gate_m * gate_m);
  const std::vector<Eigen::Vector3f>& points = scene.points();
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3f p = T_design_scan * points[i];
    const std::uint16_t s = model.field.nearest(p);
    if (s == SurfaceField::kFar) continue;
    const Eigen::Vector3f offset = p - model.samples.points[s];
    const float r = model.samples.normals[s].dot(offset);
    if (std::abs(r) > gate || offset.squaredNorm() > beside2) {
      ++round_it;
      continue;
    }
    on.push_back(i);
    on_design.push_back(p);
    matches.push_back({p, model.samples.normals[s], r, 1.0F});
    distances.push_back(std::abs(r));
    ++evidence.per_part[static_cast<std::size_t>(model.part[s])];
    on_stops[static_cast<std::size_t>(model.part[s])] += model.is_stop[s];
  }
  evidence.explained = on.size();
  // What lies round the surface but not on it is clutter: as thick a layer of it lies on it too.
  evidence.chance = static_cast<double>(round_it) * gate_m / std::max(gate_m, reach - gate_m);
  evidence.shows_stop.assign(model.parts, 0);
  evidence.free_motions = 6;
  if (on.size() < 8) return evidence;
  evidence.scale_m = 1.4826 * double{median(distances)};
  const HeldMotions motions = held_motions(build_normal_equations(matches), matches);
  // What only as many points hold as clutter would put there by chance is not held.
  const double least = 2 * evidence.chance + 3 * std::sqrt(evidence.chance);
  evidence.free_motions = 0;
  for (std::size_t i = 0; i < motions.weak.size(); ++i)
    if (motions.weak[i] || motions.held[static_cast<Eigen::Index>(i)] < least)
      ++evidence.free_motions;
  const double near = std::clamp(1.3 * spacing_m(scene, on, 4 * model.rough_m()),
                                 model.size_m / 150, 4 * model.rough_m());
  const Occupancy vouched(on_design, near);
  std::size_t covered = 0;
  for (const Eigen::Vector3f& p : model.probes) covered += vouched.is_near(p) ? 1U : 0U;
  evidence.coverage = static_cast<double>(covered) / static_cast<double>(model.probes.size());
  const double vouched_for = evidence.coverage * static_cast<double>(model.samples.size());
  evidence.shows_stop = stops_in_sight(model, on_stops, evidence.chance,
                                       static_cast<double>(on.size()) / std::max(1.0, vouched_for));
  evidence.points = std::move(on);
  const Eigen::Isometry3f T_scan_design = T_design_scan.inverse();
  const double off = std::max(2 * gate_m, kSightGate * model.size_m);
  if (scene.sight() != nullptr)
    evidence.sighted = sighted(model, *scene.sight(), T_scan_design, off);
  evidence.behind = behind(model, scene, T_scan_design, off);
  return evidence;
}

}  // namespace spool
