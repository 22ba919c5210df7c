// Which welds of a spool can be rolled, and in which order most of them stay so.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/guide/roll_welds.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>

#include "vision/guide/centre_line.h"
#include "vision/guide/joint_ends.h"

namespace spool::guide {
namespace {

using Eigen::Vector3d;

constexpr double kOnAxis_m = 0.005;    // a pipe on rolls runs true to that
constexpr double kAlongAxis = 0.9995;  // cosine: 1.8 degrees
constexpr std::size_t kTryAll = 14;

struct Weld {
  int joint = -1, a = -1, b = -1;  // parts
  std::vector<double> reach;       // by part: its furthest point from the weld's axis, m
  std::vector<bool> grips;         // by part: the weld can be turned on it
};

double reach_of(const DesignModel& design, const Part& part, const PortPlace& axis) {
  double reach = 0;
  const auto add = [&](const Vector3d& point) {
    const Vector3d from = point - axis.position;
    reach = std::max(reach, (from - axis.direction * axis.direction.dot(from)).norm());
  };
  for (int p = 0; p < static_cast<int>(part.ports.size()); ++p) add(place_of(part, p).position);
  if (const auto centre = centre_of(part)) add(*centre);
  for (std::uint32_t t = 0; t < part.triangle_count; ++t) {
    for (const auto corner : design.mesh.triangles[part.first_triangle + t])
      add(design.mesh.vertices[corner].cast<double>());
  }
  return reach;
}

bool grips(const Part& part, const PortPlace& axis, const RollRules& rules) {
  if (part.kind != PartKind::kPipe && part.kind != PartKind::kFlange &&
      part.kind != PartKind::kBlind)
    return false;
  for (int p = 0; p < static_cast<int>(part.ports.size()); ++p) {
    const PortPlace own = place_of(part, p);
    if (std::abs(own.direction.dot(axis.direction)) < kAlongAxis) continue;
    const Vector3d from = own.position - axis.position;
    if ((from - axis.direction * axis.direction.dot(from)).norm() > kOnAxis_m) continue;
    if (part.kind != PartKind::kPipe) return true;
    const int other = opposite_port(part, p);
    if (other >= 0 && (place_of(part, other).position - own.position).norm() >= rules.least_grip_m)
      return true;
  }
  return false;
}

std::string metres_text(double length) {
  char text[16];
  std::snprintf(text, sizeof text, "%.2f m", length);
  return text;
}

class Planner {
 public:
  Planner(const DesignModel& design, const RollRules& rules) : design_(design), rules_(rules) {}

  RollPlan plan() {
    for (int j = 0; j < static_cast<int>(design_.joints.size()); ++j) add(j);
    const std::size_t count = welds_.size();
    std::vector<bool> done(count, false);
    RollPlan plan;
    plan.is_best = count <= kTryAll;
    if (plan.is_best) best_.assign(std::size_t{1} << count, -1);
    while (true) {
      const int next = plan.is_best ? best_next(done) : greedy_next(done);
      if (next < 0) break;
      done[static_cast<std::size_t>(next)] = true;
      const Weld& weld = welds_[static_cast<std::size_t>(next)];
      plan.order.push_back({weld.joint, true, swing(next, done), ""});
      ++plan.rolled;
    }
    for (int w = 0; w < static_cast<int>(count); ++w) {
      if (done[static_cast<std::size_t>(w)]) continue;
      done[static_cast<std::size_t>(w)] = true;
      const Weld& weld = welds_[static_cast<std::size_t>(w)];
      plan.order.push_back({weld.joint, false, swing(w, done), why_not(w, done)});
    }
    plan.order.insert(plan.order.end(), in_place_.begin(), in_place_.end());
    return plan;
  }

 private:
  void add(int index) {
    const Joint& joint = design_.joints[static_cast<std::size_t>(index)];
    const auto part_count = static_cast<int>(design_.parts.size());
    if (joint.weld.empty() || joint.part_a < 0 || joint.part_b < 0 || joint.part_a >= part_count ||
        joint.part_b >= part_count)
      return;
    if (joint.type != JointType::kFab) {
      in_place_.push_back({index, false, 0,
                           joint.type == JointType::kYaw ? "yard weld, made in the module"
                                                         : "site weld, made where it stands"});
      return;
    }
    for (const auto& [part, port] :
         {std::pair{joint.part_a, joint.port_a}, {joint.part_b, joint.port_b}}) {
      const Part& own = design_.parts[static_cast<std::size_t>(part)];
      if (own.kind == PartKind::kPipe && own.ports.size() > 2 && opposite_port(own, port) < 0) {
        in_place_.insert(in_place_.begin() + branches_++,
                         {index, false, 0, "branch weld on the side of " + own.name});
        return;
      }
    }
    const PortPlace axis =
        place_of(design_.parts[static_cast<std::size_t>(joint.part_a)], joint.port_a);
    Weld weld{index, joint.part_a, joint.part_b, {}, {}};
    for (const Part& part : design_.parts) {
      weld.reach.push_back(reach_of(design_, part, axis));
      weld.grips.push_back(grips(part, axis, rules_));
    }
    welds_.push_back(std::move(weld));
  }

