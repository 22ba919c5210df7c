// The surface of a part as closed triangles, as a design file holds it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tools/campaign/mesh_builder.h"
#include "tools/campaign/part.h"

namespace spool::campaign {

// Corners of a full circle; a multiple of every number of bolt holes, so that the loops of a flange
// share their corners. Chords leave a circle of radius r by r * (1 - cos(pi / 64)) = r / 830: 0.07
// mm at the wall of an NPS 4 pipe, 0.2 mm at the rim of an NPS 8 flange.
inline constexpr int kCircleSteps = 64;
// Of a bolt hole: 0.1 mm.
inline constexpr int kHoleSteps = 24;

// In the part's own frame (m), counter-clockwise seen from outside, every edge shared by two
// triangles.
[[nodiscard]] TriangleMesh mesh_of(const PartSpec& spec);

// A tee's: the one part whose patches cut each other.
void add_tee(const PartSpec& spec, MeshBuilder& builder);

}  // namespace spool::campaign
