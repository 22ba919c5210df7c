// Views from which the scene was seen, to be found again by how it looks: for a camera that is
// lost.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "vision/core/pose.h"
#include "vision/scan/seen_frame.h"

namespace spool {

// A depth image as a stamp of inverse depths (1/m), 0 where too little was measured.
inline constexpr int kStampWidth = 20, kStampHeight = 15;
using Stamp = std::array<float, kStampWidth * kStampHeight>;
[[nodiscard]] Stamp stamp_of(const SeenFrame& frame);

// How unlike two stamps are: mean difference of inverse depth (1/m) at the best shift of up to two
// stamp pixels, a fixed penalty where one saw nothing. Large: nothing in common.
[[nodiscard]] double unlikeness(const Stamp& a, const Stamp& b);

struct StoredView {
  Pose T_map_camera = Pose::Identity();
  Stamp stamp = {};
};

// A new view is kept where the camera is 12 cm or 12 degrees from all kept ones; of 400 the oldest
// goes. One thread.
class StoredViews {
 public:
  void offer(const SeenFrame& frame, const Pose& T_map_camera);
  [[nodiscard]] std::size_t size() const { return views_.size(); }
  // Poses of the views that look most like `frame`, the likest first.
  [[nodiscard]] std::vector<Pose> likest(const SeenFrame& frame, std::size_t most) const;
  void clear() { views_.clear(); }

 private:
  std::vector<StoredView> views_;
};

}  // namespace spool
