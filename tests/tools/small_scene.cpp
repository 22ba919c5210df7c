// A design of two boxes and a scan of it, made by hand: enough to run the programs without any
// data beside.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/tools/small_scene.h"

#include <array>
#include <fstream>
#include <random>
#include <vector>

#include <Eigen/Geometry>

namespace spool::test {
namespace {

struct Bar {
  const char* name;
  Eigen::Vector3d low, high;  // m
};

// They touch without a shared face, as a mesh of separate parts does.
const std::array<Bar, 2> kBars = {
    {{"long", {0, 0, 0}, {0.5, 0.1, 0.1}}, {"short", {0.4, 0.1, 0}, {0.5, 0.4, 0.1}}}};

Eigen::Isometry3d scan_from_design() {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  pose.translation() = Eigen::Vector3d(0.3, -0.2, 1.1);
  return pose;
}

void write_design(const std::filesystem::path& path) {
  std::ofstream file(path);
  int first = 1;
  for (const auto& bar : kBars) {
    file << "o " << bar.name << "\n";
    for (unsigned corner = 0; corner < 8; ++corner)
      file << "v " << ((corner & 1U) != 0 ? bar.high : bar.low).x() << " "
           << ((corner & 2U) != 0 ? bar.high : bar.low).y() << " "
           << ((corner & 4U) != 0 ? bar.high : bar.low).z() << "\n";
    constexpr std::array<std::array<int, 4>, 6> kFaces = {
        {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
    for (const auto& face : kFaces) {
      file << "f " << first + face[0] << " " << first + face[1] << " " << first + face[2] << "\n";
      file << "f " << first + face[0] << " " << first + face[2] << " " << first + face[3] << "\n";
    }
    first += 8;
  }
}

bool is_inside(const Eigen::Vector3d& point) {
  for (const auto& bar : kBars)
    if ((point.array() > bar.low.array() - 1e-6).all() &&
        (point.array() < bar.high.array() + 1e-6).all())
      return true;
  return false;
}

// Points of every face, `spacing` apart, that no other bar covers, moved along the face's normal by
// the noise.
std::vector<Eigen::Vector3d> surface_points(double spacing, double noise_m) {
  std::mt19937 random{1};
  std::normal_distribution<double> noise(0.0, noise_m);
  std::vector<Eigen::Vector3d> points;
  for (const auto& bar : kBars)
    for (int axis = 0; axis < 3; ++axis)
      for (const int side : {-1, 1}) {
        const int u = (axis + 1) % 3;
        const int v = (axis + 2) % 3;
        for (double a = bar.low(u) + spacing / 2; a < bar.high(u); a += spacing)
          for (double b = bar.low(v) + spacing / 2; b < bar.high(v); b += spacing) {
            Eigen::Vector3d point;
            point(u) = a;
            point(v) = b;
            point(axis) = side < 0 ? bar.low(axis) : bar.high(axis);
            Eigen::Vector3d outside = point;
            outside(axis) += 1e-3 * side;
            if (is_inside(outside)) continue;
            point(axis) += noise(random);
            points.push_back(point);
          }
      }
  return points;
}

}  // namespace

void SmallScene::write(const std::filesystem::path& folder) const {
  write_design(folder / "design.obj");
  const Eigen::Isometry3d T_scan_design = scan_from_design();
  auto points = surface_points(0.006, noise_m);
  // A floor 5 cm under the bars.
  for (double x = -0.2; x < 0.8; x += 0.02)
    for (double y = -0.2; y < 0.6; y += 0.02) points.emplace_back(x, y, -0.05);
  std::ofstream scan(folder / "scan.ply");
  scan << "ply\nformat ascii 1.0\nelement vertex " << points.size()
       << "\nproperty float x\nproperty float y\nproperty float z\nend_header\n";
  for (const auto& point : points) scan << (T_scan_design * point).transpose() << "\n";
  std::ofstream pose(folder / "pose.json");
  pose.precision(17);
  const Eigen::Matrix4d matrix = T_scan_design.inverse().matrix();
  pose << "{\"T_design_scan\": [";
  for (int i = 0; i < 16; ++i) pose << (i > 0 ? ", " : "") << matrix(i / 4, i % 4);
  pose << "]}\n";
  const std::array<Eigen::Vector3d, 3> picks = {{{0, 0, 0.1}, {0.5, 0, 0.1}, {0.5, 0.4, 0}}};
  const std::array<Eigen::Vector3d, 3> off = {{{0.005, 0, 0}, {0, -0.005, 0}, {0, 0, 0.005}}};
  std::ofstream pairs(folder / "pairs.json");
  pairs << "{\"pairs\": [";
  for (std::size_t i = 0; i < 3; ++i) {
    const Eigen::Vector3d picked = T_scan_design * (picks[i] + off[i]);
    pairs << (i > 0 ? ", " : "") << "{\"design\": [" << picks[i].x() << ", " << picks[i].y() << ", "
          << picks[i].z() << "], \"scan\": [" << picked.x() << ", " << picked.y() << ", "
          << picked.z() << "]}";
  }
  pairs << "]}\n";
}

}  // namespace spool::test
