// A flat drawing as plain data: strokes and texts in millimetres on paper, y down.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace spool::guide {

// A line through points, or the area within them.
struct Stroke {
  std::vector<Eigen::Vector2d> points;  // mm
  double width_mm = 0.25;
  bool is_closed = false;
  enum class Fill { kNone, kPaper, kInk } fill = Fill::kNone;  // kPaper hides what lies below
  bool is_dashed = false;
};

// One line of text, upright, centred on its box.
struct DrawnText {
  std::string utf8;
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();  // mm
  Eigen::Vector2d half_size = Eigen::Vector2d::Zero();
  double height_mm = 2.5;  // of the letters' body
  bool on_paper = false;   // what lies below its box is hidden
};

// Drawn in order, the strokes first.
struct Drawing {
  std::vector<Stroke> strokes;
  std::vector<DrawnText> texts;
};

using Box2 = Eigen::AlignedBox2d;

}  // namespace spool::guide
