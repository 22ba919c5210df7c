// Lengths as people read them: millimetres, or feet, inches and sixteenths. Display only.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/common/length_text.h"

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <numbers>
#include <numeric>

namespace spool {
namespace {

constexpr double kSixteenth_m = 0.0254 / 16;

std::string millimetres(double absolute_m) {
  char text[48];
  std::snprintf(text, sizeof text, "%.1f mm", 1000 * absolute_m);
  return text;
}

// 3' 2 5/16": feet from 12 inches on, the fraction in lowest terms.
std::string feet_inches(double absolute_m) {
  const auto sixteenths = static_cast<std::int64_t>(std::llround(absolute_m / kSixteenth_m));
  if (sixteenths == 0) return absolute_m > 0 ? "<1/16\"" : "0\"";
  const std::int64_t feet = sixteenths / (12 * 16);
  const std::int64_t inches = sixteenths / 16 % 12;
  const std::int64_t rest = sixteenths % 16;
  std::string text;
  if (feet > 0) text = std::to_string(feet) + "'";
  if (inches > 0 || rest == 0) text += (text.empty() ? "" : " ") + std::to_string(inches);
  if (rest > 0) {
    const std::int64_t divisor = std::gcd(rest, std::int64_t{16});
    text += (text.empty() ? "" : " ") + std::to_string(rest / divisor) + "/" +
            std::to_string(16 / divisor);
  }
  return text + "\"";
}

}  // namespace

std::string length_text(double metres, LengthStyle style) {
  // Beyond a light minute it is no length of ours and would not fit the integers below.
  if (!std::isfinite(metres) || std::abs(metres) > 1e10) return "-";
  const std::string text = style == LengthStyle::kMillimetre ? millimetres(std::abs(metres))
                                                             : feet_inches(std::abs(metres));
  const bool zero = text == "0.0 mm" || text == "0\"";
  return metres < 0 && !zero ? "-" + text : text;
}

std::string signed_length_text(double metres, LengthStyle style) {
  const std::string text = length_text(metres, style);
  const bool zero = text == "0.0 mm" || text == "0\"" || text == "-";
  return metres > 0 && !zero ? "+" + text : text;
}

std::string quantity_text(double value, bool is_angle, LengthStyle style, bool with_sign) {
  if (!is_angle) return with_sign ? signed_length_text(value, style) : length_text(value, style);
  if (!std::isfinite(value)) return "-";
  char degrees[48];
  std::snprintf(degrees, sizeof degrees, with_sign ? "%+.2f°" : "%.2f°",
                value * 180 / std::numbers::pi);
  return degrees;
}

std::string percent_text(double share) {
  if (!std::isfinite(share)) return "-";
  if (share > 0 && share < 0.01) return "<1 %";
  if (share < 1 && share > 0.99) return ">99 %";
  return std::to_string(std::lround(100 * share)) + " %";
}

}  // namespace spool
