// The lines and symbols of an isometric: pipes, fittings, flanges, valves, welds, skew triangles.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/guide/isometric_symbols.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "vision/guide/plane_geometry.h"

namespace spool::guide {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kPipe_mm = 0.7, kThin_mm = 0.35;  // line widths, ISO 128: heavy and medium
constexpr double kBreak_mm = 1.3;                  // to each side of a leg that passes before

class Symbols {
 public:
  Symbols(const DesignModel& design, const CentreLine& line, const IsometricLayout& layout)
      : design_(design),
        line_(line),
        layout_(layout),
        axes_(isometric_axes(layout.quarter)),
        unit_(std::clamp(layout.scale, 0.5, 1.3)) {}

  std::vector<Stroke> draw() {
    for (int e = 0; e < static_cast<int>(line_.edges.size()); ++e) {
      const LineEdge& edge = line_.edges[static_cast<std::size_t>(e)];
      const Part& part = design_.parts[static_cast<std::size_t>(edge.part)];
      if (part.kind == PartKind::kElbow && centre_of(part)) continue;  // its bend is drawn whole
      switch (part.kind) {
        case PartKind::kReducer:
        case PartKind::kOlet:
          taper(edge, part);
          break;
        case PartKind::kFlange:
          flange(edge, part);
          break;
        case PartKind::kBlind:
          blind(edge);
          break;
        case PartKind::kCap:
          cap(edge);
          break;
        case PartKind::kValve:
          valve(edge);
          break;
        case PartKind::kGasket:
          break;  // the gap between two faces
        default:
          broken_line(e);
      }
    }
    bends();
    for (const LineNode& node : line_.nodes) {
      if (node.joint < 0 || joint(node).weld.empty()) continue;
      for (Stroke& each : weld_mark(joint(node).type, at(index_of(node)), unit_))
        strokes_.push_back(std::move(each));
    }
    return std::move(strokes_);
  }

 private:
  const Joint& joint(const LineNode& node) const {
    return design_.joints[static_cast<std::size_t>(node.joint)];
  }
  int index_of(const LineNode& node) const { return static_cast<int>(&node - line_.nodes.data()); }
  const Vector2d& at(int node) const { return layout_.places[static_cast<std::size_t>(node)]; }
  const Vector3d& drawn(int node) const { return layout_.drawn[static_cast<std::size_t>(node)]; }

  void stroke(std::vector<Vector2d> points, double width, bool is_closed = false,
              Stroke::Fill fill = Stroke::Fill::kNone) {
    strokes_.push_back({std::move(points), width, is_closed, fill, false});
  }

  // The unit direction on paper in which something square to an edge is drawn: along an axis that
  // it does not run along, upright if it can be; square on paper where the leg is skew.
  Vector2d across(const LineEdge& edge) const {
    const Vector3d along = (drawn(edge.to) - drawn(edge.from)).normalized();
    if (along.cwiseAbs().maxCoeff() < 0.99) {
      const Vector2d leg = (at(edge.to) - at(edge.from)).normalized();
      return {-leg.y(), leg.x()};
    }
    int axis = 2;
    if (std::abs(along.z()) > 0.7) axis = std::abs(along.x()) < std::abs(along.y()) ? 0 : 1;
    return axes_.col(axis).normalized();
  }

  // Where nearer legs pass before this edge it is left open.
  void broken_line(int index) {
    const LineEdge& edge = line_.edges[static_cast<std::size_t>(index)];
    const Vector2d a = at(edge.from), b = at(edge.to);
    const double length = (b - a).norm();
    if (length < 1e-9) return;
    std::vector<std::pair<double, double>> gaps;
    const Vector3d eye = towards_eye(layout_.quarter);
    for (const LineEdge& other : line_.edges) {
      if (other.from == edge.from || other.from == edge.to || other.to == edge.from ||
          other.to == edge.to)
        continue;
      const auto hit = crossing({a, b}, {at(other.from), at(other.to)});
      if (!hit) continue;
      const Vector3d own = drawn(edge.from) + hit->of_first * (drawn(edge.to) - drawn(edge.from));
      const Vector3d its =
          drawn(other.from) + hit->of_second * (drawn(other.to) - drawn(other.from));
      if (eye.dot(its - own) <= 1e-6) continue;
      const double half = kBreak_mm * unit_ / length;
      gaps.emplace_back(hit->of_first - half, hit->of_first + half);
    }
    std::sort(gaps.begin(), gaps.end());
    double from = 0;
    for (const auto& [begin, end] : gaps) {
      if (begin > from) stroke({a + from * (b - a), a + begin * (b - a)}, kPipe_mm);
      from = std::max(from, end);
    }
    if (from < 1) stroke({a + from * (b - a), b}, kPipe_mm);
  }

  // A fitting from a wide end to a narrow one: a reducer, a branch fitting on its run.
  void taper(const LineEdge& edge, const Part& part) {
    Vector2d wide = at(edge.from), narrow = at(edge.to);
    if (part.kind == PartKind::kOlet) {
      // Its foot is on the run.
      if (line_.nodes[static_cast<std::size_t>(edge.to)].part >= 0) std::swap(wide, narrow);
    } else if (part.ports.size() == 2 && part.ports[0].nps < part.ports[1].nps) {
      std::swap(wide, narrow);
    }
    const Vector2d side = unit_ * across(edge);
    stroke({wide + 1.9 * side, wide - 1.9 * side, narrow - 1.0 * side, narrow + 1.0 * side},
           kThin_mm, true, Stroke::Fill::kPaper);
    stroke({wide, narrow}, kThin_mm);
  }

