// In which order the parts of a spool are put together, and why an order would not do.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/guide/assembly_order.h"

#include <algorithm>
#include <array>
#include <functional>
#include <numeric>
#include <queue>
#include <tuple>

#include "vision/guide/joint_ends.h"

namespace spool::guide {
namespace {

using Ends = std::vector<std::vector<JointEnd>>;

const Part& part_at(const DesignModel& design, int part) {
  return design.parts[static_cast<std::size_t>(part)];
}

// A straight run: how heavy, and its last part on either side.
struct Run {
  double weight = 0;
  std::array<int, 2> last{-1, -1};
};

double weight_of(const Part& pipe, int port) {
  const int other = opposite_port(pipe, port);
  if (pipe.kind != PartKind::kPipe || other < 0) return 0;
  const double length = (pipe.ports[static_cast<std::size_t>(port)].position -
                         pipe.ports[static_cast<std::size_t>(other)].position)
                            .norm();
  return length * std::max(pipe.nps, 1.0);  // a size that is not known counts as the smallest
}

// Follows the run out of a part's port; gives the last part in line.
int follow(const DesignModel& design, const Ends& ends, int part, int port, double& weight) {
  for (std::size_t steps = 0; steps < design.parts.size(); ++steps) {  // a ring of joints ends too
    const auto joint = at_port(ends[static_cast<std::size_t>(part)], port);
    if (!joint) return part;
    const Part& next = part_at(design, joint->neighbour);
    const int onward = opposite_port(next, joint->neighbour_port);
    if (onward < 0 && next.ports.size() > 1) return part;  // it turns off
    weight += weight_of(next, joint->neighbour_port);
    part = joint->neighbour;
    if (onward < 0) return part;  // a cap
    port = onward;
  }
  return part;
}

// All groups of connected parts: the group of each part.
std::vector<int> groups_of(const DesignModel& design, const Ends& ends) {
  std::vector<int> group(design.parts.size(), -1);
  for (std::size_t first = 0; first < group.size(); ++first) {
    if (group[first] >= 0) continue;
    std::vector<std::size_t> open{first};
    group[first] = static_cast<int>(first);
    while (!open.empty()) {
      const std::size_t part = open.back();
      open.pop_back();
      for (const JointEnd& end : ends[part]) {
        int& other = group[static_cast<std::size_t>(end.neighbour)];
        if (other >= 0) continue;
        other = static_cast<int>(first);
        open.push_back(static_cast<std::size_t>(end.neighbour));
      }
    }
  }
  return group;
}

std::vector<int> given_order(const DesignModel& design) {
  std::vector<int> order(design.parts.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
    return part_at(design, a).order < part_at(design, b).order;
  });
  for (const Part& part : design.parts) {
    if (part.order < 0) return {};
  }
  return order;
}

// Adds all that is connected with `first` to the order, nearest first.
void grow(const DesignModel& design, const Ends& ends, int first, std::vector<bool>& stands,
          std::vector<int>& order) {
  // What may come next: site joints last, then nearness to the base, then the file's order.
  using Rank = std::tuple<bool, int, int>;
  std::priority_queue<Rank, std::vector<Rank>, std::greater<>> next;
  next.push({false, 0, first});
  while (!next.empty()) {
    const auto [by_site_joint, depth, part] = next.top();
    next.pop();
    if (stands[static_cast<std::size_t>(part)]) continue;  // it came by another joint
    stands[static_cast<std::size_t>(part)] = true;
    order.push_back(part);
    for (const JointEnd& end : ends[static_cast<std::size_t>(part)]) {
      const bool is_site =
          design.joints[static_cast<std::size_t>(end.joint)].type != JointType::kFab;
      next.push({is_site, depth + 1, end.neighbour});
    }
  }
}

}  // namespace

