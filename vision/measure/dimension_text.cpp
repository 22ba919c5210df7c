// What is said of a dimension: its kind, its number, what would settle a doubt.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/measure/dimension_text.h"

#include <cstdio>
#include <numbers>
#include <string_view>
#include <utility>

namespace spool {
namespace {

std::string_view word(NodeKind kind) {
  return kind == NodeKind::kFace ? "face" : kind == NodeKind::kCentre ? "centre" : "end";
}

}  // namespace

std::string kind_between(NodeKind a, NodeKind b) {
  const auto rank = [](NodeKind kind) {
    return kind == NodeKind::kCentre ? 0 : kind == NodeKind::kFace ? 1 : 2;
  };
  if (rank(b) < rank(a)) std::swap(a, b);
  return std::string(word(a)) + "_to_" + std::string(word(b));
}

std::string number_text(double value, bool is_angle) {
  char text[32];
  if (is_angle)
    std::snprintf(text, sizeof text, "%.2f°", value * 180 / std::numbers::pi);
  else
    std::snprintf(text, sizeof text, "%.1f mm", 1000 * value);
  return text;
}

std::string advice_on(const Dimension& dimension) {
  const UncertaintyBudget& u = dimension.u;
  if (dimension.is_measured && 1.645 * u.total() < 0.25 * dimension.tolerance)
    return "It lies at the limit: measure it by hand.";
  if (dimension.kind == "rotation")
    return "Look at the face squarely from 0.7 m or nearer, or check the holes by level or by two "
           "pins.";
  if (u.scale >= u.fit && u.scale >= u.warp)
    return "Most of the doubt is the sensor's scale: calibrate the sensor, or measure it by "
           "hand.";
  if (u.warp >= u.fit)
    return "Most of the doubt is the sensor's warp: scan it in the middle of the picture, or "
           "measure it by hand.";
  return "Scan it from nearer and from more sides, or measure it by hand.";
}

std::string told_by(const Dimension& dimension) {
  return dimension.kind + " " + dimension.name + ": " + dimension.reason;
}

}  // namespace spool
