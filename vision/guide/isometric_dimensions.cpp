// The dimensions of an isometric: between the places of each leg that a fitter measures between.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/guide/isometric_dimensions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace spool::guide {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kHatch_mm = 1.6;

bool is_flanged(const DesignModel& design, const LineNode& node) {
  const auto looks = [&](int part, int port) {
    if (part < 0 || port < 0) return false;
    const Port& own =
        design.parts[static_cast<std::size_t>(part)].ports[static_cast<std::size_t>(port)];
    return own.end == EndType::kFlanged || own.name == "face";
  };
  if (node.joint < 0) return looks(node.open_part, node.open_port);
  const Joint& joint = design.joints[static_cast<std::size_t>(node.joint)];
  return looks(joint.part_a, joint.port_a) || looks(joint.part_b, joint.port_b);
}

// Whether a dimension ends at this node in the middle of a leg.
bool is_measured_to(const DesignModel& design, const CentreLine& line, const LineRun& run,
                    std::size_t n) {
  const LineNode& node = line.nodes[static_cast<std::size_t>(run.nodes[n])];
  if (node.part >= 0 || is_flanged(design, node)) return true;
  if (node.joint >= 0) {
    const Joint& joint = design.joints[static_cast<std::size_t>(node.joint)];
    if (!joint.weld.empty() && joint.type != JointType::kFab) return true;
  }
  const auto kind = [&](std::size_t e) {
    const LineEdge& edge = line.edges[static_cast<std::size_t>(run.edges[e])];
    return design.parts[static_cast<std::size_t>(edge.part)].kind;
  };
  return kind(n - 1) == PartKind::kReducer || kind(n) == PartKind::kReducer;
}

// The hatched area between corners, lines parallel to its first side.
void hatch_triangle(const std::array<Vector2d, 3>& corners, std::vector<Stroke>& hatch) {
  const Vector2d base = corners[1] - corners[0];
  const double height =
      std::abs(cross(base, corners[2] - corners[0])) / std::max(base.norm(), 1e-9);
  const int count = static_cast<int>(height / kHatch_mm);
  for (int k = 1; k <= count; ++k) {
    const double t = k * kHatch_mm / height;
    if (t >= 1) break;
    hatch.push_back(
        {{corners[0] + t * (corners[2] - corners[0]), corners[1] + t * (corners[2] - corners[1])},
         0.13});
  }
}

}  // namespace

std::vector<LegLength> leg_lengths(const DesignModel& design, const CentreLine& line) {
  std::vector<LegLength> lengths;
  for (std::size_t r = 0; r < line.runs.size(); ++r) {
    const LineRun& run = line.runs[r];
    const auto kind = [&](std::size_t e) {
      const LineEdge& edge = line.edges[static_cast<std::size_t>(run.edges[e])];
      return design.parts[static_cast<std::size_t>(edge.part)].kind;
    };
    std::size_t first = 0, last = run.nodes.size() - 1;
    if (last > 1 && kind(0) == PartKind::kCap) ++first;
    if (last > first + 1 && kind(last - 1) == PartKind::kCap) --last;
    std::size_t from = first;
    for (std::size_t n = first + 1; n <= last; ++n) {
      if (n < last && !is_measured_to(design, line, run, n)) continue;
      const bool is_gasket = n == from + 1 && kind(from) == PartKind::kGasket;
      const Vector3d way = line.nodes[static_cast<std::size_t>(run.nodes[n])].place -
                           line.nodes[static_cast<std::size_t>(run.nodes[from])].place;
      const double length = way.dot(run.direction);
      if (!is_gasket && length > 1e-4)
        lengths.push_back({static_cast<int>(r), run.nodes[from], run.nodes[n], length});
      from = n;
    }
  }
  return lengths;
}

