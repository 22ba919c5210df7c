// What is prepared of a design so that it can be found in a scan.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/find/finder_model.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "vision/align/weak_directions.h"
#include "vision/core/median.h"
#include "vision/scan/thinning.h"

namespace spool {
namespace {

constexpr std::size_t kElements = 1000;  // of the design, at each level: a million pairs
constexpr std::size_t kProbes = 256;
constexpr double kFieldReach = 0.03;  // of the size: twice what a pair's pose is off by

template <class T>
void shuffle(std::vector<T>& all, std::mt19937& random) {
  for (std::size_t i = all.size(); i > 1; --i) std::swap(all[i - 1], all[random() % i]);
}

FinderLevel level_of(const FinderModel& model, const ElementOptions& options, double cell_m,
                     std::mt19937& random, const Watch& watch) {
  FinderLevel level{options, cell_m, {}};
  const PointCloud thin = thin_to_voxels(CloudView(model.samples.points), cell_m);
  std::vector<Element> elements = local_elements(thin.points, options, watch);
  shuffle(elements, random);
  if (elements.size() > kElements) elements.resize(kElements);
  level.pairs = PairTable(std::move(elements), model.size_m, watch);
  return level;
}

// Motions that points all over the surface would not hold.
int free_motions_of(const PointCloud& samples) {
  std::vector<Correspondence> matches;
  for (std::size_t i = 0; i < samples.size(); ++i)
    matches.push_back({samples.points[i], samples.normals[i], 0.0F, 1.0F});
  const HeldMotions motions = held_motions(build_normal_equations(matches), matches);
  return static_cast<int>(std::count(motions.weak.begin(), motions.weak.end(), true));
}

// What keeps a run from sliding along itself: a bend, a flange's faces, a cap's crown, a branch.
// Everything else on it a pipe that only goes through would show as well.
std::vector<std::uint8_t> stops_of(const FinderModel& model) {
  constexpr float kAlong = 0.9F;    // cosine of 26 degrees: looks along the run
  constexpr float kBeside = 1.25F;  // times what most of the part is from its line: a branch
  const std::vector<Eigen::Vector3f>& points = model.samples.points;
  const auto off = [&](std::size_t s, const RunLine& line) {
    return (points[s] - line.point).cross(line.direction).norm();
  };
  std::vector<std::vector<float>> offs(model.parts);
  for (std::size_t s = 0; s < points.size(); ++s) {
    const auto part = static_cast<std::size_t>(model.part[s]);
    if (const int run = model.runs.of_part[part]; run >= 0)
      offs[part].push_back(off(s, model.runs.lines[static_cast<std::size_t>(run)]));
  }
  std::vector<float> usual(model.parts, 0);
  for (std::size_t part = 0; part < model.parts; ++part)
    if (!offs[part].empty()) usual[part] = median(offs[part]);
  std::vector<std::uint8_t> is_stop(points.size(), 0);
  for (std::size_t s = 0; s < points.size(); ++s) {
    const auto part = static_cast<std::size_t>(model.part[s]);
    const int run = model.runs.of_part[part];
    if (run < 0) {
      is_stop[s] = 1;
      continue;
    }
    const RunLine& line = model.runs.lines[static_cast<std::size_t>(run)];
    const bool is_branched = model.runs.at[part].size() > 1;
    is_stop[s] = (is_branched ? off(s, line) > kBeside * usual[part]
                              : std::abs(line.direction.dot(model.samples.normals[s])) > kAlong)
                     ? 1
                     : 0;
  }
  return is_stop;
}

}  // namespace

FinderModel FinderModel::prepare(const DesignModel& design, const DesignSurface& surface,
                                 const SurfaceSamples& samples, std::uint32_t seed,
                                 const Watch& watch) {
  constexpr double kSteps = 6;  // the field, three levels, what it resembles of itself, symmetries
  double done = 0;
  const auto goes_on = [&] {
    watch.report("prepare", done++ / kSteps);
    return !watch.cancelled();
  };
  FinderModel model;
  model.size_m = design.bounds().diagonal().norm();
  model.samples = samples.cloud;
  model.part = samples.part;
  model.spacing_m = samples.radius_m;
  model.parts = design.parts.size();
  model.runs = straight_runs(design);
  if (!model.samples.has_normals() || !(model.size_m > 0)) return model;
  model.is_stop = stops_of(model);
  if (!goes_on()) return model;
  std::mt19937 random(seed);
  model.probes = model.samples.points;
  shuffle(model.probes, random);
  if (model.probes.size() > kProbes) model.probes.resize(kProbes);
  model.field = SurfaceField(model.samples, model.size_m / 200, kFieldReach * model.size_m, watch);
  const double cell = model.cell_m();
  if (!goes_on()) return model;
  // A bulky design's samples lie further apart than the scan's points.
  const double even = std::max(cell, model.spacing_m);
  model.levels.push_back(
      level_of(model, {ElementKind::kSurface, 2.5 * even, 7}, even, random, watch));
  // Long and thin at a sixteenth and a tenth of the size: what shows where points are too few for
  // a surface.
  for (const double share : {0.06, 0.10}) {
    if (!goes_on()) return model;
    const double radius = share * model.size_m;
    model.levels.push_back(
        level_of(model, {ElementKind::kTube, radius, 6}, radius / 5, random, watch));
  }
  if (!goes_on()) return model;
  model.alike = self_likenesses(model, seed, watch);
  if (!goes_on()) return model;
  for (const SelfLikeness& alike : model.alike) {
    if (watch.cancelled()) return model;
    if (std::optional<Pose> exact = exact_symmetry(model, surface, alike))
      model.symmetries.push_back(*exact);
  }
  model.free_motions = free_motions_of(model.samples);
  return model;
}

bool FinderModel::are_symmetric(const Pose& T_a, const Pose& T_b) const {
  const auto any = [&](const auto& is_one) {
    return std::any_of(symmetries.begin(), symmetries.end(), is_one);
  };
  const auto lays_on = [&](const Pose& motion) {
    return displacement_m(*this, (motion * T_a).cast<float>(), T_b.cast<float>()) < same_m();
  };
  // One after another is a symmetry too: of a body of revolution a few turns stand for all.
  return any(lays_on) || any([&](const Pose& first) {
           return any([&](const Pose& second) { return lays_on(second * first); });
         });
}

double displacement_m(const FinderModel& model, const Eigen::Isometry3f& T_a,
                      const Eigen::Isometry3f& T_b) {
  const Eigen::Isometry3f T = T_b * T_a.inverse();
  double sum = 0;
  for (const Eigen::Vector3f& p : model.probes) sum += (T * p - p).norm();
  return model.probes.empty() ? 0 : sum / static_cast<double>(model.probes.size());
}

}  // namespace spool
