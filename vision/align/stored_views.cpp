// Views from which the scene was seen, to be found again by how it looks: for a camera that is
// lost.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/align/stored_views.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace spool {
namespace {

constexpr std::size_t kMostViews = 400;
constexpr double kApartM = 0.12, kApartRad = 0.21;
constexpr int kShift = 2;             // stamp px: some 6 degrees
constexpr double kUnmatched = 0.3;    // 1/m, where one of the two saw nothing
constexpr double kLeastShared = 0.3;  // of the stamp

double unlikeness_at(const Stamp& a, const Stamp& b, int du, int dv) {
  double sum = 0;
  int shared = 0, one = 0;
  for (int v = std::max(0, -dv); v < std::min(kStampHeight, kStampHeight - dv); ++v)
    for (int u = std::max(0, -du); u < std::min(kStampWidth, kStampWidth - du); ++u) {
      const float x = a[static_cast<std::size_t>(v * kStampWidth + u)];
      const float y = b[static_cast<std::size_t>((v + dv) * kStampWidth + u + du)];
      if (x > 0 && y > 0) {
        sum += static_cast<double>(std::abs(x - y));
        ++shared;
      } else if (x > 0 || y > 0) {
        ++one;
      }
    }
  if (shared < kLeastShared * kStampWidth * kStampHeight) return std::numeric_limits<double>::max();
  return (sum + kUnmatched * one) / (shared + one);
}

}  // namespace

Stamp stamp_of(const SeenFrame& frame) {
  Stamp stamp = {};
  for (int y = 0; y < kStampHeight; ++y)
    for (int x = 0; x < kStampWidth; ++x) {
      double sum = 0;
      int measured = 0, all = 0;
      const int top = y * frame.camera.height / kStampHeight;
      const int bottom = (y + 1) * frame.camera.height / kStampHeight;
      const int left = x * frame.camera.width / kStampWidth;
      const int right = (x + 1) * frame.camera.width / kStampWidth;
      for (int v = top; v < bottom; v += 2)
        for (int u = left; u < right; u += 2) {
          const float z =
              frame.cloud.points[static_cast<std::size_t>(v * frame.camera.width + u)].z();
          ++all;
          if (!(z > 0)) continue;
          sum += 1.0 / static_cast<double>(z);
          ++measured;
        }
      if (3 * measured > all)
        stamp[static_cast<std::size_t>(y * kStampWidth + x)] = static_cast<float>(sum / measured);
    }
  return stamp;
}

double unlikeness(const Stamp& a, const Stamp& b) {
  double least = std::numeric_limits<double>::max();
  for (int dv = -kShift; dv <= kShift; ++dv)
    for (int du = -kShift; du <= kShift; ++du) least = std::min(least, unlikeness_at(a, b, du, dv));
  return least;
}

void StoredViews::offer(const SeenFrame& frame, const Pose& T_map_camera) {
  for (const StoredView& view : views_) {
    const PoseSize apart = pose_size(view.T_map_camera.inverse() * T_map_camera);
    if (apart.translation_m < kApartM && apart.rotation_rad < kApartRad) return;
  }
  if (views_.size() == kMostViews) views_.erase(views_.begin());
  views_.push_back({T_map_camera, stamp_of(frame)});
}

std::vector<Pose> StoredViews::likest(const SeenFrame& frame, std::size_t most) const {
  const Stamp stamp = stamp_of(frame);
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < views_.size(); ++i) {
    const double far = unlikeness(stamp, views_[i].stamp);
    if (far < std::numeric_limits<double>::max()) order.emplace_back(far, i);
  }
  std::sort(order.begin(), order.end());
  std::vector<Pose> poses;
  for (std::size_t k = 0; k < std::min(most, order.size()); ++k)
    poses.push_back(views_[order[k].second].T_map_camera);
  return poses;
}

}  // namespace spool
