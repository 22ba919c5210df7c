// Bodies with branches: a run with outlets, and a branch fitting that sits on a run.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "vision/piping/solid.h"

namespace spool::piping {

// A hollow cylinder that leaves the run. Metres, radians.
struct Outlet {
  double outer = 0, inner = 0;  // radii
  double length = 0;            // from the run's axis to its end, along its own axis
  double angle = 0;             // of its axis from the run's +z; pi / 2: square
  bool opposite = false;        // towards -x instead of +x
};

struct RunTube {
  double outer = 0, inner = 0;  // radii
  double down = 0, up = 0;      // from z = -down to z = up
};

// A run along z with one outlet in the xz plane towards +x, or two on opposite sides. The outlet's
// edge is the curve in which the two cylinders meet. False, and nothing added, where that curve
// does not lie on the run: an outlet wider than the run, too short, or past the run's end.
[[nodiscard]] bool add_branched_run(Solid& solid, const RunTube& run,
                                    std::span<const Outlet> outlets);

// A fitting that sits on a run of radius `run_radius` along z, its axis in the xz plane: from a
// saddle of radius `base` on the run's outside, drawn in to `outlet.outer` at its end, with the
// bore `outlet.inner` all through. False as above.
[[nodiscard]] bool add_saddle_branch(Solid& solid, double run_radius, double base,
                                     const Outlet& outlet);

}  // namespace spool::piping
