// The design as an isometric shows it: nodes and the straight legs between them.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/measure/drawing.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <Eigen/Cholesky>

namespace spool {
namespace {

using Eigen::Vector3d;

struct PortAt {
  int part = -1, port = -1;
  [[nodiscard]] bool operator==(const PortAt&) const = default;
};

struct Walk {
  PortAt start, end;
  int start_node = -1, end_node = -1;
  std::vector<int> parts;
};

const Part& part_of(const DesignModel& design, int part) {
  return design.parts[static_cast<std::size_t>(part)];
}

const Port& port_of(const DesignModel& design, const PortAt& at) {
  return part_of(design, at.part).ports[static_cast<std::size_t>(at.port)];
}

Vector3d place_of(const DesignModel& design, const PortAt& at) {
  return part_of(design, at.part).T_design_part * port_of(design, at).position;
}

Vector3d outward(const DesignModel& design, const PortAt& at) {
  return (part_of(design, at.part).T_design_part.linear() * port_of(design, at).direction)
      .normalized();
}

// What is joined to a port; nothing of a free one.
std::optional<PortAt> beyond(const DesignModel& design, const PortAt& at) {
  for (const Joint& joint : design.joints) {
    const PortAt a{joint.part_a, joint.port_a}, b{joint.part_b, joint.port_b};
    if (a == at) return b;
    if (b == at) return a;
  }
  return std::nullopt;
}

// The point nearest to the lines of all ports (least squares), where they are not parallel.
std::optional<Vector3d> centre_of(const Part& part) {
  if (part.kind != PartKind::kElbow && part.kind != PartKind::kTee && part.kind != PartKind::kCross)
    return std::nullopt;
  Eigen::Matrix3d across = Eigen::Matrix3d::Zero();
  Vector3d sum = Vector3d::Zero();
  for (const Port& port : part.ports) {
    const Vector3d d = port.direction.normalized();
    const Eigen::Matrix3d other = Eigen::Matrix3d::Identity() - d * d.transpose();
    across += other;
    sum += other * port.position;
  }
  // Parallel lines leave a direction open; two lines at 5 degrees have a least value of 0.004.
  const auto solver = across.ldlt();
  if (part.ports.size() < 2 || !(across.determinant() > 1e-3)) return std::nullopt;
  return part.T_design_part * solver.solve(sum);
}

bool is_cap(const Part& part) { return part.kind == PartKind::kCap; }

bool goes_through(const Part& part) {
  return part.ports.size() == 2 && part.kind != PartKind::kOlet &&
         part.kind != PartKind::kSupport && part.kind != PartKind::kStructure;
}

class Builder {
 public:
  explicit Builder(const DesignModel& design) : design_(design) {}

  Drawing build() {
    add_nodes();
    for (std::size_t n = 0; n < starts_.size(); ++n)
      for (const PortAt& start : starts_[n]) add_leg(walk(static_cast<int>(n), start));
    // Pipes with free ends at both ends have no other node.
    for (std::size_t p = 0; p < design_.parts.size(); ++p) {
      const Part& part = design_.parts[p];
      if (part.kind != PartKind::kPipe || !goes_through(part)) continue;
      for (int port = 0; port < 2; ++port)
        if (!beyond(design_, {static_cast<int>(p), port}) &&
            !is_walked({static_cast<int>(p), port}))
          add_leg(walk(-1, {static_cast<int>(p), port}));
    }
    return std::move(drawing_);
  }

 private:
  void add_nodes() {
    node_of_part_.assign(design_.parts.size(), -1);
    for (std::size_t p = 0; p < design_.parts.size(); ++p) {
      const Part& part = design_.parts[p];
      const int face = face_port(part);
      DrawingNode node{.part = static_cast<int>(p)};
      std::vector<PortAt> starts;
      if (face >= 0) {
        node.kind = NodeKind::kFace;
        node.port = face;
        node.point = place_of(design_, {node.part, face});
        for (int port = 0; port < static_cast<int>(part.ports.size()); ++port)
          if (port != face) starts.push_back({node.part, port});
      } else if (const auto centre = centre_of(part)) {
        node.kind = NodeKind::kCentre;
        node.point = *centre;
        for (int port = 0; port < static_cast<int>(part.ports.size()); ++port)
          starts.push_back({node.part, port});
      } else {
        continue;
      }
      node_of_part_[p] = static_cast<int>(drawing_.nodes.size());
      drawing_.nodes.push_back(node);
      starts_.push_back(std::move(starts));
    }
  }

