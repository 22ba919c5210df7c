// The surface of a part as closed triangles, patch by patch.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/campaign/part_mesh.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace spool::campaign {
namespace {

using Eigen::Vector3d;
constexpr double kStep = 2 * std::numbers::pi / kCircleSteps;
constexpr double kLargestHole = 0.02;  // m, radius: what is smaller is a bolt hole and no bore

Loop circle(double radius, double z, int steps = kCircleSteps, double x = 0, double y = 0) {
  Loop loop;
  for (int i = 0; i < steps; ++i) {
    const double angle = 2 * std::numbers::pi * i / steps;
    loop.emplace_back(x + radius * std::cos(angle), y + radius * std::sin(angle), z);
  }
  return loop;
}

Vector3d polar(double radius, int step) {
  return {radius * std::cos(kStep * step), radius * std::sin(kStep * step), 0};
}

// A plate with bolt holes: plain rings inside and outside of the band that the holes lie in, and in
// the band a block round each hole between plain pieces.
void add_holed(const Annulus& a, MeshBuilder& b) {
  const double margin = a.hole_radius + 0.0005;
  const double low = std::max(a.inner, a.circle_radius - margin);
  const double high = std::min(a.outer, a.circle_radius + margin);
  if (low > a.inner) b.strip(circle(low, 0), circle(a.inner, 0));
  if (a.outer > high) b.strip(circle(a.outer, 0), circle(high, 0));
  const int between = kCircleSteps / a.holes;
  const int first = static_cast<int>(std::lround(a.clocking_rad / kStep));
  const int reach = static_cast<int>(std::ceil(std::asin(margin / a.circle_radius) / kStep));
  for (int hole = 0; hole < a.holes; ++hole) {
    const int middle = first + hole * between;
    Loop block;
    for (int i = -reach; i <= reach; ++i) block.push_back(polar(high, middle + i));
    for (int i = reach; i >= -reach; --i) block.push_back(polar(low, middle + i));
    const Vector3d centre = polar(a.circle_radius, middle);
    b.ring(circle(a.hole_radius, 0, kHoleSteps, centre.x(), centre.y()), block, centre,
           Vector3d::UnitZ());
    for (int i = reach; i < between - reach; ++i)
      b.quad(polar(low, middle + i), polar(high, middle + i), polar(high, middle + i + 1),
             polar(low, middle + i + 1));
  }
}

struct Mesher {
  MeshBuilder& b;
  bool inward;

  void operator()(const Cylinder& s) const {
    const int steps = s.radius < kLargestHole ? kHoleSteps : kCircleSteps;
    b.strip(circle(s.radius, s.z0, steps), circle(s.radius, s.z1, steps));
  }
  void operator()(const Cone& s) const { b.strip(circle(s.r0, s.z0), circle(s.r1, s.z1)); }
  void operator()(const Annulus& s) const {
    if (s.holes > 0)
      add_holed(s, b);
    else
      b.strip(circle(s.outer, 0), circle(s.inner, 0));
  }
  void operator()(const Torus& s) const {
    // Along the bend, where the radius is three times the tube's, finer steps than round it; less
    // so in the bore, which nobody measures.
    const double step = inward ? 2 * kStep : 2 * kStep / 3;
    const int steps = std::max(1, static_cast<int>(std::ceil(s.angle_rad / step - 1e-9)));
    const auto loop_at = [&](double angle) {
      Loop loop = circle(s.tube, 0);
      // A section's own z runs along the bend; its x points to the bend's centre, as a pipe's does.
      const Vector3d out(std::cos(angle), std::sin(angle), 0);
      for (Vector3d& p : loop) p = (s.bend - p.x()) * out + Vector3d(0, 0, p.y());
      return loop;
    };
    for (int i = 0; i < steps; ++i)
      b.strip(loop_at(s.angle_rad * i / steps), loop_at(s.angle_rad * (i + 1) / steps));
  }
  void operator()(const Dome& s) const {
    constexpr int kRings = kCircleSteps / 4;
    const auto loop_at = [&](int i) {
      const double angle = std::numbers::pi / 2 * i / kRings;
      return circle(s.radius * std::cos(angle), s.height * std::sin(angle));
    };
    for (int i = 0; i + 1 < kRings; ++i) b.strip(loop_at(i), loop_at(i + 1));
    const Loop last = loop_at(kRings - 1);
    for (std::size_t i = 0; i < last.size(); ++i)
      b.triangle(last[i], last[(i + 1) % last.size()], Vector3d(0, 0, s.height));
  }
  void operator()(const Rectangle& s) const {
    const auto corners = [](double x, double y) {
      return Loop{{-x, -y, 0}, {x, -y, 0}, {x, y, 0}, {-x, y, 0}};
    };
    const Loop outer = corners(s.x, s.y);
    if (s.hole_x > 0)
      b.strip(outer, corners(s.hole_x, s.hole_y));
    else
      b.quad(outer[0], outer[1], outer[2], outer[3]);
  }
  void operator()(const Block&) const {}  // furniture, never a part
};

}  // namespace

TriangleMesh mesh_of(const PartSpec& spec) {
  MeshBuilder builder;
  if (spec.kind == PartKind::kTee) {
    add_tee(spec, builder);
  } else {
    for (const Patch& patch : patches_of(spec)) {
      builder.in_frame(patch.T_part_patch, patch.inward);
      std::visit(Mesher{builder, patch.inward}, patch.shape);
    }
  }
  return builder.welded();
}

}  // namespace spool::campaign
