// What makes a solid one: every edge met twice, outside out, inside in.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

#include "vision/piping/solid.h"

namespace spool::test {

// What is wrong with the triangles: an edge that is not met exactly once from either side, a corner
// that is no vertex, a flat triangle, a negative volume. "" where nothing is.
[[nodiscard]] std::string fault_of(const piping::Solid& solid);

// Enclosed volume (m3) by the divergence theorem.
[[nodiscard]] double volume(const piping::Solid& solid);

// How many times the surface winds round a point: 1 inside, 0 outside (solid angles by Van Oosterom
// & Strackee, IEEE TBME 30(2), 1983).
[[nodiscard]] double winding(const piping::Solid& solid, const Eigen::Vector3d& point);

// Tries random places of the solid's box against a formula: the number that the two disagree on,
// of those further than `margin` (m) from where the formula changes.
[[nodiscard]] int disagreements(const piping::Solid& solid, double margin,
                                const std::function<bool(const Eigen::Vector3d&)>& is_inside,
                                int places = 400);

}  // namespace spool::test