  bool is_face(const LineEdge& edge, int node) const {
    const Part& part = design_.parts[static_cast<std::size_t>(edge.part)];
    const LineNode& own = line_.nodes[static_cast<std::size_t>(node)];
    int port = own.open_part == edge.part ? own.open_port : -1;
    if (own.joint >= 0) {
      if (joint(own).part_a == edge.part) port = joint(own).port_a;
      if (joint(own).part_b == edge.part) port = joint(own).port_b;
    }
    if (port < 0) return false;
    const Port& its = part.ports[static_cast<std::size_t>(port)];
    return its.end == EndType::kFlanged || its.name == "face";
  }

  void flange(const LineEdge& edge, const Part&) {
    Vector2d hub = at(edge.from), face = at(edge.to);
    if (is_face(edge, edge.from)) std::swap(hub, face);
    const Vector2d side = unit_ * across(edge);
    const Vector2d back = face + 0.45 * (hub - face);
    stroke({hub, back}, kPipe_mm);
    stroke({hub + 0.4 * side, back + 1.4 * side, back - 1.4 * side, hub - 0.4 * side}, kThin_mm,
           true, Stroke::Fill::kPaper);
    stroke({back + 3.0 * side, face + 3.0 * side, face - 3.0 * side, back - 3.0 * side}, kThin_mm,
           true, Stroke::Fill::kPaper);
    stroke({face + 3.0 * side, face - 3.0 * side}, kPipe_mm);
  }

  void blind(const LineEdge& edge) {
    const Vector2d side = 3.0 * unit_ * across(edge);
    stroke({at(edge.from) + side, at(edge.to) + side, at(edge.to) - side, at(edge.from) - side},
           kPipe_mm, true, Stroke::Fill::kInk);
  }

  void cap(const LineEdge& edge) {
    const Vector2d side = 1.8 * unit_ * across(edge);
    const Vector2d along = 1.8 * unit_ * (at(edge.to) - at(edge.from)).normalized();
    std::vector<Vector2d> dome;
    for (int k = 0; k <= 12; ++k) {
      const double angle = std::numbers::pi * k / 12;
      dome.push_back(at(edge.from) + std::cos(angle) * side + std::sin(angle) * along);
    }
    stroke(std::move(dome), kThin_mm, true, Stroke::Fill::kInk);
  }

  void valve(const LineEdge& edge) {
    const Vector2d a = at(edge.from), b = at(edge.to), side = 2.6 * unit_ * across(edge);
    stroke({a + side, b - side, b + side, a - side}, kThin_mm, true, Stroke::Fill::kPaper);
    stroke({a + side, a - side}, kThin_mm);
    stroke({b + side, b - side}, kThin_mm);
  }

  // Elbows: from end to end round the corner (a quadratic curve through its polygon).
  void bends() {
    for (int part = 0; part < static_cast<int>(design_.parts.size()); ++part) {
      const Part& own = design_.parts[static_cast<std::size_t>(part)];
      if (own.kind != PartKind::kElbow || !centre_of(own)) continue;
      std::vector<int> ends;
      int corner = -1;
      for (const LineEdge& edge : line_.edges) {
        if (edge.part != part) continue;
        ends.push_back(edge.from);
        corner = edge.to;
      }
      if (ends.size() != 2 || corner < 0) continue;
      std::vector<Vector2d> curve;
      for (int k = 0; k <= 10; ++k) {
        const double t = 0.1 * k;
        curve.push_back((1 - t) * (1 - t) * at(ends[0]) + 2 * t * (1 - t) * at(corner) +
                        t * t * at(ends[1]));
      }
      stroke(std::move(curve), kPipe_mm);
    }
  }

  const DesignModel& design_;
  const CentreLine& line_;
  const IsometricLayout& layout_;
  Eigen::Matrix<double, 2, 3> axes_;
  double unit_;  // of symbols, mm
  std::vector<Stroke> strokes_;
};

}  // namespace

std::vector<Stroke> isometric_symbols(const DesignModel& design, const CentreLine& line,
                                      const IsometricLayout& layout) {
  return Symbols(design, line, layout).draw();
}

std::vector<Stroke> weld_mark(JointType type, const Vector2d& at, double scale) {
  std::vector<Stroke> mark;
  if (type == JointType::kYaw) {
    const double half = 1.5 * scale;
    mark.push_back({{at + Vector2d(0, -half), at + Vector2d(half, 0), at + Vector2d(0, half),
                     at + Vector2d(-half, 0)},
                    0.35,
                    true,
                    Stroke::Fill::kPaper});
    return mark;
  }
  Stroke dot;
  for (int k = 0; k < 16; ++k) {
    const double angle = 2 * std::numbers::pi * k / 16;
    dot.points.emplace_back(at + 0.85 * scale * Vector2d(std::cos(angle), std::sin(angle)));
  }
  dot.width_mm = 0.1;
  dot.is_closed = true;
  dot.fill = Stroke::Fill::kInk;
  mark.push_back(std::move(dot));
  if (type == JointType::kField) {
    const double half = 1.6 * scale;
    for (const double way : {1.0, -1.0})
      mark.push_back({{at - half * Vector2d(1, way), at + half * Vector2d(1, way)}, 0.35});
  }
  return mark;
}

}  // namespace spool::guide
