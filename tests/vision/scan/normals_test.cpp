// Tests of normals against planes and cylinders that are known.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/scan/normals.h"

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "vision/scan/back_projection.h"

namespace spool {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

Camera camera_320() {
  return {.width = 320, .height = 240, .fx = 575, .fy = 575, .cx = 159.5, .cy = 119.5};
}

// An organised cloud of depth(u, v) with the model's own noise along z, not quantised.
PointCloud noisy_cloud(const Camera& camera, const NoiseModel& noise, double share_of_noise,
                       const std::function<double(double, double)>& depth) {
  std::mt19937 random{11};
  std::normal_distribution<double> normal;
  PointCloud cloud;
  cloud.width = camera.width;
  cloud.height = camera.height;
  for (int v = 0; v < camera.height; ++v)
    for (int u = 0; u < camera.width; ++u) {
      double z = depth(u, v);
      if (z > 0) z += share_of_noise * noise.axial_m(z) * normal(random);
      cloud.points.emplace_back(Eigen::Vector3f::Constant(NAN));
      if (z > 0) cloud.points.back() = camera.back_project(u, v, z).cast<float>();
    }
  return cloud;
}

double angle_between(const Eigen::Vector3f& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cast<double>().cross(b).norm(), a.cast<double>().dot(b));
}

// Depth where the pixel's ray meets the plane normal . p = -distance.
std::function<double(double, double)> plane_depth(const Camera& camera,
                                                  const Eigen::Vector3d& normal, double distance) {
  return [=](double u, double v) { return -distance / normal.dot(camera.back_project(u, v, 1.0)); };
}

TEST(OrganisedNormals, AreExactOnAPlaneWithoutNoise) {
  const Camera camera = camera_320();
  for (const double tilt_deg : {0.0, 30.0, 60.0, -60.0}) {
    const Eigen::Vector3d normal(std::sin(tilt_deg * kDegree), 0.1, -std::cos(tilt_deg * kDegree));
    const Eigen::Vector3d unit = normal.normalized();
    PointCloud cloud = noisy_cloud(camera, {}, 0.0, plane_depth(camera, unit, 0.8));
    estimate_organised_normals(cloud, camera, {});
    for (const Eigen::Vector3f& found : cloud.normals)
      // Floats of depth: 6e-8 relative over a window of 13 px in 575.
      ASSERT_LT(angle_between(found, unit), 2e-4) << tilt_deg;
  }
}

TEST(OrganisedNormals, AreUnitAndTowardsTheCamera) {
  const Camera camera = camera_320();
  PointCloud cloud = noisy_cloud(camera, {}, 1.0, plane_depth(camera, {0, 0, -1}, 0.8));
  estimate_organised_normals(cloud, camera, {});
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    ASSERT_NEAR(cloud.normals[i].norm(), 1.0F, 1e-5F);
    ASSERT_LT(cloud.normals[i].dot(cloud.points[i]), 0.0F);
  }
}

TEST(OrganisedNormals, AreAsGoodAsTheNoiseAllowsOnAPlane) {
  const Camera camera = camera_320();
  const NoiseModel noise;
  const Eigen::Vector3d normal = Eigen::Vector3d(0.5, 0.2, -1).normalized();
  PointCloud cloud = noisy_cloud(camera, noise, 1.0, plane_depth(camera, normal, 0.7));
  estimate_organised_normals(cloud, camera, noise);
  double squared = 0;
  for (const Eigen::Vector3f& found : cloud.normals)
    squared += std::pow(angle_between(found, normal), 2);
  const double rms = std::sqrt(squared / static_cast<double>(cloud.size()));
  // 49 readings of 1.37 mm noise, 4 px (4.9 mm) from their middle on average: 1.37 / (7 x 4.9) =
  // 0.040 rad for each of the two tilts, 0.057 together; smaller on a slope, larger at the image's
  // border.
  EXPECT_LT(rms, 0.060);
  EXPECT_GT(rms, 0.020);
}

