// Flange, three pipes with two elbows in two planes between them, flange; scanned as built.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "tests/vision/measure/two_flange_spool.h"

namespace spool::test {

enum LegPart { kLegFlangeA, kLeg1, kElbow1, kLeg2, kElbow2, kLeg3, kLegFlangeB, kLegParts };

// NPS 4. Flange A's face looks down at z = -0.03; elbow_1's centre is (0, 0, 0.65), elbow_2's
// (0.8, 0, 0.65); leg 3 runs along y to flange B's face at y = 0.68. Welds W1 to W6 in that order.
// The elbows have ports and no surface.
[[nodiscard]] DesignModel three_leg_spool();

// Its features, scanned from all sides with 0.5 mm of noise, parts moved to where they were built.
[[nodiscard]] PartFeatures features_of_legs(const DesignModel& design,
                                            const std::vector<Pose>& T_design_built,
                                            std::uint32_t seed, double noise_m = 0.0005);

// As drawn, but every part from `first` on moved.
[[nodiscard]] std::vector<Pose> legs_moved_from(int first, const Pose& motion);

}  // namespace spool::test
