// The body of a flange: plate with its bolt holes, raised face, hub and bore.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "vision/piping/catalogue.h"
#include "vision/piping/solid.h"

namespace spool::piping {

// What a catalogue does not say of one flange. Metres.
struct FlangeBody {
  double length = 0;       // contact face to weld end, as drawn
  double hub_end = 0;      // outside diameter where the hub ends
  double bore = 0;         // diameter; 0: blind
  double counterbore = 0;  // diameter from the back to `counterbore_depth`; 0: none
  double counterbore_depth = 0;
  bool has_raised_face = true;
};

// The contact face lies at z = 0 and looks to +z, the weld end at z = -length. Holes straddle the x
// axis: the first is half a pitch from x about +z (two-holed on x and on y).
void add_flange(Solid& solid, const FlangeSize& size, const FlangeBody& body);

}  // namespace spool::piping