TEST(OrganisedNormals, FollowACylinder) {
  const Camera camera = camera_320();
  const NoiseModel noise;
  constexpr double kRadius = 0.0302, kDistance = 0.6;  // NPS 2 pipe across the view
  const auto depth = [&](double u, double v) {
    // |p x axis|: the ray in the y, z plane meets the circle about (0, kDistance).
    const Eigen::Vector3d ray = camera.back_project(u, v, 1.0);
    const double a = ray.y() * ray.y() + 1, b = -2 * kDistance;
    const double c = kDistance * kDistance - kRadius * kRadius;
    const double root = b * b - 4 * a * c;
    return root < 0 ? 0.0 : (-b - std::sqrt(root)) / (2 * a);
  };
  PointCloud cloud = noisy_cloud(camera, noise, 1.0, depth);
  estimate_organised_normals(cloud, camera, noise);
  double squared = 0;
  int count = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (!cloud.points[i].allFinite()) {
      ASSERT_EQ(cloud.normals[i], Eigen::Vector3f(0, 0, 0)) << "no point, no normal";
      continue;
    }
    const Eigen::Vector3d p = cloud.points[i].cast<double>();
    const Eigen::Vector3d outward = Eigen::Vector3d(0, p.y(), p.z() - kDistance).normalized();
    if (std::abs(p.y()) > 0.6 * kRadius) continue;  // the limb, where half the window is missing
    squared += std::pow(angle_between(cloud.normals[i], outward), 2);
    ++count;
  }
  ASSERT_GT(count, 5000);
  // As on the plane (0.057 rad at 0.7 m); the direction to the noisy point itself adds 1.3 mm
  // in 30.
  EXPECT_LT(std::sqrt(squared / count), 0.085);
}

TEST(OrganisedNormals, DoNotMixTheTwoSidesOfADepthEdge) {
  const Camera camera = camera_320();
  const NoiseModel noise;
  // A wall at 1.0 m and before its left half a board at 0.9 m: both face the camera.
  const auto depth = [](double u, double) { return u < 160 ? 0.9 : 1.0; };
  PointCloud cloud = noisy_cloud(camera, noise, 0.0, depth);
  estimate_organised_normals(cloud, camera, noise);
  for (const Eigen::Vector3f& found : cloud.normals)
    ASSERT_LT(angle_between(found, {0, 0, -1}), 1e-3);
}

TEST(OrganisedNormals, LeaveASpeckWithoutANormal) {
  const Camera camera = camera_320();
  const auto depth = [](double u, double v) { return u == 100 && v >= 100 && v < 110 ? 1.0 : 0.0; };
  PointCloud cloud = noisy_cloud(camera, {}, 0.0, depth);  // ten pixels in one column: no plane
  estimate_organised_normals(cloud, camera, {});
  for (const Eigen::Vector3f& found : cloud.normals) ASSERT_EQ(found, Eigen::Vector3f(0, 0, 0));
}

TEST(NeighbourNormals, LookOutOfASphereTowardsTheViewpoint) {
  std::mt19937 random{2};
  std::normal_distribution<float> normal;
  PointCloud cloud;
  for (int i = 0; i < 20000; ++i)
    cloud.points.emplace_back(
        Eigen::Vector3f(normal(random), normal(random), normal(random)).normalized());
  const PointIndex index(cloud.points);
  estimate_neighbour_normals(cloud, index, 12, Eigen::Vector3d(0, 0, 0));
  double squared = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const double angle = angle_between(cloud.normals[i], -cloud.points[i].cast<double>());
    // Twelve neighbours reach sqrt(12 * 4 / 20000) = 0.05 rad; the loneliest of 20000 dozens twice
    // that.
    ASSERT_LT(angle, 0.1);
    squared += angle * angle;
  }
  // A dozen's middle lies off its point by about its reach / sqrt(12) = 0.014 rad.
  EXPECT_LT(std::sqrt(squared / 20000), 0.02);
}

TEST(NeighbourNormals, AreAsGoodAsTheNoiseAllowsOnAPlane) {
  std::mt19937 random{2};
  std::uniform_real_distribution<float> unit(-0.5F, 0.5F);
  std::normal_distribution<float> noise(0, 0.001F);
  PointCloud cloud;
  for (int i = 0; i < 20000; ++i)
    cloud.points.emplace_back(unit(random), unit(random), noise(random));
  const PointIndex index(cloud.points);
  estimate_neighbour_normals(cloud, index, 30, Eigen::Vector3d(0, 0, 10));
  double squared = 0;
  for (const Eigen::Vector3f& found : cloud.normals)
    squared += std::pow(angle_between(found, {0, 0, 1}), 2);
  // 30 points in a disc of radius sqrt(30 / (pi 20000)) = 22 mm: each tilt 1 mm / (sqrt(30) 11 mm)
  // = 0.017 rad.
  EXPECT_LT(std::sqrt(squared / 20000), 0.017 * 1.414 * 1.15);
}

TEST(NeighbourNormals, LeaveLinesAndLonePointsWithoutOne) {
  PointCloud cloud;
  for (int i = 0; i < 20; ++i) cloud.points.emplace_back(0.1F * static_cast<float>(i), 0.0F, 0.0F);
  cloud.points.emplace_back(NAN, 0.0F, 0.0F);
  estimate_neighbour_normals(cloud, PointIndex(cloud.points), 5, std::nullopt);
  ASSERT_TRUE(cloud.is_consistent());
  for (const Eigen::Vector3f& found : cloud.normals) EXPECT_EQ(found, Eigen::Vector3f(0, 0, 0));
}

}  // namespace
}  // namespace spool
