// Closed meshes whose distance is known by formula.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/vision/design/shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

namespace spool::test {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

DesignModel empty_design(const char* name) {
  DesignModel design;
  design.path = name;
  Part part;
  part.name = name;
  design.parts.push_back(part);
  return design;
}

void add(DesignModel& design, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
         const Eigen::Vector3d& c) {
  const auto first = static_cast<std::uint32_t>(design.mesh.vertices.size());
  for (const Eigen::Vector3d& p : {a, b, c}) design.mesh.vertices.push_back(p.cast<float>());
  design.mesh.triangles.push_back({first, first + 1, first + 2});
  design.triangle_part.push_back(0);
  design.parts[0].triangle_count += 1;
}

void add_quad(DesignModel& design, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
              const Eigen::Vector3d& c, const Eigen::Vector3d& d) {
  add(design, a, b, c);
  add(design, a, c, d);
}

}  // namespace

DesignModel box_design(const Eigen::Vector3d& centre, const Eigen::Vector3d& half) {
  DesignModel design = empty_design("box");
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      Eigen::Vector3d out = Eigen::Vector3d::Zero();
      out[axis] = side * half[axis];
      Eigen::Vector3d u = Eigen::Vector3d::Zero();
      u[(axis + 1) % 3] = half[(axis + 1) % 3];
      Eigen::Vector3d v = Eigen::Vector3d::Zero();
      v[(axis + 2) % 3] = side * half[(axis + 2) % 3];
      const Eigen::Vector3d c = centre + out;
      add_quad(design, c - u - v, c + u - v, c + u + v, c - u + v);
    }
  }
  return design;
}

DesignModel torus_design(double R, double r, int around, int across) {
  DesignModel design = empty_design("torus");
  const auto at = [&](int i, int j) {
    const double u = kTurn * i / around;
    const double v = kTurn * j / across;
    return Eigen::Vector3d((R + r * std::cos(v)) * std::cos(u), (R + r * std::cos(v)) * std::sin(u),
                           r * std::sin(v));
  };
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      add_quad(design, at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
    }
  }
  return design;
}

DesignModel capped_cylinder_design(double radius, double length, int around) {
  DesignModel design = empty_design("cylinder");
  for (int i = 0; i < around; ++i) {
    const auto at = [&](int k, double z) {
      const double angle = kTurn * k / around;
      return Eigen::Vector3d(radius * std::cos(angle), radius * std::sin(angle), z);
    };
    add_quad(design, at(i, 0), at(i + 1, 0), at(i + 1, length), at(i, length));
    add(design, at(i + 1, 0), at(i, 0), {0, 0, 0});
    add(design, at(i, length), at(i + 1, length), {0, 0, length});
  }
  return design;
}

DesignModel needle_design() {
  DesignModel design = empty_design("needle");
  const Eigen::Vector3d tip(0, 0, 1);
  const Eigen::Vector3d a(0.05, 0, 0);
  const Eigen::Vector3d b(-0.04, 0.02, 0);
  const Eigen::Vector3d c(-0.04, -0.03, 0);
  add(design, a, b, tip);
  add(design, b, c, tip);
  add(design, c, a, tip);
  add(design, a, c, b);
  return design;
}

void append_design(DesignModel& into, const DesignModel& from) {
  const auto first_vertex = static_cast<std::uint32_t>(into.mesh.vertices.size());
  const auto first_triangle = static_cast<std::uint32_t>(into.mesh.triangles.size());
  const auto first_part = static_cast<std::int32_t>(into.parts.size());
  for (Part part : from.parts) {
    part.first_triangle += first_triangle;
    into.parts.push_back(part);
  }
  into.mesh.vertices.insert(into.mesh.vertices.end(), from.mesh.vertices.begin(),
                            from.mesh.vertices.end());
  for (Triangle triangle : from.mesh.triangles) {
    for (std::uint32_t& vertex : triangle) vertex += first_vertex;
    into.mesh.triangles.push_back(triangle);
  }
  for (const std::int32_t part : from.triangle_part)
    into.triangle_part.push_back(first_part + part);
}

double box_distance(const Eigen::Vector3d& p, const Eigen::Vector3d& centre,
                    const Eigen::Vector3d& half) {
  const Eigen::Vector3d q = (p - centre).cwiseAbs() - half;
  return q.cwiseMax(0).norm() + std::min(q.maxCoeff(), 0.0);
}

double torus_distance(const Eigen::Vector3d& p, double R, double r) {
  return std::hypot(p.head<2>().norm() - R, p.z()) - r;
}

double triangle_distance(const Eigen::Vector3d& p, const Eigen::Vector3d& a,
                         const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  const Eigen::Vector3d n = (b - a).cross(c - a).normalized();
  const Eigen::Vector3d foot = p - n.dot(p - a) * n;
  const auto left = [&](const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
    return (to - from).cross(foot - from).dot(n) >= 0;
  };
  if (left(a, b) && left(b, c) && left(c, a)) return std::abs(n.dot(p - a));
  const auto segment = [&](const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
    const double t = std::clamp((p - from).dot(to - from) / (to - from).squaredNorm(), 0.0, 1.0);
    return (p - from - t * (to - from)).norm();
  };
  return std::min({segment(a, b), segment(b, c), segment(c, a)});
}

double ray_distance(const Eigen::Vector3d& from, const Eigen::Vector3d& direction,
                    const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  const Eigen::Vector3d p = direction.cross(c - a);
  const double determinant = p.dot(b - a);
  if (std::abs(determinant) < 1e-15) return -1;
  const Eigen::Vector3d t = from - a;
  const double u = t.dot(p) / determinant;
  const Eigen::Vector3d q = t.cross(b - a);
  const double v = direction.dot(q) / determinant;
  if (u < 0 || v < 0 || u + v > 1) return -1;
  return q.dot(c - a) / determinant;
}

Eigen::Vector3d corner(const DesignModel& design, std::size_t triangle, std::size_t k) {
  return design.mesh.vertices[design.mesh.triangles[triangle][k]].cast<double>();
}

}  // namespace spool::test
