// A scene with its design prepared to be found.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/campaign/find_trial.h"

#include <utility>

#include "tools/campaign/scene_design.h"
#include "vision/scan/noise_estimate.h"

namespace spool::campaign {

Result<FindTrial> make_find_trial(Scene scene) {
  auto design = prepare_design(scene, true);
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
