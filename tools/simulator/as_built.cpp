// A design as it was built: where each part really is.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/simulator/as_built.h"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <optional>

namespace spool::simulator {
namespace {

using Index = std::size_t;

// For each part the one it hangs on (-1: none), and by which of its own ports.
struct Tree {
  std::vector<int> parent;
  std::vector<int> inlet;  // port, -1 where there is no joint
};

// Parts in assembly order; as they stand in the file where that says nothing.
std::vector<int> assembly_order(const DesignModel& design) {
  std::vector<int> order(design.parts.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
    return design.parts[static_cast<Index>(a)].order < design.parts[static_cast<Index>(b)].order;
  });
  return order;
}

Tree tree_of(const DesignModel& design) {
  const Index n = design.parts.size();
  Tree tree{std::vector<int>(n, -1), std::vector<int>(n, -1)};
  const std::vector<int> order = assembly_order(design);
  if (design.joints.empty()) {
    for (Index i = 1; i < n; ++i) tree.parent[static_cast<Index>(order[i])] = order[i - 1];
    return tree;
  }
  std::vector<bool> seen(n, false);
  const auto grow_from = [&](int root) {
    std::vector<int> front = {root};
    seen[static_cast<Index>(root)] = true;
    for (Index at = 0; at < front.size(); ++at)
      for (const Joint& joint : design.joints)
        for (const bool forward : {true, false}) {
          const int from = forward ? joint.part_a : joint.part_b;
          const int to = forward ? joint.part_b : joint.part_a;
          if (from != front[at] || to < 0 || seen[static_cast<Index>(to)]) continue;
          seen[static_cast<Index>(to)] = true;
          tree.parent[static_cast<Index>(to)] = from;
          tree.inlet[static_cast<Index>(to)] = forward ? joint.port_b : joint.port_a;
          front.push_back(to);
        }
  };
  if (!design.datums.empty()) grow_from(design.datums.front());
  for (const int part : order)
    if (!seen[static_cast<Index>(part)]) grow_from(part);
  return tree;
}

// True where `part` hangs on `root`, however far down.
bool hangs_on(const Tree& tree, int part, int root) {
  for (int at = tree.parent[static_cast<Index>(part)]; at >= 0;
       at = tree.parent[static_cast<Index>(at)])
    if (at == root) return true;
  return false;
}

// The pose that turns about `point` and then shifts.
Pose turn_about(const Eigen::Vector3d& point, const AsBuiltChange& change) {
  Pose turn = Pose::Identity();
  turn.linear() = rotation_from_vector(change.rotation_rad);
  turn.translation() = point - turn.linear() * point + change.translation_m;
  return turn;
}

struct Stretch {
  Eigen::Vector3d axis;  // unit, part frame, away from the end that stays
  double middle = 0;     // m along the axis: what lies beyond moves
  Index far_port = 1;
};

std::optional<Stretch> stretch_of(const Part& part, int inlet) {
  if (part.ports.size() < 2) return std::nullopt;
  const Index fixed = inlet == 1 ? 1 : 0;
  const Eigen::Vector3d from = part.ports[fixed].position, to = part.ports[1 - fixed].position;
  if ((to - from).norm() < 1e-6) return std::nullopt;
  const Eigen::Vector3d axis = (to - from).normalized();
  return Stretch{axis, axis.dot(from + to) / 2, 1 - fixed};
}

// The built triangles, part by part.
void add_mesh(const DesignModel& design, const std::vector<std::optional<Stretch>>& stretches,
              AsBuilt& built) {
  for (Index p = 0; p < design.parts.size(); ++p) {
    const Part& part = design.parts[p];
    const BuiltPart& to = built.parts[p];
    if (to.missing) continue;
    const Pose T_part_design = part.T_design_part.inverse();
    for (std::uint32_t t = 0; t < part.triangle_count; ++t) {
      Triangle triangle{};
      for (Index c = 0; c < 3; ++c) {
        const auto vertex = design.mesh.triangles[part.first_triangle + t][c];
        Eigen::Vector3d at = T_part_design * design.mesh.vertices[vertex].cast<double>();
        if (stretches[p] && stretches[p]->axis.dot(at) > stretches[p]->middle)
          at += to.length_m * stretches[p]->axis;
        triangle[c] = static_cast<std::uint32_t>(built.mesh.vertices.size());
        built.mesh.vertices.push_back((to.T_design_part * at).cast<float>());
      }
      built.mesh.triangles.push_back(triangle);
      built.triangle_part.push_back(static_cast<std::int32_t>(p));
    }
  }
}

}  // namespace

Result<AsBuilt> build_as(const DesignModel& design, const std::vector<AsBuiltChange>& changes,
                         const std::string& file) {
  const Tree tree = tree_of(design);
  AsBuilt built;
  for (const Part& part : design.parts) built.parts.push_back({part.T_design_part});
  std::vector<std::optional<Stretch>> stretches(design.parts.size());
  for (const AsBuiltChange& change : changes) {
    const auto refuse = [&](const std::string& why) {
      return Error{ErrorCode::kBadInput, file + ": as_built of part " + change.part + ": " + why};
    };
    const auto found = std::find_if(design.parts.begin(), design.parts.end(),
                                    [&](const Part& part) { return part.name == change.part; });
    if (found == design.parts.end()) return refuse("the design has no such part; correct the name");
    const auto index = static_cast<Index>(found - design.parts.begin());
    BuiltPart& part = built.parts[index];
    part.missing = part.missing || change.missing;
    Eigen::Vector3d pivot = Eigen::Vector3d::Zero();
    if (!change.about.empty()) {
      const auto port = std::find_if(found->ports.begin(), found->ports.end(),
                                     [&](const Port& p) { return p.name == change.about; });
      if (port == found->ports.end()) return refuse("it has no port " + change.about);
      pivot = port->position;
    }
    // What the change does to the part, and to what hangs on its far end, in the design frame.
    const Pose before = part.T_design_part;
    part.T_design_part = before * turn_about(pivot, change);
    Pose beyond = part.T_design_part;
    if (change.length_m != 0) {
      stretches[index] = stretch_of(*found, tree.inlet[index]);
      if (!stretches[index]) return refuse("it has no two ends to be longer between");
      part.length_m += change.length_m;
      part.far_port = stretches[index]->far_port;
      beyond.translation() +=
          part.T_design_part.linear() * (change.length_m * stretches[index]->axis);
    }
    const Pose moved = beyond * before.inverse();
    for (Index other = 0; change.followers && other < built.parts.size(); ++other)
      if (hangs_on(tree, static_cast<int>(other), static_cast<int>(index)))
        built.parts[other].T_design_part = moved * built.parts[other].T_design_part;
  }
  add_mesh(design, stretches, built);
  return built;
}

}  // namespace spool::simulator
