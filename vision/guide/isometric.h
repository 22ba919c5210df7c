// A design's isometric as a flat drawing: lines, symbols, dimensions, and labels that lie on none
// of each other.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "vision/core/result.h"
#include "vision/guide/centre_line.h"
#include "vision/guide/drawing.h"
#include "vision/guide/label_placement.h"

namespace spool::guide {

struct IsometricOptions {
  Box2 area{Eigen::Vector2d(0, 0), Eigen::Vector2d(280, 270)};  // mm on paper
  double letters_mm = 2.5;                                      // height of the letters' body
  Compass compass;
  bool shows_ends = true;  // the coordinates of open ends
  // A length (m) as the drawing writes it; unset: whole millimetres.
  std::function<std::string(double)> length_text;
  // The width (mm) of a text of a height (mm); unset: an estimate on the wide side.
  std::function<double(const std::string&, double)> text_width_mm;
};

enum class LabelKind { kDimension, kWeld, kPart, kOffset, kEnd };

// What a label says, and of what.
struct DrawingLabel {
  LabelKind kind = LabelKind::kPart;
  std::string text;
  Eigen::Vector3d place = Eigen::Vector3d::Zero();  // of what it names, design frame, m
  JointType weld_type = JointType::kFab;
};

struct IsometricLabel {
  DrawingLabel label;
  PlacedLabel placed;
};

struct Isometric {
  Drawing drawing;
  int quarter = 0;  // the side it is drawn from (isometric_axes())
  std::vector<IsometricLabel> labels;
  int labels_without_place = 0;  // the area was too small: what is missing must be told
};

// The labels of welds ("W1", "W8 FW", "W9 YAW") and parts (their names), in that order.
[[nodiscard]] std::vector<DrawingLabel> weld_and_part_labels(const DesignModel& design);

// kBadInput as centre_line(). Dimensions are the lengths of legs in the file (leg_lengths()).
// Deterministic. Pure; any thread.
[[nodiscard]] Result<Isometric> draw_isometric(const DesignModel& design,
                                               const IsometricOptions& options);

// Adds a label's leader, frame (round ends: weld, square: part) and text. On the spool's other
// picture too.
void draw_label(const IsometricLabel& label, double letters_mm, Drawing& drawing);

// Half the size (mm) of a label's box.
[[nodiscard]] Eigen::Vector2d label_half_size(const DrawingLabel& label,
                                              const IsometricOptions& options);

// The arrow to the north for this side, centred at a place; "N" at its tip.
void draw_north(int quarter, const Eigen::Vector2d& centre, Drawing& drawing);

}  // namespace spool::guide
