// A simulated scene of the shared data with its truth, and picks on it that are off as a tap is.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/vision/scene.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "vision/core/file_io.h"
#include "vision/design/design_reader.h"
#include "vision/scan/cloud_file.h"

namespace spool::test {

Scene load_scene(const std::filesystem::path& folder, bool to_be_found) {
  Scene scene;
  auto model = read_design(folder / "design" / "model.glb");
  auto cloud = read_cloud(folder / "cloud.ply", LengthUnit::kMetre);
  const auto truth_text = read_file(folder / "truth" / "truth.json");
  const auto labels = read_file(folder / "truth" / "labels.bin");
  if (!model || !cloud || !truth_text || !labels) {
    ADD_FAILURE() << "cannot read " << folder;
    return scene;
  }
  auto design = PreparedDesign::prepare(std::move(*model), 1, to_be_found);
  if (!design) {
    ADD_FAILURE() << design.error().message;
    return scene;
  }
  scene.design = *design;
  EXPECT_TRUE(scene.design->model.origin.isZero() && cloud->cloud.origin.isZero());
  scene.cloud = std::move(cloud->cloud);
  scene.labels.resize(labels->size() / 2);
  std::memcpy(scene.labels.data(), labels->data(), 2 * scene.labels.size());
  const auto truth = nlohmann::json::parse(*truth_text);
  std::vector<double> numbers;
  for (const auto& row : truth.at("pose"))
    for (const auto& number : row) numbers.push_back(number.get<double>());
  scene.T_design_scan = pose_from_row_major(numbers).value().inverse();
  for (const auto& component : truth.at("components")) {
    const auto& error = component.at("error_root");
    scene.undisturbed.push_back(error.at("t_norm_mm").get<double>() < 0.01 &&
                                error.at("r_norm_deg").get<double>() < 0.01 &&
                                std::abs(component.at("length_error_mm").get<double>()) < 0.01);
  }
  return scene;
}

std::vector<PointPair> picks_on(const SurfaceSamples& samples, const Pose& T_design_scan,
                                double error_m, std::mt19937& random) {
  const auto& points = samples.cloud.points;
  std::uniform_int_distribution<std::size_t> any(0, points.size() - 1);
  std::normal_distribution<double> gauss(0, 1);
  // The widest triangle of two hundred random ones: a user picks places that are far apart.
  std::vector<Eigen::Vector3d> best;
  double widest = -1;
  for (int trial = 0; trial < 200; ++trial) {
    const Eigen::Vector3d a = points[any(random)].cast<double>();
    const Eigen::Vector3d b = points[any(random)].cast<double>();
    const Eigen::Vector3d c = points[any(random)].cast<double>();
    const double area = (b - a).cross(c - a).norm();
    if (area <= widest) continue;
    widest = area;
    best = {a, b, c};
  }
  std::vector<PointPair> pairs;
  for (const Eigen::Vector3d& p : best) {
    const double x = gauss(random), y = gauss(random), z = gauss(random);
    const Eigen::Vector3d off = error_m * Eigen::Vector3d(x, y, z).normalized();
    pairs.push_back({p, T_design_scan.inverse() * p + off});
  }
  return pairs;
}

PoseError pose_error(const SurfaceSamples& samples, const Pose& T_found, const Pose& T_true) {
  const Pose between = T_found * T_true.inverse();
  PoseError error;
  error.angle_rad = pose_size(between).rotation_rad;
  for (const Eigen::Vector3f& sample : samples.cloud.points) {
    const Eigen::Vector3d p = sample.cast<double>();
    const double off = (between * p - p).norm();
    error.worst_m = std::max(error.worst_m, off);
    error.mean_m += off / static_cast<double>(samples.cloud.size());
  }
  return error;
}

}  // namespace spool::test
