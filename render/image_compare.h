// How far two pictures differ: two limits, the worst pixels, and a picture of the difference.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "render/image.h"

namespace spool::render {

// A picture passes where at most `max_fraction` of its pixels differ by more than `max_abs_diff` in
// any channel (a few stray pixels), and the mean difference of all channels is at most `max_mean`
// (a faint change everywhere).
struct ImageLimits {
  int max_abs_diff = 5;         // of 255
  double max_fraction = 0.001;  // of the pixels
  double max_mean = 0.1;        // of 255
};

struct PixelDifference {
  int x = 0;
  int y = 0;
  int difference = 0;  // of 255, the largest of the four channels
};

struct ImageComparison {
  bool same_size = false;
  int worst = 0;                              // of 255
  double fraction_beyond = 0;                 // of the pixels, beyond max_abs_diff
  double mean = 0;                            // of 255, over all channels
  std::vector<PixelDifference> worst_pixels;  // at most ten, the worst first
  Image difference;                           // white where equal, redder the larger the difference
  bool passed = false;
  [[nodiscard]] std::string summary() const;  // the numbers and the worst pixels, for a console
};

[[nodiscard]] ImageComparison compare_images(const Image& actual, const Image& expected,
                                             const ImageLimits& limits);

}  // namespace spool::render
