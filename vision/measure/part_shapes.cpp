// What a part's mesh says of its shape: a pipe's radius, a flange's face.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/measure/part_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <Eigen/Geometry>

#include "vision/measure/drawing.h"

namespace spool {

std::optional<PipeShape> pipe_shape(const DesignModel& design, int index) {
  const Part& part = design.parts[static_cast<std::size_t>(index)];
  if (part.kind != PartKind::kPipe || part.ports.size() < 2) return std::nullopt;
  PipeShape shape;
  shape.start = part.T_design_part * part.ports[0].position;
  const Eigen::Vector3d along = part.T_design_part * part.ports[1].position - shape.start;
  shape.length_m = along.norm();
  if (!(shape.length_m > 0)) return std::nullopt;
  shape.axis = along / shape.length_m;
  for (std::uint32_t t = part.first_triangle; t < part.first_triangle + part.triangle_count; ++t)
    for (const std::uint32_t v : design.mesh.triangles[t]) {
      const Eigen::Vector3d d = design.mesh.vertices[v].cast<double>() - shape.start;
      shape.radius_m = std::max(shape.radius_m, (d - d.dot(shape.axis) * shape.axis).norm());
    }
  if (!(shape.radius_m > 0)) return std::nullopt;
  // Vertices within it are the bore's: a wall is 1 % to 40 % of the radius (ASME B36.10).
  for (std::uint32_t t = part.first_triangle; t < part.first_triangle + part.triangle_count; ++t)
    for (const std::uint32_t v : design.mesh.triangles[t]) {
      const Eigen::Vector3d d = design.mesh.vertices[v].cast<double>() - shape.start;
      const double across = (d - d.dot(shape.axis) * shape.axis).norm();
      if (across < 0.99 * shape.radius_m && across > 0.6 * shape.radius_m)
        shape.bore_radius_m = std::max(shape.bore_radius_m, across);
    }
  return shape;
}

double mill_radius_u(double radius_m) {
  const double diameter_mm = 2000 * radius_m;
  const double most_mm = diameter_mm <= 114.5   ? 0.8
                         : diameter_mm <= 219.5 ? 1.6
                         : diameter_mm <= 457.5 ? 2.4
                                                : 3.2;
  return 0.001 * most_mm / 2 / std::sqrt(3.0);
}

double size_tolerance_m(double radius_m) { return 0.04 * 2 * radius_m; }

std::optional<FaceShape> face_shape(const DesignModel& design, int index) {
  const Part& part = design.parts[static_cast<std::size_t>(index)];
  const int port = face_port(part);
  if (port < 0) return std::nullopt;
  FaceShape shape;
  shape.point = part.T_design_part * part.ports[static_cast<std::size_t>(port)].position;
  shape.normal =
      (part.T_design_part.linear() * part.ports[static_cast<std::size_t>(port)].direction)
          .normalized();
  constexpr double kStep = 1e-4;      // m; planes nearer to each other than this are one
  constexpr double kForward = 0.999;  // cosine
  struct Level {
    double area = 0, reach = 0;
  };
  std::map<long, Level> levels;
  double area = 0;
  for (std::uint32_t t = part.first_triangle; t < part.first_triangle + part.triangle_count; ++t) {
    std::array<Eigen::Vector3d, 3> corner;
    for (std::size_t k = 0; k < 3; ++k)
      corner[k] = design.mesh.vertices[design.mesh.triangles[t][k]].cast<double>() - shape.point;
    const Eigen::Vector3d across = (corner[1] - corner[0]).cross(corner[2] - corner[0]);
    double reach = 0;
    for (const Eigen::Vector3d& c : corner)
      reach = std::max(reach, (c - c.dot(shape.normal) * shape.normal).norm());
    shape.flange_radius_m = std::max(shape.flange_radius_m, reach);
    if (!(across.dot(shape.normal) > kForward * across.norm())) continue;
    Level& level = levels[std::lround(corner[0].dot(shape.normal) / kStep)];
    level.area += 0.5 * across.norm();
    level.reach = std::max(level.reach, reach);
    area += 0.5 * across.norm();
  }
  constexpr double kLeastShare = 0.05;  // of the area that looks forward: less is a chamfer
  double foremost = 0;
  for (const auto& [step, level] : levels) {
    if (level.area < kLeastShare * area) continue;
    shape.levels.push_back(kStep * static_cast<double>(step));
    foremost = level.reach;  // they come in ascending order
  }
  shape.face_diameter_m = 2 * foremost;
  if (shape.levels.empty()) return std::nullopt;
  return shape;
}

}  // namespace spool
