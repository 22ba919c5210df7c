// Notices that a picture suddenly lost most of its depth.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/live/dropout_watch.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "vision/core/median.h"

namespace spool {

namespace {
constexpr double kMost = 0.5;            // "most" is more than half
constexpr double kDeviations = 6;        // more than chance does
constexpr double kSigmaOfMad = 1.4826;   // of a normal distribution, from the median of its sizes
constexpr std::size_t kRemembered = 30;  // pictures: a second
constexpr std::size_t kFewest = 5;       // pictures before anything is said
constexpr double kLongest = 1.0;         // s
constexpr int kMostPictures = 90;        // a second of the fastest camera, where the clock stands
constexpr double kSamples = 5000;        // pixels of a picture that are looked at, about

// Pixels with depth, of every so many.
double count_readings(const DepthFrame& frame) {
  const double pixels = static_cast<double>(frame.width) * frame.height;
  const int step = std::max(1, static_cast<int>(std::sqrt(pixels / kSamples)));
  std::size_t count = 0;
  for (int v = 0; v < frame.height; v += step) {
    const auto row = static_cast<std::size_t>(v) * static_cast<std::size_t>(frame.width);
    for (int u = 0; u < frame.width; u += step)
      count += frame.depth[row + static_cast<std::size_t>(u)] != 0 ? 1U : 0U;
  }
  return static_cast<double>(count);
}
}  // namespace

bool is_blank(const DepthFrame& frame) {
  std::uint16_t first = 0;
  for (const std::uint16_t count : frame.depth) {
    if (first == 0) first = count;
    if (count != 0 && count != first) return false;
  }
  return true;
}

// The share of readings that is lost by chance in next to no picture, and not less than most.
double DropoutWatch::limit() const {
  std::vector<double> changes(changes_.begin(), changes_.end());
  return std::max(kMost, kDeviations * kSigmaOfMad * median(changes));
}

bool DropoutWatch::lasts(double seconds) {
  if (out_++ == 0) out_from_s_ = seconds;
  return seconds - out_from_s_ <= kLongest && out_ <= kMostPictures;
}

bool DropoutWatch::is_out(const DepthFrame& frame) {
  const double readings = count_readings(frame);
  const double change =
      readings_ > 0 ? std::min(1.0, std::abs(readings - readings_) / readings_) : 0;
  const bool falls = changes_.size() >= kFewest && readings < readings_ && change > limit();
  if (falls && lasts(frame.seconds)) return true;
  if (falls) changes_.clear();  // this is what pictures are like now
  if (readings_ > 0 && !falls && out_ == 0) {
    changes_.push_back(change);
    if (changes_.size() > kRemembered) changes_.pop_front();
  }
  out_ = 0;
  readings_ = readings;
  return false;
}

}  // namespace spool
