// The lines and symbols of an isometric: pipes, fittings, flanges, valves, welds, skew triangles.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "vision/guide/centre_line.h"
#include "vision/guide/drawing.h"
#include "vision/guide/isometric_layout.h"

namespace spool::guide {

// All parts along their laid-out centre lines, then their welds: a dot in the shop, a dot with a
// cross on site, an open diamond in the yard. Where two legs cross, the farther one is broken.
// Paper mm. Pure; any thread.
[[nodiscard]] std::vector<Stroke> isometric_symbols(const DesignModel& design,
                                                    const CentreLine& line,
                                                    const IsometricLayout& layout);

// The mark of a weld of this type at a place: what the legend shows as well.
[[nodiscard]] std::vector<Stroke> weld_mark(JointType type, const Eigen::Vector2d& at,
                                            double scale);

}  // namespace spool::guide
