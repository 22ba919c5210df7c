// How far a point is from a part, by solids added and cut away: formulas that the generator's
// patches do not use.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/tools/campaign/solid_distance.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tools/campaign/standard_sizes.h"

namespace spool::campaign::test {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

double rod(const Vector3d& p, double radius, double z0, double z1) {
  const Vector2d d(std::hypot(p.x(), p.y()) - radius,
                   std::abs(p.z() - (z0 + z1) / 2) - (z1 - z0) / 2);
  return std::min(d.maxCoeff(), 0.0) + d.cwiseMax(0).norm();
}

double endless(const Vector3d& p, double radius) { return std::hypot(p.x(), p.y()) - radius; }

// A cone's side is a straight line in (radius, height).
double cone_side(const Vector3d& p, double r0, double r1, double z0, double z1) {
  const double slant = std::hypot(r1 - r0, z1 - z0);
  const double radius_there = r0 + (r1 - r0) * (p.z() - z0) / (z1 - z0);
  return (std::hypot(p.x(), p.y()) - radius_there) * (z1 - z0) / slant;
}

double frustum(const Vector3d& p, double r0, double r1, double z0, double z1) {
  return std::max({cone_side(p, r0, r1, z0, z1), z0 - p.z(), p.z() - z1});
}

// First-order distance to an ellipsoid of revolution about z.
double spheroid(const Vector3d& p, double radius, double height) {
  const Vector3d scaled(p.x() / radius, p.y() / radius, p.z() / height);
  const Vector3d gradient(scaled.x() / radius, scaled.y() / radius, scaled.z() / height);
  const double k = scaled.norm();
  return gradient.norm() > 0 ? k * (k - 1) / gradient.norm() : -std::min(radius, height);
}

double box(const Vector3d& p, const Vector3d& half) {
  const Vector3d d = p.cwiseAbs() - half;
  return std::min(d.maxCoeff(), 0.0) + d.cwiseMax(0).norm();
}

double elbow(const PartSpec& spec, double outer, double bore, const Vector3d& p) {
  const double bend = bend_radius(spec);
  const Vector2d from_axis(bend - p.x(), p.z());  // of the bend; the elbow starts along -x of it
  const double angle = std::atan2(from_axis.y(), from_axis.x());
  const double tube = std::hypot(from_axis.norm() - bend, p.y());
  // The ends' planes go through the bend's axis.
  const double past = angle - spec.angle_rad;
  const double end =
      std::max(-from_axis.norm() * std::sin(angle), from_axis.norm() * std::sin(past));
  return std::max({tube - outer, bore - tube, end});
}

double flange(const StandardSizes& s, double outer, double bore, const Vector3d& p) {
  double solid = std::min({rod(p, s.flange_diameter / 2, kRaisedFaceHeight, s.flange_thickness),
                           rod(p, s.raised_face / 2, 0, s.flange_thickness),
                           frustum(p, s.hub / 2, outer, s.flange_thickness, s.weld_neck - 0.006),
                           rod(p, outer, 0, s.weld_neck)});
  for (int i = 0; i < s.holes; ++i) {
    const double angle = std::numbers::pi * (2 * i + 1) / s.holes;
    const Vector3d axis(s.bolt_circle / 2 * std::cos(angle), s.bolt_circle / 2 * std::sin(angle),
                        0);
    solid = std::max(solid, -endless(p - axis, s.hole / 2));
  }
  return std::max(solid, -endless(p, bore));
}

}  // namespace

double solid_distance(const PartSpec& spec, const Vector3d& p) {
  if (spec.kind == PartKind::kTube) {
    const double half = spec.width_m / 2;
    const Vector3d middle(0, 0, spec.length_m / 2);
    const double bore = half - kTubeWall;
    return std::max(box(p - middle, {half, half, spec.length_m / 2}),
                    -box(p - middle, {bore, bore, spec.length_m}));
  }
  const StandardSizes& s = sizes_of(spec.nps);
  const double outer = s.outside_diameter / 2;
  const double bore = outer - s.wall;
  switch (spec.kind) {
    case PartKind::kPipe:
      return std::max(rod(p, outer, 0, spec.length_m), -endless(p, bore));
    case PartKind::kElbow:
      return elbow(spec, outer, bore, p);
    case PartKind::kTee: {
      const StandardSizes& b = sizes_of(spec.nps2);
      const double outer2 = b.outside_diameter / 2;
      // The branch's axis is x at the run's middle.
      const Vector3d q(p.z() - s.tee, p.y(), p.x());
      const double outlet = tee_outlet(spec.nps, spec.nps2);
      const double solid = std::min(rod(p, outer, 0, 2 * s.tee), rod(q, outer2, 0, outlet));
      return std::max({solid, -endless(p, bore), -rod(q, outer2 - b.wall, 0, 2 * outlet)});
    }
    case PartKind::kReducer: {
      const StandardSizes& b = sizes_of(spec.nps2);
      const double small = b.outside_diameter / 2;
      return std::max(frustum(p, outer, small, 0, s.reducer),
                      -cone_side(p, bore, small - b.wall, 0, s.reducer));
    }
    case PartKind::kFlange:
      return flange(s, outer, bore, p);
    case PartKind::kCap: {
      const Vector3d top = p - Vector3d(0, 0, s.cap - outer / 2);
      const auto hollow = [&](double radius, double height) {
        return top.z() > 0 ? spheroid(top, radius, height) : endless(p, radius);
      };
      return std::max({hollow(outer, outer / 2), -p.z(), -hollow(bore, outer / 2 - s.wall)});
    }
    case PartKind::kTube:
      break;
  }
  return 1e9;
}

}  // namespace spool::campaign::test
