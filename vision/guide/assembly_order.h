// In which order the parts of a spool are put together, and why an order would not do.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "vision/core/result.h"
#include "vision/design/design_model.h"

namespace spool::guide {

// An order is the indices of all parts of a design, each once, first step first.

// The part that the work starts from: the first datum; where there is none, an end of the heaviest
// straight run (sum of length times nominal size over the pipes in line): its flange, else its
// open end, else the earlier in the file. -1 only of a design without parts. Pure; any thread.
[[nodiscard]] int base_part(const DesignModel& design);

// From the base outward, so that each step joins what stands: shop welds before yard and site
// joints, then what lies nearest the base (in joints), then the file's order. What no joint
// connects with the base comes after it, each such group from its first part. An order that the
// design itself gives all its parts is taken where it has no fault. Pure; any thread.
[[nodiscard]] std::vector<int> propose_order(const DesignModel& design);

// A step (from 0) that cannot be done at its place, and why: one clause.
struct OrderFault {
  int step = 0;
  std::string reason;
};

// All faults: parts that are missing, named twice or unknown, and parts that join nothing that
// stands although something they are connected with stands. Empty: the order will do.
[[nodiscard]] std::vector<OrderFault> order_faults(const DesignModel& design,
                                                   const std::vector<int>& order);

// The order with step `from` moved to place `to` (both from 0). kUsage with the first fault's
// reason where that cannot be built or a step is not there; the order is then as it was.
[[nodiscard]] Result<std::vector<int>> move_step(const DesignModel& design,
                                                 const std::vector<int>& order, int from, int to);

}  // namespace spool::guide
