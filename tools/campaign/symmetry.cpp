// The motions that map a design onto itself, found from how it is put together.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/campaign/symmetry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "tools/campaign/standard_sizes.h"

namespace spool::campaign {
namespace {

using Eigen::Vector3d;
constexpr double kSame = 1e-6;  // m

// A point that says something of the shape, and what.
struct Mark {
  std::array<double, 3> kind = {};  // part kind, size, role
  Vector3d point = Vector3d::Zero();
};

void add_marks(const PartSpec& spec, const Pose& pose, std::vector<Mark>& marks) {
  const auto add = [&](double size, double role, const Vector3d& point) {
    marks.push_back({{static_cast<double>(spec.kind), size, role}, pose * point});
  };
  const auto ports = ports_of(spec);
  if (spec.kind == PartKind::kTube) {
    // The corners: which side of a square tube is which, nobody sees.
    const double half = spec.width_m / 2;
    for (const double x : {-half, half})
      for (const double y : {-half, half})
        for (const double z : {0.0, spec.length_m}) add(spec.width_m, 0, {x, y, z});
    return;
  }
  // The two ends of a pipe, elbow or run of a tee are alike; a flange's are not.
  const bool alike = spec.kind != PartKind::kFlange;
  for (std::size_t i = 0; i < ports.size(); ++i)
    add(ports[i].nps, alike && i < 2 ? 0 : static_cast<double>(i),
        ports[i].T_part_port.translation());
  if (spec.kind == PartKind::kElbow) add(spec.nps, 10, {bend_radius(spec), 0, 0});
  if (spec.kind == PartKind::kFlange) {
    const StandardSizes& sizes = sizes_of(spec.nps);
    for (int i = 0; i < sizes.holes; ++i) {
      const double angle = hole_clocking(sizes.holes) + 2 * std::numbers::pi * i / sizes.holes;
      const double r = sizes.bolt_circle / 2;
      add(spec.nps, 11, {r * std::cos(angle), r * std::sin(angle), 0});
    }
  }
}

// The frame that three points span.
Pose frame_of(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  Pose frame = Pose::Identity();
  frame.translation() = a;
  frame.linear().col(0) = (b - a).normalized();
  frame.linear().col(2) = (b - a).cross(c - a).normalized();
  frame.linear().col(1) = frame.linear().col(2).cross(frame.linear().col(0));
  return frame;
}

bool maps_onto_itself(const Pose& motion, const std::vector<Mark>& marks) {
  for (const Mark& mark : marks) {
    const Vector3d moved = motion * mark.point;
    bool found = false;
    for (const Mark& other : marks)
      found = found || (other.kind == mark.kind && (other.point - moved).norm() < kSame);
    if (!found) return false;
  }
  return true;
}

}  // namespace

std::vector<Pose> symmetries_of(const Assembly& assembly) {
  std::vector<Mark> marks;
  const std::vector<Pose> poses = poses_of(assembly);
  for (std::size_t i = 0; i < poses.size(); ++i)
    add_marks(assembly.members[i].spec, poses[i], marks);
  // Three marks that span a wide triangle, and every like triangle that they may move to.
  std::array<std::size_t, 3> base = {0, 0, 0};
  for (std::size_t i = 0; i < marks.size(); ++i)
    if ((marks[i].point - marks[0].point).norm() > (marks[base[1]].point - marks[0].point).norm())
      base[1] = i;
  const auto area = [&](std::size_t i) {
    return (marks[base[1]].point - marks[0].point).cross(marks[i].point - marks[0].point).norm();
  };
  for (std::size_t i = 0; i < marks.size(); ++i)
    if (area(i) > area(base[2])) base[2] = i;
  const Mark& a = marks[base[0]];
  const Mark& b = marks[base[1]];
  const Mark& c = marks[base[2]];
  const Pose frame = frame_of(a.point, b.point, c.point);
  const auto apart = [](const Mark& p, const Mark& q) { return (p.point - q.point).norm(); };
  std::vector<Pose> symmetries = {Pose::Identity()};
  for (const Mark& p : marks) {
    if (p.kind != a.kind) continue;
    for (const Mark& q : marks) {
      if (q.kind != b.kind || std::abs(apart(p, q) - apart(a, b)) > kSame) continue;
      for (const Mark& r : marks) {
        if (r.kind != c.kind || std::abs(apart(p, r) - apart(a, c)) > kSame ||
            std::abs(apart(q, r) - apart(b, c)) > kSame)
          continue;
        const Pose motion = frame_of(p.point, q.point, r.point) * frame.inverse();
        const auto is_known = [&](const Pose& known) { return motion.isApprox(known, 1e-6); };
        if (std::none_of(symmetries.begin(), symmetries.end(), is_known) &&
            maps_onto_itself(motion, marks))
          symmetries.push_back(motion);
      }
    }
  }
  return symmetries;
}

}  // namespace spool::campaign
