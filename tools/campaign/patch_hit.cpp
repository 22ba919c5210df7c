// Where rays meet patches: the roots of each surface's equation along the ray, trimmed.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "tools/campaign/patch.h"
#include "tools/campaign/polynomial_roots.h"

namespace spool::campaign {
namespace {

using Eigen::Vector3d;

// Up to four crossings in rising order.
struct Crossings {
  std::array<double, 4> at = {};
  std::size_t count = 0;
  void add(double t) { at[count++] = t; }
};

// Roots of a t^2 + 2 b t + c, by the form that does not cancel.
Crossings quadratic(double a, double b, double c) {
  Crossings crossings;
  const double discriminant = b * b - a * c;
  if (discriminant < 0 || (a == 0 && b == 0)) return crossings;
  const double q = -(b + std::copysign(std::sqrt(discriminant), b));
  const double t0 = q == 0 ? 0 : c / q;
  if (a == 0) {
    crossings.add(t0);
    return crossings;
  }
  const double t1 = q / a;
  crossings.add(std::min(t0, t1));
  crossings.add(std::max(t0, t1));
  return crossings;
}

Crossings plane(const Vector3d& o, const Vector3d& d) {
  Crossings crossings;
  if (d.z() != 0) crossings.add(-o.z() / d.z());
  return crossings;
}

struct Cross {
  const Vector3d& o;
  const Vector3d& d;

  Crossings operator()(const Cylinder& s) const {
    return quadratic(d.x() * d.x() + d.y() * d.y(), o.x() * d.x() + o.y() * d.y(),
                     o.x() * o.x() + o.y() * o.y() - s.radius * s.radius);
  }
  Crossings operator()(const Cone& s) const {
    const double slope = (s.r1 - s.r0) / (s.z1 - s.z0);
    const double r = s.r0 + slope * (o.z() - s.z0);  // the cone's radius at the ray's start
    const double dr = slope * d.z();
    return quadratic(d.x() * d.x() + d.y() * d.y() - dr * dr,
                     o.x() * d.x() + o.y() * d.y() - r * dr, o.x() * o.x() + o.y() * o.y() - r * r);
  }
  Crossings operator()(const Annulus&) const { return plane(o, d); }
  Crossings operator()(const Rectangle&) const { return plane(o, d); }
  Crossings operator()(const Dome& s) const {
    const Vector3d scale(1 / s.radius, 1 / s.radius, 1 / s.height);
    const Vector3d so = o.cwiseProduct(scale);
    const Vector3d sd = d.cwiseProduct(scale);
    return quadratic(sd.squaredNorm(), so.dot(sd), so.squaredNorm() - 1);
  }
  Crossings operator()(const Torus& s) const {
    // (|p|^2 + R^2 - r^2)^2 = 4 R^2 (x^2 + y^2), seen from the ray's point nearest the centre and
    // within the ball that holds the torus.
    const double nearest = -o.dot(d);
    const Vector3d p = o + nearest * d;
    const double reach = s.bend + s.tube;
    const double half2 = reach * reach - p.squaredNorm();
    if (half2 <= 0) return {};
    const double half = std::sqrt(half2);
    const double k = p.squaredNorm() + s.bend * s.bend - s.tube * s.tube;
    const double f = 4 * s.bend * s.bend;
    const std::array<double, 5> c = {k * k - f * (p.x() * p.x() + p.y() * p.y()),
                                     -2 * f * (p.x() * d.x() + p.y() * d.y()),
                                     2 * k - f * (d.x() * d.x() + d.y() * d.y()), 0, 1};
    const Roots<4> roots = roots_between<4>(c, -half, half);
    Crossings crossings;
    for (std::size_t i = 0; i < roots.count; ++i) crossings.add(nearest + roots.at[i]);
    return crossings;
  }
  Crossings operator()(const Block& s) const {
    double enter = -std::numeric_limits<double>::infinity();
    double leave = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 3; ++i) {
      if (d[i] == 0) {
        if (std::abs(o[i]) > s.half[i]) return {};
        continue;
      }
      const double t0 = (-s.half[i] - o[i]) / d[i];
      const double t1 = (s.half[i] - o[i]) / d[i];
      enter = std::max(enter, std::min(t0, t1));
      leave = std::min(leave, std::max(t0, t1));
    }
    Crossings crossings;
    if (enter > leave) return crossings;
    crossings.add(enter);
    crossings.add(leave);
    return crossings;
  }
};

// Whether a point of the unbounded surface belongs to the piece.
struct Within {
  const Vector3d& p;

  bool operator()(const Cylinder& s) const { return p.z() >= s.z0 && p.z() <= s.z1; }
  bool operator()(const Cone& s) const { return p.z() >= s.z0 && p.z() <= s.z1; }
  bool operator()(const Annulus& s) const {
    const double radius = std::hypot(p.x(), p.y());
    if (radius < s.inner || radius > s.outer) return false;
    if (s.holes == 0 || std::abs(radius - s.circle_radius) > s.hole_radius) return true;
    const double step = 2 * std::numbers::pi / s.holes;
    const double angle = std::atan2(p.y(), p.x()) - s.clocking_rad;
    const double off = angle - step * std::round(angle / step);  // from the nearest hole
    const double x = radius * std::cos(off) - s.circle_radius;
    const double y = radius * std::sin(off);
    return x * x + y * y >= s.hole_radius * s.hole_radius;
  }
  bool operator()(const Torus& s) const {
    double angle = std::atan2(p.y(), p.x());
    if (angle < -1e-9) angle += 2 * std::numbers::pi;
    return angle <= s.angle_rad + 1e-9;
  }
  bool operator()(const Dome&) const { return p.z() >= 0; }
  bool operator()(const Rectangle& s) const {
    const double x = std::abs(p.x());
    const double y = std::abs(p.y());
    return x <= s.x && y <= s.y && (x >= s.hole_x || y >= s.hole_y);
  }
  bool operator()(const Block&) const { return true; }
};

}  // namespace

bool is_there(const Patch& patch, const Vector3d& point) {
  if (!std::visit(Within{point}, patch.shape)) return false;
  if (!patch.trim) return true;
  const double along = point.dot(patch.trim->axis);
  return point.dot(patch.trim->side) <= 0 ||
         point.squaredNorm() - along * along >= patch.trim->radius * patch.trim->radius;
}

std::optional<double> first_hit(const Patch& patch, const Vector3d& from, const Vector3d& direction,
                                double near, double far) {
  const Crossings crossings = std::visit(Cross{from, direction}, patch.shape);
  for (std::size_t i = 0; i < crossings.count; ++i) {
    const double t = crossings.at[i];
    if (t > near && t < far && is_there(patch, from + t * direction)) return t;
  }
  return std::nullopt;
}

}  // namespace spool::campaign
