// Cases for finding, from the campaign's scenes.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/compare/find_case.h"

#include <algorithm>
#include <filesystem>

#include <unistd.h>

#include "vision/core/file_io.h"
#include "vision/design/design_reader.h"
#include "vision/scan/noise_estimate.h"
#include "vision/scan/normals.h"
#include "vision/scan/point_index.h"
#include "vision/scan/thinning.h"

namespace spool::compare {
namespace {

constexpr double kCellOfSize = 0.01;  // features see tubes of a tenth of the design's size
constexpr int kNormalNeighbours = 16;

// Written and read again, so that the design is what a file gives.
Result<DesignModel> as_read(const campaign::Scene& scene) {
  const auto file = std::filesystem::temp_directory_path() /
                    ("compare-find-" + std::to_string(getpid()) + ".glb");
  if (auto written = write_file_whole(file, scene.glb()); !written) return written.error();
  auto model = read_design(file);
  std::filesystem::remove(file);
  return model;
}

}  // namespace

std::vector<FindRow> find_rows() {
  using campaign::ObjectKind;
  const auto laser = [](ObjectKind kind, std::size_t points, double clutter) {
    return campaign::SceneRequest{.kind = kind, .scene_points = points, .clutter_ratio = clutter};
  };
  constexpr auto kSpool = ObjectKind::kPipeSpool3m;
  std::vector<FindRow> rows{{"spool-clutter-12", laser(kSpool, 81'000, 12)},
                            {"spool-clutter-51", laser(kSpool, 322'000, 51)},
                            {"frame-clutter-3", laser(ObjectKind::kBoxFrame, 61'000, 3)},
                            {"spool-density-5", laser(kSpool, 50'000, 49)}};
  campaign::SceneRequest half = laser(kSpool, 81'000, 12);
  half.completeness = 0.5;
  rows.push_back({"spool-complete-50", half});
  campaign::SceneRequest absent = laser(kSpool, 81'000, 12);
  absent.copies = 0;
  rows.push_back({"spool-absent", absent});
  return rows;
}

Result<FindScene> make_find_scene(const campaign::SceneRequest& request) {
  FindScene made{campaign::make_scene(request), nullptr, {}};
  auto model = as_read(made.scene);
  if (!model) return model.error();
  auto design = PreparedDesign::prepare(std::move(*model), 1, true);
  if (!design) return design.error();
  made.design = std::move(*design);

  FindCase& points = made.points;
  points.size_m = made.design->finder->size_m;
  points.noise_m = estimate_noise(made.scene.cloud);
  points.seed = request.seed;
  const double cell_m = kCellOfSize * points.size_m;
  points.scan = thin_to_voxels(made.scene.cloud, cell_m);
  points.scan.normals.clear();
  estimate_neighbour_normals(points.scan, PointIndex(points.scan.points), kNormalNeighbours,
                             std::nullopt);
  points.design = thin_to_voxels(made.design->samples.cloud, cell_m);
  return made;
}

double mean_miss(const FindScene& of, const Pose& T_design_scan) {
  double least = 1e9;
  std::vector<Pose> symmetries = of.scene.symmetries;
  if (symmetries.empty()) symmetries.push_back(Pose::Identity());
  const PointCloud& samples = of.design->samples.cloud;
  for (const campaign::Instance& object : of.scene.objects)
    for (const Pose& symmetry : symmetries) {
      // The pose is between the rebased frames, the truth between the files' own.
      double sum = 0;
      for (const Eigen::Vector3f& p : samples.points) {
        const Eigen::Vector3d q = p.cast<double>() + of.design->model.origin;
        const Eigen::Vector3d scanned = object.T_scan_design * q - of.scene.cloud.origin;
        sum += (symmetry * (T_design_scan * scanned + of.design->model.origin) - q).norm();
      }
      least = std::min(least, sum / static_cast<double>(samples.size()));
    }
  return least;
}

}  // namespace spool::compare
