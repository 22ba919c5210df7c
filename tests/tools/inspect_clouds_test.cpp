// spoolsight-inspect with a bare cloud as the design, as the thesis uses it: a real sensor's
// scene with clutter.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"
#include "tests/tools/inspect_run.h"
#include "vision/scan/cloud_file.h"

namespace spool {
namespace {

// The pose that takes the carton into the scene (its README; two independent starts agree). Five
// digits: made exactly rigid here.
Eigen::Isometry3d T_scene_carton() {
  Eigen::Matrix3d turn;
  turn << 0.96888, -0.11971, 0.21666, 0.11683, 0.99281, 0.02612, -0.21823, 0.00000, 0.97590;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = Eigen::Quaterniond(turn).normalized().toRotationMatrix();
  pose.translation() = Eigen::Vector3d(-0.15897, 0.21250, -0.04213);
  return pose;
}

TEST(InspectClouds, FindTheCartonFromPicksTenMillimetresOff) {
  SPOOL_REQUIRE_SHARED(data, "clouds/pcl_milk");
  const test::TemporaryFolder folder;
  const auto model = read_cloud(data / "milk.pcd", LengthUnit::kMetre);
  ASSERT_TRUE(model) << model.error().message;
  // Three of the carton's points, far apart: the lowest, and the two furthest from it and from each
  // other.
  std::vector<Eigen::Vector3d> points;
  for (const auto& point : model->cloud.points)
    if (point.allFinite()) points.push_back(point.cast<double>() + model->cloud.origin);
  const auto furthest = [&](const auto& score) {
    return *std::max_element(points.begin(), points.end(),
                             [&](const auto& a, const auto& b) { return score(a) < score(b); });
  };
  const Eigen::Vector3d first = furthest([](const Eigen::Vector3d& p) { return -p.y(); });
  const Eigen::Vector3d second =
      furthest([&](const Eigen::Vector3d& p) { return (p - first).norm(); });
  const Eigen::Vector3d third =
      furthest([&](const Eigen::Vector3d& p) { return (p - first).cross(p - second).norm(); });
  const Eigen::Isometry3d truth = T_scene_carton();
  const std::array<Eigen::Vector3d, 3> off = {
      {{0.010, 0, 0}, {0, -0.006, 0.008}, {-0.008, 0.006, 0}}};
  nlohmann::json pairs = nlohmann::json::array();
  std::size_t next = 0;
  for (const Eigen::Vector3d& p : {first, second, third}) {
    const Eigen::Vector3d q = truth * p + off[next++];
    pairs.push_back({{"design", {p.x(), p.y(), p.z()}}, {"scan", {q.x(), q.y(), q.z()}}});
  }
  std::ofstream(folder.path() / "pairs.json") << nlohmann::json{{"pairs", pairs}};
  const auto run =
      test::run_inspect({"--design", (data / "milk.pcd").string(), "--design-unit", "m", "--scan",
                         (data / "milk_cartoon_all_small_clorox.pcd").string(), "--scan-unit", "m",
                         "--pairs", (folder.path() / "pairs.json").string()},
                        folder.path() / "out");
  ASSERT_FALSE(run.report.is_null());
  ASSERT_TRUE(run.report["alignment"]["found"]) << run.report["alignment"]["reason"];
  const Eigen::Vector3d centre = truth * ((first + second + third) / 3);
  const auto error = test::difference(run.T_design_scan(), truth.inverse(), centre);
  EXPECT_LT(error.shift_m, 0.001);
  EXPECT_LT(error.angle_rad, 0.2 * std::numbers::pi / 180);
  // An organised scene: every pixel is a row, also those without a measurement.
  EXPECT_EQ(run.points.size(), 640U * 480U);
  std::size_t kept = 0;
  std::size_t off_carton = 0;
  for (const auto& row : run.points) {
    if (row.object != 1) continue;
    ++kept;
    off_carton += std::abs(row.deviation) > 0.005F ? 1U : 0U;
  }
  // The carton is some 12 575 points of the scene; what is kept is the carton.
  EXPECT_GT(kept, 11000U);
  EXPECT_LT(static_cast<double>(off_carton), 0.1 * static_cast<double>(kept));
}

}  // namespace
}  // namespace spool