  // From a port outwards; of a pipe's free end inwards, through the pipe.
  std::optional<Walk> walk(int node, const PortAt& start) const {
    Walk way{.start = start, .end = start, .start_node = node, .parts = {start.part}};
    PortAt at = start;
    if (node < 0) at.port = 1 - start.port;
    while (way.parts.size() <= design_.parts.size()) {
      const auto next = beyond(design_, at);
      if (!next) {
        way.end = at;
        return way;
      }
      way.parts.push_back(next->part);
      way.end = *next;
      way.end_node = node_of_part_[static_cast<std::size_t>(next->part)];
      const Part& part = part_of(design_, next->part);
      if (way.end_node >= 0 || is_cap(part)) return way;
      if (!goes_through(part)) return std::nullopt;
      at = {next->part, 1 - next->port};
    }
    return std::nullopt;  // round and round
  }

  int end_node(const PortAt& at) {
    DrawingNode node{.kind = NodeKind::kEnd, .part = at.part, .port = at.port};
    node.point = place_of(design_, at);
    drawing_.nodes.push_back(node);
    return static_cast<int>(drawing_.nodes.size()) - 1;
  }

  [[nodiscard]] bool is_walked(const PortAt& end) const {
    return std::find(ends_.begin(), ends_.end(), end) != ends_.end();
  }

  void add_leg(const std::optional<Walk>& way) {
    if (!way || is_walked(way->start) || is_walked(way->end)) return;
    const Vector3d start = way->start_node >= 0
                               ? drawing_.nodes[static_cast<std::size_t>(way->start_node)].point
                               : place_of(design_, way->start);
    const Vector3d end = way->end_node >= 0
                             ? drawing_.nodes[static_cast<std::size_t>(way->end_node)].point
                             : place_of(design_, way->end);
    DrawingLeg leg;
    leg.direction =
        way->start_node >= 0 ? outward(design_, way->start) : -outward(design_, way->start);
    leg.length_m = (end - start).dot(leg.direction);
    leg.parts = way->parts;
    leg.nps = std::max(port_of(design_, way->start).nps, port_of(design_, way->end).nps);
    bool is_straight = leg.length_m > 0;
    for (const int p : way->parts) {
      const Part& part = part_of(design_, p);
      if (part.kind == PartKind::kPipe) leg.pipes.push_back(p);
      if (!goes_through(part) || node_of_part_[static_cast<std::size_t>(p)] >= 0) continue;
      leg.nps = std::max(leg.nps, part.nps);
      for (int port = 0; port < 2; ++port)  // what is passed has to lie along the leg
        is_straight =
            is_straight && std::abs(outward(design_, {p, port}).dot(leg.direction)) > 0.99999;
    }
    if (!is_straight) return;
    ends_.push_back(way->start);
    ends_.push_back(way->end);
    leg.from = way->start_node >= 0 ? way->start_node : end_node(way->start);
    leg.to = way->end_node >= 0 ? way->end_node : end_node(way->end);
    const int index = static_cast<int>(drawing_.legs.size());
    drawing_.nodes[static_cast<std::size_t>(leg.from)].legs.push_back(index);
    drawing_.nodes[static_cast<std::size_t>(leg.to)].legs.push_back(index);
    drawing_.legs.push_back(std::move(leg));
  }

  const DesignModel& design_;
  Drawing drawing_;
  std::vector<int> node_of_part_;
  std::vector<std::vector<PortAt>> starts_;  // of each node of a part
  std::vector<PortAt> ends_;                 // of all legs so far
};

}  // namespace

Drawing drawing_of(const DesignModel& design) { return Builder(design).build(); }

std::string name_of(const DrawingNode& node, const DesignModel& design) {
  const Part& part = part_of(design, node.part);
  if (node.kind == NodeKind::kCentre) return part.name + "/centre";
  return part.name + "/" + part.ports[static_cast<std::size_t>(node.port)].name;
}

int face_port(const Part& part) {
  if (part.kind != PartKind::kFlange && part.kind != PartKind::kBlind) return -1;
  for (std::size_t i = 0; i < part.ports.size(); ++i)
    if (part.ports[i].end == EndType::kFlanged) return static_cast<int>(i);
  return -1;
}

}  // namespace spool
