// Which welds of a spool can be rolled, and in which order most of them stay so.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "vision/design/design_model.h"

namespace spool::guide {

// A weld is rolled (1G) where the piece is turned about the weld's own axis under a torch that
// stands still. That takes something straight on that axis to turn it on, a pipe on rolls or a
// flange in a chuck, and room: nothing of what is tacked together by then may swing further from
// the axis than the shop's rolls stand clear of floor and wall.
struct RollRules {
  double swing_radius_m = 1.0;  // the shop's; pipe rolls and positioners stand about that high
  double least_grip_m = 0.10;   // a pipe on the axis, between its ends, to lie on rolls
};

struct RollWeld {
  int joint = -1;
  bool can_roll = false;
  double swing_m = 0;   // furthest from its axis of what hangs together once it is made
  std::string why_not;  // one clause; "" it can
};

struct RollPlan {
  std::vector<RollWeld> order;  // every numbered weld once, in the order of welding
  int rolled = 0;
  bool is_best = true;  // false: more welds than all orders could be tried of
};

// Assumes that groups are welded each by itself and then joined, that a group is all that welds
// made so far hold together, and that tacks hold while it turns. Site and yard welds are made where
// the spool stands and come last; so do branch welds on the side of a pipe, whose seam lies in no
// plane square to an axis. Weight, and how far the mass lies off the axis, are not looked at.
// Up to 14 welds that could be rolled the order is the best of all; above, at each step the weld
// that leaves most others. Pure; any thread.
[[nodiscard]] RollPlan plan_roll_welds(const DesignModel& design, const RollRules& rules);

}  // namespace spool::guide
