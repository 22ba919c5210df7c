// The scan as the search sees it: thinned, floor and walls set aside, elements at each level.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/find/find_scene.h"

#include <algorithm>

#include "vision/scan/point_spacing.h"
#include "vision/scan/thinning.h"

namespace spool {
namespace {

constexpr std::size_t kMostPoints = 1'500'000;  // more are thinned first: memory stays bounded
constexpr std::size_t kSpacingPlaces = 500;

std::vector<Eigen::Vector3f> finite_of(std::span<const Eigen::Vector3f> scan) {
  std::vector<Eigen::Vector3f> finite;
  for (const Eigen::Vector3f& point : scan)
    if (point.allFinite()) finite.push_back(point);
  return finite;
}

// The means of cells as wide as the search looks at: what is sparse because it is far from the
// scanner stays. Of a scan so wide that this does not do, every nth mean.
std::vector<Eigen::Vector3f> thinned(std::span<const Eigen::Vector3f> scan, double cell_m,
                                     const Watch& watch) {
  std::vector<Eigen::Vector3f> means = thin_to_voxels(CloudView(scan), cell_m, watch).points;
  const std::size_t step = means.size() / kMostPoints + 1;
  for (std::size_t i = 0; i * step < means.size(); ++i) means[i] = means[i * step];
  means.resize((means.size() + step - 1) / step);
  return means;
}

}  // namespace

FindScene::FindScene(const FinderModel& model, std::span<const Eigen::Vector3f> scan,
                     double noise_m, const Watch& watch, const Sight* sight)
    : model_(model), sight_(sight), elements_(model.levels.size()) {
  finite_ = static_cast<std::size_t>(std::count_if(
      scan.begin(), scan.end(), [](const Eigen::Vector3f& point) { return point.allFinite(); }));
  was_thinned_ = finite_ > kMostPoints;
  const std::vector<Eigen::Vector3f> finite =
      was_thinned_ ? thinned(scan, model.cell_m(), watch) : finite_of(scan);
  if (finite.empty() || watch.cancelled()) return;
  planes_ = dominant_planes(finite, {.size_m = model.size_m, .noise_m = noise_m}, watch);
  if (watch.cancelled()) return;
  const double band = std::max(3 * noise_m, 0.003 * model.size_m);
  outer_ = outer_planes(finite, planes_, 2 * band);
  const std::vector<Eigen::Vector3f> off = off_planes(finite, planes_, band);
  points_ = thin_to_voxels(CloudView(off), model.cell_m()).points;
  index_ = PointIndex(points_);
  // Near is what a pair's pose may be off by, and what a sparse scan leaves between its points.
  const double rough = model.rough_m();
  const std::size_t step = std::max<std::size_t>(1, points_.size() / kSpacingPlaces);
  const float spacing = point_spacing(index_, points_, step, static_cast<float>(4 * rough));
  occupancy_ = Occupancy(points_, std::clamp(0.8 * double{spacing}, rough, 2 * rough));
}

const std::vector<Element>& FindScene::elements(std::size_t level, const Watch& watch) {
  auto& elements = elements_[level];
  if (!elements) {
    const FinderLevel& at = model_.levels[level];
    if (at.cell_m <= model_.cell_m()) {
      elements = local_elements(points_, at.elements, watch);
    } else {
      elements =
          local_elements(thin_to_voxels(CloudView(points_), at.cell_m).points, at.elements, watch);
    }
  }
  return *elements;
}

}  // namespace spool
