// A design as fitters draw it: the centre lines of its parts, and where they meet.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/guide/centre_line.h"

#include <algorithm>
#include <cmath>

#include "vision/guide/joint_ends.h"

namespace spool::guide {
namespace {

using Eigen::Vector3d;

constexpr double kInLine = 0.9999;    // cosine: 0.8 degrees; a mitre of one degree is a bend
constexpr double kAlong = 0.99996;    // cosine: half a degree, under which a leg is not skew
constexpr double kShort = 1e-6;       // m
constexpr double kLeastTurn = 0.985;  // cosine: 10 degrees; ports nearer in line have no centre

class Builder {
 public:
  Builder(const DesignModel& design, const Compass& compass) : design_(design) {
    axes_ << compass.east.transpose(), compass.north.transpose(), compass.up.transpose();
  }

  CentreLine build() {
    port_node_.resize(design_.parts.size());
    for (std::size_t p = 0; p < design_.parts.size(); ++p)
      port_node_[p].assign(design_.parts[p].ports.size(), -1);
    joints();
    for (int p = 0; p < static_cast<int>(design_.parts.size()); ++p) lines_of(p);
    runs();
    return std::move(line_);
  }

 private:
  const Part& part(int index) const { return design_.parts[static_cast<std::size_t>(index)]; }
  int& node_of(int part, int port) {
    return port_node_[static_cast<std::size_t>(part)][static_cast<std::size_t>(port)];
  }
  int add_node(const Vector3d& place_design, LineNode node) {
    node.place = axes_ * (place_design + design_.origin);
    line_.nodes.push_back(node);
    return static_cast<int>(line_.nodes.size()) - 1;
  }

  // Whether a branch fitting stands here on the side of a pipe: the pipe goes on past it.
  bool is_on_side(int index, int port) const {
    const Part& own = part(index);
    return own.kind == PartKind::kPipe && own.ports.size() > 2 && opposite_port(own, port) < 0;
  }

  void joints() {
    for (const auto& ends : joint_ends(design_)) {
      for (const JointEnd& end : ends) {
        const Joint& joint = design_.joints[static_cast<std::size_t>(end.joint)];
        if (node_of(joint.part_a, joint.port_a) >= 0 || node_of(joint.part_b, joint.port_b) >= 0)
          continue;
        Vector3d place = 0.5 * (place_of(part(joint.part_a), joint.port_a).position +
                                place_of(part(joint.part_b), joint.port_b).position);
        LineNode node;
        node.joint = end.joint;
        for (const auto& [owner, port] :
             {std::pair{joint.part_a, joint.port_a}, {joint.part_b, joint.port_b}}) {
          if (!is_on_side(owner, port)) continue;
          node.part = owner;
          place = foot(owner, place);
        }
        const int made = add_node(place, node);
        node_of(joint.part_a, joint.port_a) = made;
        node_of(joint.part_b, joint.port_b) = made;
      }
    }
  }

  // The nearest place on a pipe's axis.
  Vector3d foot(int index, const Vector3d& place) const {
    const Part& own = part(index);
    for (int port = 0; port < static_cast<int>(own.ports.size()); ++port) {
      if (opposite_port(own, port) < 0) continue;
      const PortPlace end = place_of(own, port);
      return end.position + end.direction * end.direction.dot(place - end.position);
    }
    return place;
  }

  void lines_of(int index) {
    const Part& own = part(index);
    const int count = static_cast<int>(own.ports.size());
    for (int port = 0; port < count; ++port) {
      if (node_of(index, port) >= 0) continue;
      if (is_on_side(index, port)) continue;  // a hole that nothing stands on
      LineNode node;
      node.open_part = index;
      node.open_port = port;
      node_of(index, port) = add_node(place_of(own, port).position, node);
    }
    if (own.kind == PartKind::kPipe) return chain(index);
    if (const auto centre = centre_of(own)) {
      LineNode node;
      node.part = index;
      const int middle = add_node(*centre, node);
      for (int port = 0; port < count; ++port) add_edge(index, node_of(index, port), middle);
      return;
    }
    for (int port = 1; port < count; ++port)
      add_edge(index, node_of(index, 0), node_of(index, port));
    if (count == 1) add_end(index);
  }

  // A cap or blind: from its port as far as its body goes.
  void add_end(int index) {
    const Part& own = part(index);
    const PortPlace port = place_of(own, 0);
    double reach = 0;
    for (std::uint32_t t = 0; t < own.triangle_count; ++t) {
      const auto& triangle = design_.mesh.triangles[own.first_triangle + t];
      for (int corner = 0; corner < 3; ++corner) {
        const Vector3d at =
            design_.mesh.vertices[triangle[static_cast<std::size_t>(corner)]].cast<double>();
        reach = std::max(reach, -port.direction.dot(at - port.position));
      }
    }
    if (reach <= kShort) reach = std::max(0.02, 0.0127 * own.nps);  // about a cap's, B16.9
    LineNode node;
    node.part = index;
    add_edge(index, node_of(index, 0), add_node(port.position - reach * port.direction, node));
  }

  // A pipe with what stands on it, in order along it.
  void chain(int index) {
    std::vector<int> nodes;
    for (const int node : port_node_[static_cast<std::size_t>(index)])
      if (node >= 0) nodes.push_back(node);
    if (nodes.size() < 2) return;
    Vector3d along = Vector3d::Zero();
    for (const int node : nodes) {
      const Vector3d reach = at(node) - at(nodes[0]);
      if (reach.norm() > along.norm()) along = reach;
    }
    std::stable_sort(nodes.begin(), nodes.end(),
                     [&](int a, int b) { return at(a).dot(along) < at(b).dot(along); });
    for (std::size_t n = 1; n < nodes.size(); ++n) add_edge(index, nodes[n - 1], nodes[n]);
  }

