// Whether parts run into each other: each as a few capsules.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/campaign/clearance.h"

#include <algorithm>
#include <cmath>

#include "tools/campaign/standard_sizes.h"

namespace spool::campaign {
namespace {

using Eigen::Vector3d;

// Between two segments (Ericson 2005, 5.1.9).
double distance(const Capsule& p, const Capsule& q) {
  const Vector3d d1 = p.b - p.a;
  const Vector3d d2 = q.b - q.a;
  const Vector3d r = p.a - q.a;
  const double a = d1.squaredNorm();
  const double e = d2.squaredNorm();
  const double f = d2.dot(r);
  const double c = d1.dot(r);
  const double b = d1.dot(d2);
  const double denominator = a * e - b * b;
  double s = denominator > 1e-12 ? std::clamp((b * f - c * e) / denominator, 0.0, 1.0) : 0.0;
  double t = e > 0 ? (b * s + f) / e : 0;
  if (t < 0) {
    t = 0;
    s = a > 0 ? std::clamp(-c / a, 0.0, 1.0) : 0;
  } else if (t > 1) {
    t = 1;
    s = a > 0 ? std::clamp((b - c) / a, 0.0, 1.0) : 0;
  }
  return (p.a + s * d1 - q.a - t * d2).norm();
}

// Joints between two parts, 99 where nothing joins them; at most three are told apart.
int joints_between(const Assembly& assembly, int a, int b) {
  const auto up = [&](int part) { return assembly.members[static_cast<std::size_t>(part)].parent; };
  for (int steps = 0, x = a; steps <= 2 && x >= 0; ++steps, x = up(x))
    for (int more = 0, y = b; steps + more <= 2 && y >= 0; ++more, y = up(y))
      if (x == y) return steps + more;
  return 99;
}

}  // namespace

std::vector<Capsule> capsules_of(const PartSpec& spec) {
  if (spec.kind == PartKind::kTube)
    return {{Vector3d::Zero(), {0, 0, spec.length_m}, spec.width_m / std::sqrt(2.0)}};
  const StandardSizes& sizes = sizes_of(spec.nps);
  const double radius = sizes.outside_diameter / 2;
  const auto ports = ports_of(spec);
  const auto at = [&](std::size_t i) { return ports[i].T_part_port.translation().eval(); };
  switch (spec.kind) {
    case PartKind::kFlange:
      return {{at(0), {0, 0, sizes.flange_thickness}, sizes.flange_diameter / 2},
              {at(0), at(1), sizes.hub / 2}};
    case PartKind::kTee:
      return {{at(0), at(1), radius},
              {{0, 0, sizes.tee}, at(2), sizes_of(spec.nps2).outside_diameter / 2}};
    case PartKind::kCap:
      return {{at(0), {0, 0, sizes.cap - radius / 2}, radius}};
    case PartKind::kElbow: {
      // The middle of the bend, and chords to it.
      const double bend = bend_radius(spec);
      const double half = spec.angle_rad / 2;
      const Vector3d middle(bend * (1 - std::cos(half)), 0, bend * std::sin(half));
      const double bulge = bend * (1 - std::cos(half / 2));
      return {{at(0), middle, radius + bulge}, {middle, at(1), radius + bulge}};
    }
    default:
      return {{at(0), at(1), radius}};
  }
}

bool collides(const Assembly& assembly, double clear) {
  const std::vector<Pose> poses = poses_of(assembly);
  std::vector<std::vector<Capsule>> parts;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    parts.push_back(capsules_of(assembly.members[i].spec));
    for (Capsule& capsule : parts.back()) {
      capsule.a = poses[i] * capsule.a;
      capsule.b = poses[i] * capsule.b;
    }
  }
  for (std::size_t i = 0; i < parts.size(); ++i)
    for (std::size_t j = i + 1; j < parts.size(); ++j) {
      if (joints_between(assembly, static_cast<int>(i), static_cast<int>(j)) <= 2) continue;
      for (const Capsule& a : parts[i])
        for (const Capsule& b : parts[j])
          if (distance(a, b) < a.radius + b.radius + clear) return true;
    }
  return false;
}

}  // namespace spool::campaign
