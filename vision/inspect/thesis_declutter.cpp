// The thesis's declutter as its chapter 5 tells it: Algorithm 1 isolates, Algorithm 2 tries every
// K.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/inspect/thesis_declutter.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "vision/find/point_icp.h"
#include "vision/scan/point_index.h"

namespace spool {

ThesisIsolation isolate_by_neighbours(const CloudView& scan, const CloudView& model,
                                      const Pose& T_design_scan,
                                      const ThesisIsolationOptions& options, const Watch& watch) {
  ThesisIsolation isolation;
  isolation.T_design_scan = T_design_scan;
  const PointIndex index(scan.points);
  // One round at a time, so that a cancel is seen.
  for (int round = 0; round < options.icp_iterations && !watch.cancelled(); ++round)
    isolation.T_design_scan =
        refine_point_to_point(model, index, scan, isolation.T_design_scan,
                              {.iterations = 1, .reach_m = options.icp_reach_m});
  if (watch.cancelled()) {
    isolation.kept = nothing_kept(scan.size(), options.declutter);
    return isolation;
  }
  const Eigen::Isometry3f T = isolation.T_design_scan.cast<float>();
  std::vector<Eigen::Vector3f> in_design(scan.points.begin(), scan.points.end());
  for (Eigen::Vector3f& p : in_design) p = T * p;
  isolation.kept = declutter_knn(CloudView(in_design), model, options.declutter);
  const double listed = static_cast<double>(isolation.kept.k) * static_cast<double>(model.size());
  if (listed > 0) isolation.unique_share = static_cast<double>(isolation.kept.object) / listed;
  return isolation;
}

std::vector<int> thesis_ks(std::size_t scene_points, std::size_t model_points) {
  const auto root = [](std::size_t count) {
    return std::max(1, static_cast<int>(std::lround(std::sqrt(static_cast<double>(count)))));
  };
  std::vector<int> ks = {
      1, k_ratio(scene_points, model_points), 10, 50, root(model_points), root(scene_points)};
  std::sort(ks.begin(), ks.end());
  ks.erase(std::unique(ks.begin(), ks.end()), ks.end());
  return ks;
}

std::vector<RateAtK> rates_by_k(const CloudView& scan, const CloudView& model,
                                std::span<const std::uint8_t> is_object, std::span<const int> ks,
                                const Watch& watch) {
  assert(is_object.size() == scan.size() && "a flag for every scan point");
  std::vector<RateAtK> rates;
  for (const int k : ks) {
    if (watch.cancelled()) break;
    const DeclutterResult result = declutter_knn(scan, model, {.k = k});
    std::vector<std::uint8_t> is_kept(scan.size());
    for (std::size_t i = 0; i < scan.size(); ++i)
      is_kept[i] = result.classes[i] == PointClass::kObject ? 1 : 0;
    rates.push_back({k, count_kept(is_object, is_kept)});
  }
  return rates;
}

}  // namespace spool
