// Every n-th pixel of a frame, and the camera that sees it so.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "vision/core/camera.h"
#include "vision/core/depth_frame.h"

namespace spool {

// Of every `stride`-th row every `stride`-th pixel (stride from 1).
[[nodiscard]] DepthFrame every_nth_pixel(const DepthFrame& frame, int stride);
[[nodiscard]] Camera every_nth_pixel(const Camera& camera, int stride);

}  // namespace spool
