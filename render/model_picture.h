// A design as a shaded picture on white paper.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "render/image.h"
#include "render/view.h"
#include "vision/core/result.h"
#include "vision/core/triangle_mesh.h"

namespace spool::render {

// Opaque, with its visible creases and outlines drawn `line_px` wide. Triangles in the view's
// design frame, m, and the part of each. kNoDevice where the driver refuses; GL thread only, while
// a context is current.
[[nodiscard]] Result<Image> draw_model(const TriangleMesh& mesh,
                                       std::span<const std::int32_t> triangle_part,
                                       const View& view, float line_px);

}  // namespace spool::render
