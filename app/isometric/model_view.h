// The shaded view of a design with the line drawing's labels at what they name.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/isometric/sheet.h"

namespace spool::isometric {

// On the second page: where the picture lies, mm.
[[nodiscard]] guide::Box2 model_area();

// Seen from the side that the line drawing of this quarter is seen from. Where there is no picture
// it says why. GL thread; makes and drops its own context.
[[nodiscard]] ModelPicture draw_model_view(const DesignModel& design, int quarter,
                                           const guide::IsometricOptions& options);

}  // namespace spool::isometric