  const Vector3d& at(int node) const { return line_.nodes[static_cast<std::size_t>(node)].place; }

  void add_edge(int part, int from, int to) {
    if (from < 0 || to < 0 || from == to) return;
    line_.edges.push_back({from, to, part});
  }

  Vector3d direction(int edge) const {
    const LineEdge& own = line_.edges[static_cast<std::size_t>(edge)];
    const Vector3d along = at(own.to) - at(own.from);
    // An eccentric reducer's ends lie beside each other: its line goes the way its ports look.
    const Part& its = part(own.part);
    if (its.ports.size() == 2 && its.kind != PartKind::kPipe && !centre_of(its)) {
      const Vector3d out = axes_ * (place_of(its, 0).direction);
      return along.dot(out) < 0 ? Vector3d(-out) : out;
    }
    return along.norm() > kShort ? along.normalized() : Vector3d::Zero();
  }

  // Skew legs are read upwards, level ones northwards.
  static bool goes_down(const Vector3d& direction) {
    if (std::abs(direction.z()) > 0.01) return direction.z() < 0;
    return direction.y() < 0;
  }

  void runs() {
    std::vector<std::vector<int>> at_node(line_.nodes.size());
    for (int e = 0; e < static_cast<int>(line_.edges.size()); ++e) {
      at_node[static_cast<std::size_t>(line_.edges[static_cast<std::size_t>(e)].from)].push_back(e);
      at_node[static_cast<std::size_t>(line_.edges[static_cast<std::size_t>(e)].to)].push_back(e);
    }
    std::vector<bool> is_used(line_.edges.size(), false);
    for (int e = 0; e < static_cast<int>(line_.edges.size()); ++e) {
      if (is_used[static_cast<std::size_t>(e)]) continue;
      is_used[static_cast<std::size_t>(e)] = true;
      const LineEdge& first = line_.edges[static_cast<std::size_t>(e)];
      LineRun run;
      run.nodes = {first.from, first.to};
      run.edges = {e};
      run.direction = direction(e);
      for (int side = 0; side < 2; ++side) {
        while (true) {
          const int node = run.nodes.back();
          int next = -1;
          for (const int other : at_node[static_cast<std::size_t>(node)]) {
            if (is_used[static_cast<std::size_t>(other)]) continue;
            const LineEdge& edge = line_.edges[static_cast<std::size_t>(other)];
            const double sign = edge.from == node ? 1 : -1;
            if (sign * direction(other).dot(run.direction) > kInLine) next = other;
          }
          if (next < 0) break;
          is_used[static_cast<std::size_t>(next)] = true;
          const LineEdge& edge = line_.edges[static_cast<std::size_t>(next)];
          run.edges.push_back(next);
          run.nodes.push_back(edge.from == node ? edge.to : edge.from);
        }
        std::reverse(run.nodes.begin(), run.nodes.end());
        std::reverse(run.edges.begin(), run.edges.end());
        run.direction = -run.direction;
      }
      run.is_skew = run.direction.cwiseAbs().maxCoeff() < kAlong;
      if (run.is_skew && goes_down(run.direction)) {
        std::reverse(run.nodes.begin(), run.nodes.end());
        std::reverse(run.edges.begin(), run.edges.end());
        run.direction = -run.direction;
      }
      line_.runs.push_back(std::move(run));
    }
  }

  const DesignModel& design_;
  Eigen::Matrix3d axes_;  // design frame to east, north, up
  std::vector<std::vector<int>> port_node_;
  CentreLine line_;
};

}  // namespace

std::optional<Vector3d> centre_of(const Part& part) {
  for (int a = 0; a < static_cast<int>(part.ports.size()); ++a) {
    for (int b = a + 1; b < static_cast<int>(part.ports.size()); ++b) {
      const PortPlace one = place_of(part, a), other = place_of(part, b);
      const double cosine = one.direction.dot(other.direction);
      if (std::abs(cosine) > kLeastTurn) continue;
      // Nearest places of the two axes (as Ericson 2005, 5.1.8), halfway between.
      const Vector3d between = one.position - other.position;
      const double from_one = one.direction.dot(between), from_other = other.direction.dot(between);
      const double determinant = 1 - cosine * cosine;
      const double s = (cosine * from_other - from_one) / determinant;
      const double t = (from_other - cosine * from_one) / determinant;
      return 0.5 * (one.position + s * one.direction + other.position + t * other.direction);
    }
  }
  return std::nullopt;
}

Result<CentreLine> centre_line(const DesignModel& design, const Compass& compass) {
  const std::string name = design.path.empty() ? "the design" : design.path;
  const bool has_ports = std::any_of(design.parts.begin(), design.parts.end(),
                                     [](const Part& part) { return !part.ports.empty(); });
  if (!has_ports)
    return Error{ErrorCode::kBadInput,
                 name +
                     " does not say what its parts are and where they join, so no isometric can "
                     "be drawn of it; give the .pcf, or a .glb with extras.spoolsight"};
  CentreLine line = Builder(design, compass).build();
  if (line.edges.empty())
    return Error{ErrorCode::kBadInput,
                 name +
                     " has no part with a length between its ports, so no isometric can be "
                     "drawn of it; give the .pcf, or a .glb with ports"};
  return line;
}

}  // namespace spool::guide