  // What hangs together with a weld's parts once it is made; which of the others are made is told.
  std::vector<bool> group(int weld, const std::vector<bool>& done) const {
    std::vector<bool> in(design_.parts.size(), false);
    const Weld& own = welds_[static_cast<std::size_t>(weld)];
    in[static_cast<std::size_t>(own.a)] = in[static_cast<std::size_t>(own.b)] = true;
    for (bool grows = true; grows;) {
      grows = false;
      for (std::size_t w = 0; w < welds_.size(); ++w) {
        if (!done[w]) continue;
        const auto a = static_cast<std::size_t>(welds_[w].a);
        const auto b = static_cast<std::size_t>(welds_[w].b);
        if (in[a] == in[b]) continue;
        in[a] = in[b] = grows = true;
      }
    }
    return in;
  }

  double swing(int weld, const std::vector<bool>& done) const {
    const std::vector<bool> in = group(weld, done);
    double furthest = 0;
    for (std::size_t p = 0; p < in.size(); ++p)
      if (in[p]) furthest = std::max(furthest, welds_[static_cast<std::size_t>(weld)].reach[p]);
    return furthest;
  }

  bool can_roll(int weld, const std::vector<bool>& done) const {
    const std::vector<bool> in = group(weld, done);
    const Weld& own = welds_[static_cast<std::size_t>(weld)];
    bool has_grip = false;
    for (std::size_t p = 0; p < in.size(); ++p) {
      if (!in[p]) continue;
      if (own.reach[p] > rules_.swing_radius_m) return false;
      has_grip = has_grip || own.grips[p];
    }
    return has_grip;
  }

  std::string why_not(int weld, const std::vector<bool>& done) const {
    const std::vector<bool> in = group(weld, done);
    const Weld& own = welds_[static_cast<std::size_t>(weld)];
    std::size_t furthest = 0;
    for (std::size_t p = 0; p < in.size(); ++p)
      if (in[p] && own.reach[p] > (in[furthest] ? own.reach[furthest] : -1)) furthest = p;
    if (own.reach[furthest] > rules_.swing_radius_m)
      return design_.parts[furthest].name + " would swing " + metres_text(own.reach[furthest]) +
             " from its axis";
    return "nothing straight on its axis to turn it on";
  }

  static std::size_t mask_of(const std::vector<bool>& done) {
    std::size_t mask = 0;
    for (std::size_t w = 0; w < done.size(); ++w)
      if (done[w]) mask |= std::size_t{1} << w;
    return mask;
  }

  // How many more welds can be rolled at most (dynamic programming over sets of made welds).
  // Making one that cannot be rolled only makes groups larger, so those wait until the end.
  int best_from(std::vector<bool>& done) {
    int& best = best_[mask_of(done)];
    if (best >= 0) return best;
    int most = 0;
    for (std::size_t w = 0; w < done.size(); ++w) {
      if (done[w] || !can_roll(static_cast<int>(w), done)) continue;
      done[w] = true;
      most = std::max(most, 1 + best_from(done));
      done[w] = false;
    }
    return best_[mask_of(done)] = most;
  }

  int best_next(std::vector<bool>& done) {
    const int most = best_from(done);
    for (std::size_t w = 0; most > 0 && w < done.size(); ++w) {
      if (done[w] || !can_roll(static_cast<int>(w), done)) continue;
      done[w] = true;
      const bool keeps = 1 + best_from(done) == most;
      done[w] = false;
      if (keeps) return static_cast<int>(w);
    }
    return -1;
  }

  int greedy_next(std::vector<bool>& done) const {
    int next = -1, most = -1;
    double least_swing = 0;
    for (std::size_t w = 0; w < done.size(); ++w) {
      if (done[w] || !can_roll(static_cast<int>(w), done)) continue;
      const double own_swing = swing(static_cast<int>(w), done);
      done[w] = true;
      int left = 0;
      for (std::size_t other = 0; other < done.size(); ++other)
        if (!done[other] && can_roll(static_cast<int>(other), done)) ++left;
      done[w] = false;
      if (left < most || (left == most && own_swing >= least_swing - 1e-9)) continue;
      most = left;
      least_swing = own_swing;
      next = static_cast<int>(w);
    }
    return next;
  }

  const DesignModel& design_;
  RollRules rules_;
  std::vector<Weld> welds_;         // of the shop, square to an axis
  std::vector<RollWeld> in_place_;  // the others: branches first
  std::ptrdiff_t branches_ = 0;
  std::vector<int> best_;  // by set of made welds; -1: not known yet
};

}  // namespace

RollPlan plan_roll_welds(const DesignModel& design, const RollRules& rules) {
  return Planner(design, rules).plan();
}

}  // namespace spool::guide
