// The body of a component out of the catalogue, where the file puts it: kinds, ports and marks.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/piping/part_solid.h"

#include <algorithm>

#include "vision/piping/joint_graph.h"
#include "vision/piping/part_bodies.h"

namespace spool::piping {
namespace {

using Eigen::Vector3d;

// The component that a branch fitting sits on; nothing where it sits on none.
const Component* run_of(const Pipework& pipework, int fitting) {
  for (const PipeJoint& joint : pipework.joints) {
    if (joint.port_b == kOnRun && joint.b == fitting)
      return &pipework.components[static_cast<std::size_t>(joint.a)];
  }
  return nullptr;
}

bool is_joined(const Pipework& pipework, int component, int port) {
  return std::any_of(pipework.joints.begin(), pipework.joints.end(), [&](const PipeJoint& joint) {
    return (joint.a == component && joint.port_a == port) ||
           (joint.b == component && joint.port_b == port);
  });
}

bool make_on_run(const Pipework& pipework, int index, PartShape& shape) {
  const Component& olet = pipework.components[static_cast<std::size_t>(index)];
  const Component* run = run_of(pipework, index);
  if (run == nullptr || run->ends.empty()) return false;
  const Vector3d axis = run->ends.back().position - run->ends.front().position;
  if (run->centre && run->kind == ComponentKind::kElbow) return false;  // its axis is no line
  return axis.norm() > 1e-6 &&
         make_olet(olet, run->ends.front().outside_diameter, axis.normalized(), shape);
}

bool make_body(const Pipework& pipework, int index, PartShape& shape) {
  const Component& each = pipework.components[static_cast<std::size_t>(index)];
  switch (each.kind) {
    case ComponentKind::kPipe:
      return make_straight(each, shape);
    case ComponentKind::kElbow:
      return make_elbow(each, shape);
    case ComponentKind::kTee:
    case ComponentKind::kCross:
      return make_branched(each, shape);
    case ComponentKind::kReducer:
      return make_reducer(each, shape);
    case ComponentKind::kFlange:
    case ComponentKind::kBlind:
      return make_flange(each, shape);
    case ComponentKind::kStubEnd:
      return make_stub_end(each, shape);
    case ComponentKind::kCap:
      return make_cap(
          each,
          each.ends.size() == 2 && !is_joined(pipework, index, 0) && is_joined(pipework, index, 1)
              ? 1
              : 0,
          shape);
    case ComponentKind::kGasket:
      return make_gasket(each, shape);
    case ComponentKind::kOlet:
      return make_on_run(pipework, index, shape);
    default:
      return false;
  }
}

std::string port_name(const Component& component, int port) {
  const auto ends = static_cast<int>(component.ends.size());
  if (port >= ends) return port == ends ? "branch" : "branch" + std::to_string(port - ends + 1);
  const bool has_face = component.face >= 0;
  if (has_face) return port == component.face ? "face" : "weld";
  if (component.kind == ComponentKind::kCap) return "weld";
  return port == 0 ? "in" : port == 1 ? "out" : "end" + std::to_string(port + 1);
}

void add_ports(const Pipework& pipework, int index, PartShape& shape) {
  const Component& each = pipework.components[static_cast<std::size_t>(index)];
  const Eigen::Isometry3d T_part_file = shape.T_file_part.inverse();
  const auto add = [&](const std::string& name, const Vector3d& place, const Vector3d& direction,
                       double nps, const std::string& end, int port) {
    if (direction.norm() < 0.5) return;
    shape.ports.push_back({name, T_part_file * place,
                           (T_part_file.linear() * direction).normalized(), nps, end, port});
  };
  for (int p = 0; p < port_count(each); ++p) {
    // A cap's crown and a blind's back are no ends that anything joins.
    const bool is_closed =
        (each.kind == ComponentKind::kCap || each.kind == ComponentKind::kBlind) &&
        each.ends.size() == 2 && !is_joined(pipework, index, p) &&
        (is_joined(pipework, index, 1 - p) || p == 1);
    if (is_closed) continue;
    const PipePoint& point = port_of(each, p);
    add(port_name(each, p), point.position, each.directions[static_cast<std::size_t>(p)], point.nps,
        end_type(each, p), p);
  }
  // Where a branch fitting and its run touch: on the run's outside, along the fitting's axis.
  int fittings = 0;
  for (const PipeJoint& joint : pipework.joints) {
    if (joint.port_b != kOnRun || (joint.a != index && joint.b != index)) continue;
    const Component& run = pipework.components[static_cast<std::size_t>(joint.a)];
    const Component& fitting = pipework.components[static_cast<std::size_t>(joint.b)];
    if (fitting.branches.empty() || run.ends.empty()) continue;
    const Vector3d out = (fitting.branches.front().position - joint.place).normalized();
    const Vector3d surface = joint.place + run.ends.front().outside_diameter / 2 * out;
    const double nps = fitting.branches.front().nps;
    if (joint.a == index)
      add("olet" + std::to_string(++fittings), surface, out, nps, "BW", kOnRun);
    else
      add("run", surface, -out, nps, "BW", kOnRun);
  }
}

void add_marks(const Pipework& pipework, int index, PartShape& shape) {
  const Component& each = pipework.components[static_cast<std::size_t>(index)];
  const Eigen::Isometry3d T_part_file = shape.T_file_part.inverse();
  const auto add = [&](const std::string& type, const Vector3d& place, const Vector3d& direction,
                       double size) {
    if (direction.norm() < 1e-9) return;
    shape.marks.push_back(
        {type, T_part_file * place, (T_part_file.linear() * direction).normalized(), size});
  };
  Vector3d middle = Vector3d::Zero();
  for (int p = 0; p < port_count(each); ++p) middle += port_of(each, p).position / port_count(each);
  if (each.centre) middle = each.centre->position;
  for (const PipePoint& tap : each.taps) {
    // Away from the flange's axis.
    const Vector3d z = shape.T_file_part.linear().col(2);
    const Vector3d out = tap.position - shape.T_file_part.translation();
    add("tap", tap.position, out - out.dot(z) * z, tap.outside_diameter);
  }
  if (each.spindle) add("spindle", middle, *each.spindle, 0);
  if (each.flat_side && each.kind == ComponentKind::kReducer)
    add("flat_side", middle, *each.flat_side, 0);
  for (const LineEnd& end : pipework.line_ends) {
    const bool is_vent = end.keyword == "END-POSITION-VENT";
    if (!end.place || (!is_vent && end.keyword != "END-POSITION-DRAIN")) continue;
    for (int p = 0; p < port_count(each); ++p) {
      if ((port_of(each, p).position - *end.place).norm() > kNearby ||
          is_joined(pipework, index, p))
        continue;
      add(is_vent ? "vent" : "drain", port_of(each, p).position,
          each.directions[static_cast<std::size_t>(p)], port_of(each, p).outside_diameter);
    }
  }
}

void add_sizes(const Pipework& pipework, int index, PartShape& shape) {
  const Component& each = pipework.components[static_cast<std::size_t>(index)];
  double least = 0;
  for (int p = 0; p < port_count(each); ++p) {
    const double nps = port_of(each, p).nps;
    shape.nps = std::max(shape.nps, nps);
    least = p == 0 ? nps : std::min(least, nps);
  }
  const Component* run = run_of(pipework, index);
  if (run != nullptr && !run->ends.empty()) shape.nps = run->ends.front().nps;
  const bool has_second = !each.branches.empty() || least != shape.nps;
  shape.nps2 = !each.branches.empty() ? each.branches.front().nps : has_second ? least : 0;
}

}  // namespace

std::optional<PartShape> shape_of(const Pipework& pipework, int index,
                                  std::vector<Problem>& problems) {
  const Component& each = pipework.components[static_cast<std::size_t>(index)];
  if (!is_body(each)) return std::nullopt;
  PartShape shape;
  if (!make_body(pipework, index, shape)) {
    shape = {};
    if (!make_rods(each, shape)) {
      // A gasket of no thickness is how some writers say that there is one.
      if (each.kind != ComponentKind::kGasket)
        problems.push_back({each.line, mention(each) + " has no length or no bore, so it has no "
                                                       "body; it is left out of the design"});
      return std::nullopt;
    }
    const bool has_own_shape = each.kind != ComponentKind::kValve &&
                               each.kind != ComponentKind::kInstrument &&
                               each.kind != ComponentKind::kLink;
    if (has_own_shape)
      problems.push_back({each.line, mention(each) + " is drawn as a plain body between its ends"});
  }
  add_ports(pipework, index, shape);
  add_marks(pipework, index, shape);
  add_sizes(pipework, index, shape);
  return shape;
}

}  // namespace spool::piping
