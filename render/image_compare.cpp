// How far two pictures differ: two limits, the worst pixels, and a picture of the difference.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "render/image_compare.h"

#include <algorithm>
#include <cstdlib>
#include <sstream>

namespace spool::render {

ImageComparison compare_images(const Image& actual, const Image& expected,
                               const ImageLimits& limits) {
  ImageComparison result;
  result.same_size = actual.width == expected.width && actual.height == expected.height &&
                     actual.rgba.size() == expected.rgba.size() && !expected.rgba.empty();
  if (!result.same_size) return result;
  result.difference = {expected.width, expected.height,
                       std::vector<std::uint8_t>(expected.rgba.size(), 255)};
  std::vector<PixelDifference> different;
  std::uint64_t sum = 0;
  std::size_t beyond = 0;
  const auto width = static_cast<std::size_t>(expected.width);
  for (std::size_t pixel = 0; pixel < expected.rgba.size() / 4; ++pixel) {
    int largest = 0;
    for (std::size_t channel = 0; channel < 4; ++channel) {
      const int difference =
          std::abs(actual.rgba[4 * pixel + channel] - expected.rgba[4 * pixel + channel]);
      sum += static_cast<std::uint64_t>(difference);
      largest = std::max(largest, difference);
    }
    if (largest == 0) continue;
    different.push_back(
        {static_cast<int>(pixel % width), static_cast<int>(pixel / width), largest});
    if (largest > limits.max_abs_diff) ++beyond;
    // Full red from 64 on; a difference of one can still be seen.
    const auto paler = static_cast<std::uint8_t>(std::max(0, 200 - 3 * largest));
    result.difference.rgba[4 * pixel + 1] = result.difference.rgba[4 * pixel + 2] = paler;
  }
  const auto top = std::min<std::size_t>(10, different.size());
  std::ranges::partial_sort(
      different, different.begin() + static_cast<std::ptrdiff_t>(top),
      [](const auto& a, const auto& b) { return a.difference > b.difference; });
  different.resize(top);
  result.worst_pixels = std::move(different);
  result.worst = result.worst_pixels.empty() ? 0 : result.worst_pixels.front().difference;
  result.fraction_beyond =
      static_cast<double>(beyond) / (static_cast<double>(expected.rgba.size()) / 4);
  result.mean = static_cast<double>(sum) / static_cast<double>(expected.rgba.size());
  result.passed = result.fraction_beyond <= limits.max_fraction && result.mean <= limits.max_mean;
  return result;
}

std::string ImageComparison::summary() const {
  if (!same_size) return "the pictures differ in size";
  std::ostringstream text;
  text << "worst " << worst << " of 255, " << 100 * fraction_beyond
       << " % of the pixels beyond the limit, mean " << mean;
  for (const PixelDifference& p : worst_pixels)
    text << "\n  (" << p.x << ", " << p.y << "): " << p.difference;
  return text.str();
}

}  // namespace spool::render
