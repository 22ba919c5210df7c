// Normals, bounds, areas and even samples of patches.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/campaign/patch.h"

#include <algorithm>
#include <cmath>

namespace spool::campaign {
namespace {

using Eigen::Vector3d;
constexpr double kTurn = 2 * std::numbers::pi;

struct Normal {
  const Vector3d& p;

  Vector3d operator()(const Cylinder&) const { return {p.x(), p.y(), 0}; }
  Vector3d operator()(const Cone& s) const {
    const double slope = (s.r1 - s.r0) / (s.z1 - s.z0);
    return {p.x(), p.y(), -slope * std::hypot(p.x(), p.y())};
  }
  Vector3d operator()(const Annulus&) const { return Vector3d::UnitZ(); }
  Vector3d operator()(const Rectangle&) const { return Vector3d::UnitZ(); }
  Vector3d operator()(const Torus& s) const {
    const Vector3d ring = Vector3d(p.x(), p.y(), 0).normalized() * s.bend;
    return p - ring;
  }
  Vector3d operator()(const Dome& s) const {
    return {p.x(), p.y(), p.z() * s.radius * s.radius / (s.height * s.height)};
  }
  Vector3d operator()(const Block& s) const {
    int face = 0;
    (p.cwiseAbs() - s.half).maxCoeff(&face);
    Vector3d normal = Vector3d::Zero();
    normal[face] = p[face] < 0 ? -1 : 1;
    return normal;
  }
};

Eigen::AlignedBox3d around_z(double radius, double z0, double z1) {
  return {Vector3d(-radius, -radius, z0), Vector3d(radius, radius, z1)};
}

struct Bounds {
  Eigen::AlignedBox3d operator()(const Cylinder& s) const { return around_z(s.radius, s.z0, s.z1); }
  Eigen::AlignedBox3d operator()(const Cone& s) const {
    return around_z(std::max(s.r0, s.r1), s.z0, s.z1);
  }
  Eigen::AlignedBox3d operator()(const Annulus& s) const { return around_z(s.outer, 0, 0); }
  Eigen::AlignedBox3d operator()(const Torus& s) const {
    // The tube's middle line is an arc of at most half a turn that starts on x.
    Eigen::AlignedBox3d box;
    for (int i = 0; i <= 32; ++i) {
      const double angle = s.angle_rad * i / 32;
      box.extend(Vector3d(s.bend * std::cos(angle), s.bend * std::sin(angle), 0));
    }
    // Between two of the 33 points the arc bulges by less than bend * (pi / 64)^2 / 2.
    const Vector3d margin = Vector3d::Constant(s.tube + 0.0013 * s.bend);
    return {box.min() - margin, box.max() + margin};
  }
  Eigen::AlignedBox3d operator()(const Dome& s) const { return around_z(s.radius, 0, s.height); }
  Eigen::AlignedBox3d operator()(const Rectangle& s) const {
    return {Vector3d(-s.x, -s.y, 0), Vector3d(s.x, s.y, 0)};
  }
  Eigen::AlignedBox3d operator()(const Block& s) const { return {-s.half, s.half}; }
};

struct Area {
  double operator()(const Cylinder& s) const { return kTurn * s.radius * (s.z1 - s.z0); }
  double operator()(const Cone& s) const {
    return kTurn * std::max(s.r0, s.r1) * std::hypot(s.r1 - s.r0, s.z1 - s.z0);
  }
  double operator()(const Annulus& s) const {
    return kTurn / 2 * (s.outer * s.outer - s.inner * s.inner);
  }
  double operator()(const Torus& s) const {
    return kTurn * s.tube * s.angle_rad * (s.bend + s.tube);
  }
  // Of the cylinder that the half sphere is drawn from, stretched at most by its longer axis.
  double operator()(const Dome& s) const { return kTurn * s.radius * std::max(s.radius, s.height); }
  double operator()(const Rectangle& s) const { return 4 * s.x * s.y; }
  double operator()(const Block& s) const {
    const auto& h = s.half;
    return 8 * (h.x() * h.y() + h.y() * h.z() + h.z() * h.x());
  }
};

Vector3d at_angle(double radius, double angle, double z) {
  return {radius * std::cos(angle), radius * std::sin(angle), z};
}

// A point as if all of Area's were there; nothing where the map from there stretches less than its
// most, by that chance.
struct Draw {
  Random& random;
  using Point = std::optional<Vector3d>;

  Point operator()(const Cylinder& s) const {
    const double angle = random.uniform(0, kTurn);
    return at_angle(s.radius, angle, random.uniform(s.z0, s.z1));
  }
  Point operator()(const Cone& s) const {
    const double share = random.uniform();
    const double radius = s.r0 + share * (s.r1 - s.r0);
    if (!random.chance(radius / std::max(s.r0, s.r1))) return std::nullopt;
    return at_angle(radius, random.uniform(0, kTurn), s.z0 + share * (s.z1 - s.z0));
  }
  Point operator()(const Annulus& s) const {
    const double radius = std::sqrt(random.uniform(s.inner * s.inner, s.outer * s.outer));
    return at_angle(radius, random.uniform(0, kTurn), 0);
  }
  Point operator()(const Torus& s) const {
    const double round = random.uniform(0, kTurn);
    const double radius = s.bend + s.tube * std::cos(round);
    if (!random.chance(radius / (s.bend + s.tube))) return std::nullopt;
    return at_angle(radius, random.uniform(0, s.angle_rad), s.tube * std::sin(round));
  }
  Point operator()(const Dome& s) const {
    const double height = random.uniform();  // Archimedes: even in height on the unit sphere
    const Vector3d unit =
        at_angle(std::sqrt(1 - height * height), random.uniform(0, kTurn), height);
    // The area at `unit` grows by radius * |(h x, h y, r z)|.
    const double stretch =
        Vector3d(s.height * unit.x(), s.height * unit.y(), s.radius * unit.z()).norm();
    if (!random.chance(stretch / std::max(s.radius, s.height))) return std::nullopt;
    return Vector3d(s.radius * unit.x(), s.radius * unit.y(), s.height * unit.z());
  }
  Point operator()(const Rectangle& s) const {
    const double x = random.uniform(-s.x, s.x);
    return Vector3d(x, random.uniform(-s.y, s.y), 0);
  }
  Point operator()(const Block& s) const {
    const Vector3d sides(s.half.y() * s.half.z(), s.half.z() * s.half.x(), s.half.x() * s.half.y());
    double left = random.uniform(0, sides.sum());
    int face = 0;
    while (face < 2 && left > sides[face]) left -= sides[face++];
    Vector3d point;
    for (int i = 0; i < 3; ++i) point[i] = random.uniform(-s.half[i], s.half[i]);
    point[face] = random.chance(0.5) ? s.half[face] : -s.half[face];
    return point;
  }
};

}  // namespace

Vector3d normal_at(const Patch& patch, const Vector3d& point) {
  const Vector3d normal = std::visit(Normal{point}, patch.shape).normalized();
  return patch.inward ? Vector3d(-normal) : normal;
}

Eigen::AlignedBox3d bounds(const Patch& patch) { return std::visit(Bounds{}, patch.shape); }

double sampled_area(const Patch& patch) { return std::visit(Area{}, patch.shape); }

std::optional<Vector3d> sample(const Patch& patch, Random& random) {
  const std::optional<Vector3d> point = std::visit(Draw{random}, patch.shape);
  return point && is_there(patch, *point) ? point : std::nullopt;
}

}  // namespace spool::campaign
