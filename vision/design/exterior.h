// The surface that a sensor outside can see: a design without its bores and buried faces.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "vision/design/design_model.h"
#include "vision/design/design_surface.h"
#include "vision/design/sampling.h"

namespace spool {

// `design` with only those triangles of which at least a third is seen: some ray gets away from
// there; parts keep their places and may end up without triangles. A wall is a few millimetres
// thick: a reading that is off by more than half of it would otherwise be compared to the bore, and
// a dented pipe would look right. `surface` is the whole design's. A cloud design, or one of which
// nothing is seen, comes back as it is.
[[nodiscard]] DesignModel exterior_of(const DesignModel& design, const DesignSurface& surface);

// Those samples from which some ray gets away: a triangle may be half under its neighbour. `design`
// and `surface` are the whole design's.
[[nodiscard]] SurfaceSamples seen_samples(const SurfaceSamples& samples, const DesignModel& design,
                                          const DesignSurface& surface);

}  // namespace spool