int base_part(const DesignModel& design) {
  for (const int datum : design.datums) {
    if (datum >= 0 && datum < static_cast<int>(design.parts.size())) return datum;
  }
  if (design.parts.empty()) return -1;
  const Ends ends = joint_ends(design);
  Run heaviest;
  for (int p = 0; p < static_cast<int>(design.parts.size()); ++p) {
    const Part& pipe = part_at(design, p);
    if (pipe.kind != PartKind::kPipe || pipe.ports.empty()) continue;
    const int other = opposite_port(pipe, 0);
    if (other < 0) continue;
    Run run{weight_of(pipe, 0), {p, p}};
    run.last = {follow(design, ends, p, 0, run.weight), follow(design, ends, p, other, run.weight)};
    if (run.weight > heaviest.weight * (1 + 1e-9)) heaviest = run;
  }
  if (heaviest.last[0] < 0) return 0;
  const auto rank = [&](int part) {
    return std::tuple{part_at(design, part).kind != PartKind::kFlange,
                      ends[static_cast<std::size_t>(part)].size(), part};
  };
  return std::min(heaviest.last[0], heaviest.last[1],
                  [&](int a, int b) { return rank(a) < rank(b); });
}

std::vector<int> propose_order(const DesignModel& design) {
  if (design.parts.empty()) return {};
  std::vector<int> given = given_order(design);
  if (!given.empty() && order_faults(design, given).empty()) return given;
  const Ends ends = joint_ends(design);
  std::vector<bool> stands(design.parts.size(), false);
  std::vector<int> order;
  grow(design, ends, base_part(design), stands, order);
  for (std::size_t p = 0; p < stands.size(); ++p) {
    if (!stands[p]) grow(design, ends, static_cast<int>(p), stands, order);
  }
  return order;
}

std::vector<OrderFault> order_faults(const DesignModel& design, const std::vector<int>& order) {
  std::vector<OrderFault> faults;
  const Ends ends = joint_ends(design);
  const std::vector<int> group = groups_of(design, ends);
  std::vector<bool> stands(design.parts.size(), false), is_begun(design.parts.size(), false);
  for (std::size_t s = 0; s < order.size(); ++s) {
    const int step = static_cast<int>(s);
    if (order[s] < 0 || order[s] >= static_cast<int>(design.parts.size())) {
      faults.push_back({step, "the design has no part " + std::to_string(order[s])});
      continue;
    }
    const auto part = static_cast<std::size_t>(order[s]);
    const std::string& name = design.parts[part].name;
    if (stands[part]) {
      faults.push_back({step, name + " stands already"});
      continue;
    }
    const bool joins = std::any_of(ends[part].begin(), ends[part].end(), [&](const JointEnd& end) {
      return stands[static_cast<std::size_t>(end.neighbour)];
    });
    const auto own_group = static_cast<std::size_t>(group[part]);
    if (!joins && is_begun[own_group]) {
      std::string neighbours;
      for (const JointEnd& end : ends[part]) {
        const std::string& other = part_at(design, end.neighbour).name;
        neighbours += (neighbours.empty() ? "" : " or ") + other;
      }
      faults.push_back({step, name + " would join nothing that stands by then; it joins " +
                                  neighbours + ", which comes later"});
    }
    stands[part] = true;
    is_begun[own_group] = true;
  }
  for (std::size_t p = 0; p < stands.size(); ++p) {
    if (!stands[p])
      faults.push_back({static_cast<int>(order.size()), design.parts[p].name + " is in no step"});
  }
  return faults;
}

Result<std::vector<int>> move_step(const DesignModel& design, const std::vector<int>& order,
                                   int from, int to) {
  const int count = static_cast<int>(order.size());
  if (from < 0 || from >= count || to < 0 || to >= count)
    return Error{ErrorCode::kUsage, "there are steps 1 to " + std::to_string(count) +
                                        "; a step can be moved among those only"};
  std::vector<int> moved = order;
  const int part = moved[static_cast<std::size_t>(from)];
  moved.erase(moved.begin() + from);
  moved.insert(moved.begin() + to, part);
  const std::vector<OrderFault> faults = order_faults(design, moved);
  if (!faults.empty())
    return Error{ErrorCode::kUsage, "step " + std::to_string(faults.front().step + 1) +
                                        " cannot be done then: " + faults.front().reason};
  return moved;
}

}  // namespace spool::guide
