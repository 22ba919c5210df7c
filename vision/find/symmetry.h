// The rigid motions that lay a design on itself, wholly or for the most part.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "vision/core/cancel.h"
#include "vision/core/pose.h"
#include "vision/design/design_surface.h"

namespace spool {

struct FinderModel;

// A motion of the design after which `share` of its surface lies on its surface again.
struct SelfLikeness {
  Pose motion = Pose::Identity();
  double share = 0;
};

// All but the identity that lay at least half of the surface on itself, the fullest first, some two
// dozen at most: found as the design is found in a scan, with itself for the scan. `model` has its
// samples, probes, field and levels. Of a body of revolution a few turns stand for all. A cancelled
// search gives what it had.
[[nodiscard]] std::vector<SelfLikeness> self_likenesses(const FinderModel& model,
                                                        std::uint32_t seed,
                                                        const Watch& watch = {});

// Whether nearly all of the surface lies on the surface again: no scan tells the two poses apart,
// though a bolt hole may.
[[nodiscard]] bool lays_on_itself(const FinderModel& model, const Pose& motion);

// The motion refined on the surface itself, if no bolt hole and no edge then tells the design from
// before.
[[nodiscard]] std::optional<Pose> exact_symmetry(const FinderModel& model,
                                                 const DesignSurface& surface,
                                                 const SelfLikeness& alike);

}  // namespace spool
