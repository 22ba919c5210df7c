// An order of visiting points in which neighbours in space follow each other.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "vision/core/cancel.h"

namespace spool {

// Puts `places`, which name finite points, into an order in which searches near the points find
// what they need in the cache still: as given where the points come in such an order already (an
// image, a scan line), else along a Morton curve (Morton 1966) over a coarse grid, with the given
// order inside a cell. Cancelled, it leaves them as they are.
void put_in_spatial_order(std::span<const Eigen::Vector3f> points,
                          std::vector<std::uint32_t>& places, const Watch& watch = {});

}  // namespace spool
