// Whether parts run into each other: each as a few capsules.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "tools/campaign/assembly.h"

namespace spool::campaign {

// All points within `radius` (m) of the line from `a` to `b`.
struct Capsule {
  Eigen::Vector3d a = Eigen::Vector3d::Zero(), b = Eigen::Vector3d::Zero();
  double radius = 0;
};

// They hold the part, in its own frame.
[[nodiscard]] std::vector<Capsule> capsules_of(const PartSpec& spec);

// True where two parts that are more than two joints apart come nearer than `clear` (m).
[[nodiscard]] bool collides(const Assembly& assembly, double clear);

}  // namespace spool::campaign
