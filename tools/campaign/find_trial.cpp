// A scene with its design prepared to be found.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/campaign/find_trial.h"

#include <filesystem>
#include <string>
#include <utility>

#include <unistd.h>

#include "vision/core/file_io.h"
#include "vision/design/design_reader.h"
#include "vision/scan/noise_estimate.h"

namespace spool::campaign {

Result<FindTrial> make_find_trial(Scene scene) {
  const auto file =
      std::filesystem::temp_directory_path() / ("find-trial-" + std::to_string(getpid()) + ".glb");
  if (auto written = write_file_whole(file, scene.glb()); !written) return written.error();
  auto model = read_design(file);
  std::filesystem::remove(file);
  if (!model) return model.error();
  auto design = PreparedDesign::prepare(std::move(*model), 1, true);
  if (!design) return design.error();
  const double noise_m = estimate_noise(scene.cloud);
  return FindTrial{std::move(scene), std::move(*design), noise_m};
}

Miss miss_of(const FindTrial& trial, const Pose& T_design_scan) {
  Miss least;
  std::vector<Pose> symmetries = trial.scene.symmetries;
  if (symmetries.empty()) symmetries.push_back(Pose::Identity());
  for (const Instance& object : trial.scene.objects)
    for (const Pose& symmetry : symmetries) {
      const Pose error = symmetry * T_design_scan * object.T_scan_design;
      double sum = 0;
      for (const Eigen::Vector3f& p : trial.design->samples.cloud.points) {
        const Eigen::Vector3d q = p.cast<double>() + trial.design->model.origin;
        sum += (error * q - q).norm();
      }
      const double mean = sum / static_cast<double>(trial.design->samples.cloud.size());
      if (mean < least.mean_m) least = {mean, pose_size(error).rotation_rad};
    }
  return least;
}

}  // namespace spool::campaign
