// Round pipes made twice: as a meshed design, and as scan points straight from the formulas.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/vision/align/synthetic_spool.h"

#include <cmath>
#include <numbers>

namespace spool::test {
namespace {

struct Frame {
  Eigen::Vector3d x, y, z;
};

Frame frame_of(const Rod& rod) {
  Frame f;
  f.z = rod.direction.normalized();
  f.x = f.z.unitOrthogonal();
  f.y = f.z.cross(f.x);
  return f;
}

void add_rod(const Rod& rod, std::int32_t part, int segments, DesignModel& design) {
  const Frame f = frame_of(rod);
  TriangleMesh& mesh = design.mesh;
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  const auto n = static_cast<std::uint32_t>(segments);
  for (const double h : {0.0, rod.length})
    for (std::uint32_t s = 0; s < n; ++s) {
      const double a = 2 * std::numbers::pi * s / segments;
      const Eigen::Vector3d p =
          rod.base + h * f.z + rod.radius * (std::cos(a) * f.x + std::sin(a) * f.y);
      mesh.vertices.push_back(p.cast<float>());
    }
  mesh.vertices.push_back(rod.base.cast<float>());
  mesh.vertices.push_back((rod.base + rod.length * f.z).cast<float>());
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    mesh.triangles.push_back({first + a, first + b, first + c});
    design.triangle_part.push_back(part);
  };
  for (std::uint32_t s = 0; s < n; ++s) {
    const std::uint32_t t = (s + 1) % n;
    add(s, t, n + t);
    add(s, n + t, n + s);
    add(2 * n, t, s);
    add(2 * n + 1, n + s, n + t);
  }
}

}  // namespace

double distance_to(const Rod& rod, const Eigen::Vector3d& p) {
  const Frame f = frame_of(rod);
  const Eigen::Vector3d d = p - rod.base;
  const double along = std::abs(d.dot(f.z) - 0.5 * rod.length) - 0.5 * rod.length;
  const double aside = (d - d.dot(f.z) * f.z).norm() - rod.radius;
  const double outside = std::hypot(std::max(along, 0.0), std::max(aside, 0.0));
  return outside > 0 ? outside : std::max(along, aside);
}

DesignModel design_of(const std::vector<Rod>& rods, int segments) {
  DesignModel design;
  design.path = "synthetic";
  for (std::size_t i = 0; i < rods.size(); ++i) {
    Part part;
    part.name = "rod_" + std::to_string(i + 1);
    part.kind = PartKind::kPipe;
    part.first_triangle = static_cast<std::uint32_t>(design.mesh.triangles.size());
    add_rod(rods[i], static_cast<std::int32_t>(i), segments, design);
    part.triangle_count =
        static_cast<std::uint32_t>(design.mesh.triangles.size()) - part.first_triangle;
    design.parts.push_back(part);
  }
  return design;
}

PointCloud scan_of(const std::vector<Rod>& rods, const Eigen::Isometry3d& T_scan_design,
                   const ScanOptions& options, std::mt19937& random) {
  std::vector<double> areas;
  for (const Rod& rod : rods)
    areas.push_back(2 * std::numbers::pi * rod.radius *
                    (rod.length + (options.with_ends ? rod.radius : 0.0)));
  std::discrete_distribution<std::size_t> pick(areas.begin(), areas.end());
  std::uniform_real_distribution<double> unit(0, 1);
  std::normal_distribution<double> noise(0, 1);
  PointCloud cloud;
  while (cloud.points.size() < options.points) {
    const std::size_t chosen = pick(random);
    const Rod& rod = rods[chosen];
    const Frame f = frame_of(rod);
    const double angle = 2 * std::numbers::pi * unit(random);
    const Eigen::Vector3d radial = std::cos(angle) * f.x + std::sin(angle) * f.y;
    Eigen::Vector3d p, normal;
    if (unit(random) * (rod.length + (options.with_ends ? rod.radius : 0.0)) < rod.length) {
      p = rod.base + unit(random) * rod.length * f.z + rod.radius * radial;
      normal = radial;
    } else {
      const bool top = unit(random) < 0.5;
      p = rod.base + (top ? rod.length : 0.0) * f.z + rod.radius * std::sqrt(unit(random)) * radial;
      normal = top ? f.z : Eigen::Vector3d(-f.z);
    }
    bool hidden = false;
    for (std::size_t i = 0; i < rods.size(); ++i)
      hidden = hidden || (i != chosen && distance_to(rods[i], p) < 1e-6);
    if (hidden) continue;
    if (!options.towards.isZero() && normal.dot(options.towards.normalized()) < options.min_facing)
      continue;
    p += options.noise_m * noise(random) * normal;
    cloud.points.push_back((T_scan_design * p).cast<float>());
    cloud.normals.push_back((T_scan_design.linear() * normal).cast<float>());
  }
  return cloud;
}

std::vector<Rod> tee_spool() {
  return {
      {{0, 0, 0}, Eigen::Vector3d::UnitZ(), 0.05, 0.8},
      {{0, 0, 0.55}, Eigen::Vector3d::UnitX(), 0.04, 0.4},
      {{0, 0, -0.03}, Eigen::Vector3d::UnitZ(), 0.09, 0.03},
      {{0, 0, 0.8}, Eigen::Vector3d::UnitZ(), 0.09, 0.03},
      {{0.4, 0, 0.55}, Eigen::Vector3d::UnitX(), 0.075, 0.025},
  };
}

Eigen::Isometry3d random_motion(double translation_m, double rotation_rad, std::mt19937& random) {
  std::normal_distribution<double> gauss(0, 1);
  const auto direction = [&] {
    const double x = gauss(random), y = gauss(random), z = gauss(random);
    return Eigen::Vector3d(x, y, z).normalized();
  };
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() = Eigen::AngleAxisd(rotation_rad, direction()).toRotationMatrix();
  T.translation() = translation_m * direction();
  return T;
}

double displacement_at(const Eigen::AlignedBox3d& box, const Eigen::Isometry3d& a,
                       const Eigen::Isometry3d& b) {
  const Eigen::Isometry3d between = a * b.inverse();
  double worst = 0;
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector3d p = box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i));
    worst = std::max(worst, (between * p - p).norm());
  }
  return worst;
}

}  // namespace spool::test
