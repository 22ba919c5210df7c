// What a dimension's doubt adds up to.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/inspect/dimension.h"

#include <cmath>

namespace spool {

double UncertaintyBudget::total() const { return std::hypot(fit, scale, warp); }

}  // namespace spool
