// The colours of deviations: diverging, safe for the colour-blind, even in lightness on both sides.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "render/deviation_colour.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace spool::render {

// CIE lightness L* falls evenly from 84 to 50 on both sides, so that neither sign looks louder; the
// hues (OKLCh 257 and 36 degrees) stay apart for all three kinds of colour blindness.
const DeviationStops& inside_stops() {
  static const DeviationStops stops{
      Eigen::Vector3f(0.8214F, 0.8214F, 0.8214F), Eigen::Vector3f(0.7073F, 0.7817F, 0.8868F),
      Eigen::Vector3f(0.6144F, 0.7382F, 0.9129F), Eigen::Vector3f(0.5269F, 0.6933F, 0.9278F),
      Eigen::Vector3f(0.4417F, 0.6473F, 0.9361F), Eigen::Vector3f(0.3565F, 0.6002F, 0.9399F),
      Eigen::Vector3f(0.2682F, 0.5519F, 0.9402F), Eigen::Vector3f(0.1683F, 0.5023F, 0.9379F),
      Eigen::Vector3f(0.0250F, 0.4523F, 0.9246F)};
  return stops;
}

const DeviationStops& outside_stops() {
  static const DeviationStops stops{
      Eigen::Vector3f(0.8214F, 0.8214F, 0.8214F), Eigen::Vector3f(0.8843F, 0.7453F, 0.7067F),
      Eigen::Vector3f(0.9048F, 0.6767F, 0.6137F), Eigen::Vector3f(0.9125F, 0.6091F, 0.5261F),
      Eigen::Vector3f(0.9122F, 0.5413F, 0.4409F), Eigen::Vector3f(0.9062F, 0.4722F, 0.3557F),
      Eigen::Vector3f(0.8957F, 0.4001F, 0.2670F), Eigen::Vector3f(0.8814F, 0.3224F, 0.1658F),
      Eigen::Vector3f(0.8548F, 0.2450F, 0.0257F)};
  return stops;
}

Eigen::Vector3f deviation_colour(double deviation_m, double neutral_m, double range_m) {
  assert(neutral_m >= 0 && range_m > neutral_m && "a range beyond the neutral band");
  assert(std::isfinite(deviation_m) && "an unknown deviation has no place on the scale");
  const double along =
      (kDeviationStops - 1) *
      std::clamp((std::abs(deviation_m) - neutral_m) / (range_m - neutral_m), 0.0, 1.0);
  const int below = std::min(static_cast<int>(along), kDeviationStops - 2);
  const auto share = static_cast<float>(along - below);
  const DeviationStops& stops = deviation_m < 0 ? inside_stops() : outside_stops();
  const auto at = static_cast<std::size_t>(below);
  return (1 - share) * stops[at] + share * stops[at + 1];
}

Eigen::Vector3f clutter_colour() { return {0.33F, 0.35F, 0.38F}; }
Eigen::Vector3f unknown_colour() { return {0.58F, 0.61F, 0.65F}; }
Eigen::Vector3f contradicting_colour() { return {1.0F, 0.30F, 0.90F}; }

}  // namespace spool::render
