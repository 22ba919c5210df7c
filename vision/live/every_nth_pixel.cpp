// Every n-th pixel of a frame, and the camera that sees it so.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/live/every_nth_pixel.h"

#include <cstddef>

namespace spool {

DepthFrame every_nth_pixel(const DepthFrame& frame, int stride) {
  DepthFrame small;
  small.index = frame.index;
  small.seconds = frame.seconds;
  small.width = (frame.width + stride - 1) / stride;
  small.height = (frame.height + stride - 1) / stride;
  small.depth.reserve(static_cast<std::size_t>(small.width) *
                      static_cast<std::size_t>(small.height));
  for (int v = 0; v < frame.height; v += stride) {
    const auto row = static_cast<std::size_t>(v) * static_cast<std::size_t>(frame.width);
    for (int u = 0; u < frame.width; u += stride) {
      small.depth.push_back(frame.depth[row + static_cast<std::size_t>(u)]);
    }
  }
  return small;
}

Camera every_nth_pixel(const Camera& camera, int stride) {
  Camera small = camera;
  small.width = (camera.width + stride - 1) / stride;
  small.height = (camera.height + stride - 1) / stride;
  small.fx /= stride;  // pixel centres at integers: pixel u of the small image is pixel u * stride
  small.fy /= stride;
  small.cx /= stride;
  small.cy /= stride;
  return small;
}

}  // namespace spool
