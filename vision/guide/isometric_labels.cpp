// What an isometric's labels say and how they are drawn; its north arrow.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include "vision/guide/isometric.h"
#include "vision/guide/isometric_layout.h"
#include "vision/guide/joint_ends.h"

namespace spool::guide {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kWiderThanLetters = 0.68;  // mean advance of a sans serif's capitals and digits

// Where a part's label points at: its centre, else half way between its ends.
Vector3d middle_of(const Part& part) {
  if (const auto centre = centre_of(part)) return *centre;
  if (part.ports.empty()) return part.T_design_part.translation();
  const int other = opposite_port(part, 0);
  const Vector3d one = place_of(part, 0).position;
  // A cap or blind: within its body, about half its length (B16.9).
  if (other < 0) return one - 0.006 * std::max(part.nps, 1.0) * place_of(part, 0).direction;
  return 0.5 * (one + place_of(part, other).position);
}

}  // namespace

std::vector<DrawingLabel> weld_and_part_labels(const DesignModel& design) {
  std::vector<DrawingLabel> labels;
  for (const Joint& joint : design.joints) {
    if (joint.weld.empty()) continue;
    std::string text = joint.weld;
    if (joint.type == JointType::kField) text += " FW";
    if (joint.type == JointType::kYaw) text += " YAW";
    const Vector3d place =
        0.5 *
        (place_of(design.parts.at(static_cast<std::size_t>(joint.part_a)), joint.port_a).position +
         place_of(design.parts.at(static_cast<std::size_t>(joint.part_b)), joint.port_b).position);
    labels.push_back({LabelKind::kWeld, text, place, joint.type});
  }
  for (const Part& part : design.parts) {
    if (part.ports.empty() || part.kind == PartKind::kGasket) continue;
    labels.push_back({LabelKind::kPart, part.name, middle_of(part), JointType::kFab});
  }
  return labels;
}

Vector2d label_half_size(const DrawingLabel& label, const IsometricOptions& options) {
  const double width = options.text_width_mm ? options.text_width_mm(label.text, options.letters_mm)
                                             : kWiderThanLetters * options.letters_mm *
                                                   static_cast<double>(label.text.size());
  const bool has_frame = label.kind == LabelKind::kWeld || label.kind == LabelKind::kPart;
  const double round = label.kind == LabelKind::kWeld ? 0.9 : 0.6;
  return {0.5 * width + (has_frame ? round : 0.3),
          0.6 * options.letters_mm + (has_frame ? 0.25 : 0.0)};
}

void draw_label(const IsometricLabel& label, double letters_mm, Drawing& drawing) {
  if (!label.placed.is_placed) return;
  const Box2& box = label.placed.box;
  if (label.placed.needs_leader) {
    const Vector2d at = label.placed.leader.a;
    drawing.strokes.push_back({{at, label.placed.leader.b}, 0.15});
    drawing.strokes.push_back({{at, at + Vector2d(0.001, 0)}, 0.7});  // a dot at what it names
  }
  const bool is_weld = label.label.kind == LabelKind::kWeld;
  if (is_weld || label.label.kind == LabelKind::kPart) {
    Stroke frame;
    frame.width_mm = is_weld ? 0.25 : 0.15;
    frame.is_closed = true;
    frame.fill = Stroke::Fill::kPaper;
    if (is_weld) {
      const double radius = 0.5 * box.sizes().y();
      for (int k = 0; k <= 16; ++k) {
        const double angle = std::numbers::pi * (k % 17) / 16 - 0.5 * std::numbers::pi;
        frame.points.emplace_back(box.max().x() - radius + radius * std::cos(angle),
                                  box.center().y() + radius * std::sin(angle));
      }
      for (int k = 0; k <= 16; ++k) {
        const double angle = std::numbers::pi * k / 16 + 0.5 * std::numbers::pi;
        frame.points.emplace_back(box.min().x() + radius + radius * std::cos(angle),
                                  box.center().y() + radius * std::sin(angle));
      }
    } else {
      frame.points = {
          box.min(), {box.max().x(), box.min().y()}, box.max(), {box.min().x(), box.max().y()}};
    }
    drawing.strokes.push_back(std::move(frame));
  }
  drawing.texts.push_back(
      {label.label.text, box.center(), 0.5 * box.sizes(), letters_mm,
       label.label.kind != LabelKind::kWeld && label.label.kind != LabelKind::kPart});
}

void draw_north(int quarter, const Vector2d& centre, Drawing& drawing) {
  const Vector2d north = isometric_axes(quarter).col(1).normalized();
  const Vector2d east = isometric_axes(quarter).col(0).normalized();
  const Vector2d tip = centre + 9 * north, tail = centre - 9 * north;
  drawing.strokes.push_back({{tail, tip}, 0.5});
  drawing.strokes.push_back({{tip, tip - 5 * north + 2.2 * east, tip - 5 * north - 2.2 * east},
                             0.3,
                             true,
                             Stroke::Fill::kInk});
  drawing.strokes.push_back({{centre - 4 * east, centre + 4 * east}, 0.25});
  drawing.texts.push_back({"N", tip + 3.5 * north, {1.6, 2.2}, 4.0, false});
  drawing.texts.push_back({"E", centre + 6 * east, {1.2, 1.6}, 2.5, false});
}

}  // namespace spool::guide
