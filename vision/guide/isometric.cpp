// A design's isometric as a flat drawing: lines, symbols, dimensions, and labels that lie on none
// of each other.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/guide/isometric.h"

#include <algorithm>
#include <cmath>

#include "vision/guide/isometric_dimensions.h"
#include "vision/guide/isometric_layout.h"
#include "vision/guide/isometric_symbols.h"
#include "vision/guide/joint_ends.h"

namespace spool::guide {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kMargin_mm = 24;  // round the lines: for dimensions and labels
constexpr double kThin_mm = 0.18;  // dimension lines
constexpr double kPipeCost = 3, kSymbolCost = 1, kHatchCost = 0.25;

std::string millimetres(double length_m) {
  return std::to_string(static_cast<long long>(std::llround(1000 * length_m)));
}

void draw_arrow(const Vector2d& tip, const Vector2d& from, double length, Drawing& drawing) {
  const Vector2d along = (tip - from).normalized(), side(-along.y(), along.x());
  drawing.strokes.push_back({{tip, tip - length * along + 0.18 * length * side,
                              tip - length * along - 0.18 * length * side},
                             0.1,
                             true,
                             Stroke::Fill::kInk});
}

class Page {
 public:
  Page(const DesignModel& design, const IsometricOptions& options, const CentreLine& line)
      : design_(design), options_(options), line_(line) {
    if (!options_.length_text) options_.length_text = millimetres;
    Box2 inner{options.area.min() + Vector2d::Constant(kMargin_mm),
               options.area.max() - Vector2d::Constant(kMargin_mm)};
    if (inner.sizes().minCoeff() < 10) inner = options.area;
    layout_ = lay_out(design, line, inner);
  }

  Isometric draw() {
    made_.quarter = layout_.quarter;
    for (const LineEdge& edge : line_.edges)
      lines_.push_back({{at(edge.from), at(edge.to)}, kPipeCost});
    skews();
    std::vector<Stroke> symbols = isometric_symbols(design_, line_, layout_);
    keep_off(symbols);
    dimensions();
    welds_and_parts();
    if (options_.shows_ends) ends();
    place();
    auto& strokes = made_.drawing.strokes;
    strokes.insert(strokes.end(), std::make_move_iterator(symbols.begin()),
                   std::make_move_iterator(symbols.end()));
    for (const IsometricLabel& each : made_.labels)
      draw_label(each, options_.letters_mm, made_.drawing);
    return std::move(made_);
  }

 private:
  const Vector2d& at(int node) const { return layout_.places[static_cast<std::size_t>(node)]; }

  // The bodies of flanges, valves and other symbols; welds have boxes of their own.
  void keep_off(const std::vector<Stroke>& symbols) {
    for (const Stroke& each : symbols) {
      if (!each.is_closed || each.points.size() != 4) continue;
      for (std::size_t k = 0; k < 4; ++k)
        lines_.push_back({{each.points[k], each.points[(k + 1) % 4]}, kSymbolCost});
    }
  }

  void request(LabelKind kind, std::string text, const Vector2d& anchor,
               const Vector2d& slide = Vector2d::Zero(), JointType type = JointType::kFab) {
    IsometricLabel label;
    label.label = {kind, std::move(text), Vector3d::Zero(), type};
    const bool is_on_line = kind == LabelKind::kDimension || kind == LabelKind::kOffset;
    requests_.push_back({anchor, label_half_size(label.label, options_), is_on_line, slide});
    made_.labels.push_back(std::move(label));
  }

  void skews() {
    std::vector<Stroke> hatch;
    const std::vector<SkewOffset> offsets = skew_offsets(line_, layout_, hatch);
    for (const Stroke& each : hatch)
      lines_.push_back({{each.points.front(), each.points.back()}, kHatchCost});
    made_.drawing.strokes = std::move(hatch);
    for (const SkewOffset& each : offsets) {
      Stroke side{{each.line.a, each.line.b}, kThin_mm};
      side.is_dashed = true;
      made_.drawing.strokes.push_back(std::move(side));
      lines_.push_back({each.line, 0.35});
      const char* names[3][2] = {{"E ", "W "}, {"N ", "S "}, {"UP ", "DOWN "}};
      const std::string way = names[each.axis][each.travel_m < 0 ? 1 : 0];
      request(LabelKind::kOffset, way + options_.length_text(std::abs(each.travel_m)),
              0.5 * (each.line.a + each.line.b), 0.25 * (each.line.b - each.line.a));
    }
  }

