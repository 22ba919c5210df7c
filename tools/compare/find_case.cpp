// Cases for finding, from the campaign's scenes.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/compare/find_case.h"

#include <set>
#include <string>
#include <utility>

#include "vision/scan/normals.h"
#include "vision/scan/point_index.h"
#include "vision/scan/thinning.h"

namespace spool::compare {
namespace {

constexpr double kCellOfSize = 0.01;  // features see tubes of a tenth of the design's size
constexpr int kNormalNeighbours = 16;

}  // namespace

std::vector<campaign::FindRow> compared_rows() {
  const std::set<std::string> wanted{"spool-clutter-12", "spool-clutter-51",  "frame-clutter-3",
                                     "spool-density-5",  "spool-complete-50", "spool-absent"};
  std::vector<campaign::FindRow> rows = campaign::find_rows();
  std::erase_if(rows, [&](const campaign::FindRow& row) { return !wanted.contains(row.name); });
  return rows;
}

Result<ComparedTrial> make_compared_trial(const campaign::SceneRequest& request) {
  auto trial = campaign::make_find_trial(campaign::make_scene(request));
  if (!trial) return trial.error();
  ComparedTrial made{std::move(*trial), {}};
  const PointCloud& scan = made.trial.scene.cloud;
  FindCase& points = made.points;
  points.size_m = made.trial.design->finder->size_m;
  points.noise_m = made.trial.noise_m;
  points.seed = request.seed;
  const double cell_m = kCellOfSize * points.size_m;
  points.scan = thin_to_voxels(scan, cell_m);
  points.scan.normals.clear();
  estimate_neighbour_normals(points.scan, PointIndex(points.scan.points), kNormalNeighbours,
                             std::nullopt);
  points.design = thin_to_voxels(made.trial.design->samples.cloud, cell_m);
  return made;
}

double mean_miss(const ComparedTrial& of, const Pose& T_design_scan) {
  const Eigen::Translation3d to_design(of.trial.design->model.origin);
  const Eigen::Translation3d from_scan(-of.trial.scene.cloud.origin);
  return miss_of(of.trial, to_design * T_design_scan * from_scan).mean_m;
}

}  // namespace spool::compare