std::vector<DrawnDimension> draw_dimensions(const CentreLine& line, const IsometricLayout& layout,
                                            const std::vector<LegLength>& lengths, const Box2& area,
                                            std::vector<LineToAvoid>& lines) {
  std::vector<DrawnDimension> drawn;
  const Eigen::Matrix<double, 2, 3> axes = isometric_axes(layout.quarter);
  const auto at = [&](int node) { return layout.places[static_cast<std::size_t>(node)]; };
  for (std::size_t begin = 0; begin < lengths.size();) {
    std::size_t end = begin;
    while (end < lengths.size() && lengths[end].run == lengths[begin].run) ++end;
    const LineRun& run = line.runs[static_cast<std::size_t>(lengths[begin].run)];
    const Vector2d a = at(lengths[begin].from), b = at(lengths[end - 1].to);
    const Vector2d along = (b - a).norm() > 1e-9 ? Vector2d((b - a).normalized()) : Vector2d(1, 0);
    std::vector<Vector2d> ways;
    if (!run.is_skew) {
      for (int axis = 0; axis < 3; ++axis)
        if (std::abs(run.direction[axis]) < 0.5)
          for (const double sign : {1.0, -1.0}) ways.push_back(sign * axes.col(axis));
    } else {
      ways = {{-along.y(), along.x()}, {along.y(), -along.x()}};
    }
    Vector2d best = Vector2d::Zero();
    double least = std::numeric_limits<double>::infinity();
    for (const double reach : {8.0, 12.5, 17.0}) {
      for (const Vector2d& way : ways) {
        const Vector2d out = reach * way;
        const Segment2 moved{a + out, b + out};
        double cost = 0.5 * reach;
        if (!area.contains(moved.a) || !area.contains(moved.b)) cost += 40;
        for (const LineToAvoid& each : lines) {
          // Crossed, or so near along its whole length that its number has no room.
          if (crossing(moved, each.line)) cost += 6 * each.cost;
          for (const double share : {0.15, 0.5, 0.85}) {
            const Vector2d middle = moved.a + share * (moved.b - moved.a);
            const Box2 room{middle - Vector2d(4, 2), middle + Vector2d(4, 2)};
            cost += 0.6 * each.cost * length_within(each.line, room);
          }
        }
        for (const Vector2d& foot : {a, b}) {
          const Segment2 witness{foot + 0.3 * out, foot + out};
          for (const LineToAvoid& each : lines)
            if (crossing(witness, each.line)) cost += 2 * each.cost;
        }
        if (cost >= least - 1e-9) continue;
        least = cost;
        best = out;
      }
    }
    const Vector2d beyond = 1.2 * best.normalized();
    for (std::size_t k = begin; k < end; ++k) {
      DrawnDimension dimension;
      dimension.length = lengths[k];
      const Vector2d from = at(lengths[k].from), to = at(lengths[k].to);
      dimension.line = {from + best, to + best};
      dimension.witness_a = {from + 0.25 * best, from + best + beyond};
      dimension.witness_b = {to + 0.25 * best, to + best + beyond};
      for (const Segment2& each : {dimension.line, dimension.witness_a, dimension.witness_b})
        lines.push_back({each, 0.35});
      drawn.push_back(dimension);
    }
    begin = end;
  }
  return drawn;
}

std::vector<SkewOffset> skew_offsets(const CentreLine& line, const IsometricLayout& layout,
                                     std::vector<Stroke>& hatch) {
  std::vector<SkewOffset> offsets;
  const Eigen::Matrix<double, 2, 3> axes = isometric_axes(layout.quarter);
  for (std::size_t r = 0; r < line.runs.size(); ++r) {
    const LineRun& run = line.runs[r];
    if (!run.is_skew) continue;
    const int first = run.nodes.front(), last = run.nodes.back();
    const Vector3d way = line.nodes[static_cast<std::size_t>(last)].place -
                         line.nodes[static_cast<std::size_t>(first)].place;
    if (way.norm() < kLeastSkew_m) continue;
    Vector3d corner = layout.drawn[static_cast<std::size_t>(first)];
    const Vector3d target = layout.drawn[static_cast<std::size_t>(last)];
    // Places on paper are the drawn ones moved as a whole.
    const Vector2d moved = layout.places[static_cast<std::size_t>(first)] - axes * corner;
    std::vector<Vector2d> corners{moved + axes * corner};
    for (int axis = 0; axis < 3; ++axis) {
      if (std::abs(run.direction[axis]) < 0.01) continue;
      Vector3d next = corner;
      next[axis] = target[axis];
      offsets.push_back(
          {static_cast<int>(r), axis, way[axis], {moved + axes * corner, moved + axes * next}});
      corner = next;
      corners.emplace_back(moved + axes * corner);
    }
    // Level travel as one triangle, the rise on it as another.
    for (std::size_t k = 2; k < corners.size(); ++k)
      hatch_triangle({corners[k - 1], corners[k], corners[0]}, hatch);
    if (corners.size() == 4) hatch.push_back({{corners[0], corners[2]}, 0.18});
  }
  return offsets;
}

}  // namespace spool::guide