  void dimensions() {
    const std::vector<LegLength> lengths = leg_lengths(design_, line_);
    for (const DrawnDimension& each :
         draw_dimensions(line_, layout_, lengths, options_.area, lines_)) {
      auto& strokes = made_.drawing.strokes;
      for (const Segment2& own : {each.line, each.witness_a, each.witness_b})
        strokes.push_back({{own.a, own.b}, kThin_mm});
      const double arrow = std::min(1.8, 0.3 * (each.line.b - each.line.a).norm());
      draw_arrow(each.line.a, each.line.b, arrow, made_.drawing);
      draw_arrow(each.line.b, each.line.a, arrow, made_.drawing);
      request(LabelKind::kDimension, options_.length_text(each.length.length_m),
              0.5 * (each.line.a + each.line.b), 0.25 * (each.line.b - each.line.a));
    }
  }

  // The middle of a part's longest stretch; of a bend the middle of its curve, of a tee its corner.
  Vector2d anchor_of(int part) const {
    Vector2d anchor = options_.area.center(), ends = Vector2d::Zero();
    double longest = -1;
    const Part& own = design_.parts[static_cast<std::size_t>(part)];
    const bool has_centre = centre_of(own).has_value();
    for (const LineEdge& edge : line_.edges) {
      if (edge.part != part) continue;
      ends += at(edge.from);
      const double length = (at(edge.to) - at(edge.from)).norm();
      if (length <= longest) continue;
      longest = length;
      anchor = has_centre ? at(edge.to) : Vector2d(0.5 * (at(edge.from) + at(edge.to)));
    }
    if (has_centre && own.kind == PartKind::kElbow) return 0.5 * anchor + 0.25 * ends;
    return anchor;
  }

  // The labels of welds and parts, at the places that are drawn.
  void welds_and_parts() {
    std::vector<Vector2d> anchors;
    for (std::size_t j = 0; j < design_.joints.size(); ++j) {
      if (design_.joints[j].weld.empty()) continue;
      Vector2d anchor = options_.area.center();
      for (const LineNode& node : line_.nodes)
        if (node.joint == static_cast<int>(j))
          anchor = at(static_cast<int>(&node - line_.nodes.data()));
      anchors.push_back(anchor);
    }
    for (std::size_t p = 0; p < design_.parts.size(); ++p) {
      const Part& part = design_.parts[p];
      if (part.ports.empty() || part.kind == PartKind::kGasket) continue;
      anchors.push_back(anchor_of(static_cast<int>(p)));
    }
    const std::vector<DrawingLabel> labels = weld_and_part_labels(design_);
    for (std::size_t k = 0; k < labels.size() && k < anchors.size(); ++k) {
      request(labels[k].kind, labels[k].text, anchors[k], Vector2d::Zero(), labels[k].weld_type);
      made_.labels.back().label.place = labels[k].place;
    }
  }

  // Open ends stand somewhere in the plant: east, north and elevation.
  void ends() {
    for (std::size_t n = 0; n < line_.nodes.size(); ++n) {
      const LineNode& node = line_.nodes[n];
      if (node.open_part < 0) continue;
      const auto coordinate = [&](const char* plus, const char* minus, double value) {
        return (value < 0 ? minus : plus) + options_.length_text(std::abs(value));
      };
      request(LabelKind::kEnd,
              coordinate("E ", "W ", node.place.x()) + "  " +
                  coordinate("N ", "S ", node.place.y()) + "  " +
                  coordinate("EL +", "EL \u2212", node.place.z()),
              at(static_cast<int>(n)));
    }
  }

  // Short numbers first: they sit on their lines. Then what has a place to keep to.
  void place() {
    const std::vector<PlacedLabel> placed = place_labels(requests_, lines_, marks(), options_.area);
    for (std::size_t k = 0; k < placed.size(); ++k) {
      made_.labels[k].placed = placed[k];
      if (!placed[k].is_placed) ++made_.labels_without_place;
    }
  }

  // What labels never cover: the marks of welds.
  std::vector<Box2> marks() const {
    std::vector<Box2> boxes;
    for (std::size_t n = 0; n < line_.nodes.size(); ++n) {
      const LineNode& node = line_.nodes[n];
      if (node.joint < 0 || design_.joints[static_cast<std::size_t>(node.joint)].weld.empty())
        continue;
      const Vector2d half = Vector2d::Constant(0.8);
      boxes.emplace_back(layout_.places[n] - half, layout_.places[n] + half);
    }
    return boxes;
  }

  const DesignModel& design_;
  IsometricOptions options_;
  const CentreLine& line_;
  IsometricLayout layout_;
  std::vector<LineToAvoid> lines_;
  std::vector<LabelRequest> requests_;
  Isometric made_;
};

}  // namespace

Result<Isometric> draw_isometric(const DesignModel& design, const IsometricOptions& options) {
  const Result<CentreLine> line = centre_line(design, options.compass);
  if (!line) return line.error();
  return Page(design, options, *line).draw();
}

}  // namespace spool::guide
