// The motions that put the joint to blame right.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "vision/design/design_model.h"
#include "vision/inspect/joint_error.h"
#include "vision/measure/part_feature.h"

namespace spool {

// Of the joint to blame, where it is out of tolerance: the inverse of each of its errors that is
// significant by itself, in the order in which to do them. Nothing where no joint is to blame, or
// the one that is lies within its tolerances.
[[nodiscard]] std::vector<Bump> bumps_for(const DesignModel& design, const ChainResult& chain);

// The features as they would be measured after the bump.
[[nodiscard]] PartFeatures after(const Bump& bump, const ChainResult& chain,
                                 const PartFeatures& features);

}  // namespace spool
