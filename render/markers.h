// Numbered marks on the picture for proposed and picked points.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "render/canvas.h"
#include "render/overlay.h"
#include "render/view.h"

namespace spool::render {

// A ring with ticks for a proposed point, a ring with a cross for a picked one, a diamond with a
// cross for one picked on the scan; the label in a badge beside it. What is behind the camera or
// outside is not drawn.
[[nodiscard]] Canvas draw_markers(std::span<const Marker> markers, const View& view, double scale);

}  // namespace spool::render
