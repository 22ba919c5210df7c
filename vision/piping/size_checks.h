// Whether fittings and flanges are as long as the catalogue says: take-offs, bend angles, classes.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "vision/piping/pipework.h"

namespace spool::piping {

inline constexpr double kSameLength = 0.002;  // m: drawings round, editions of a standard differ

// The angle (rad) by which an elbow turns the pipe, as drawn; zero without a centre.
[[nodiscard]] double bend_angle(const Component& elbow);

// Fills in schedules and classes that nothing says: a flange's class where its length is that of
// one class only, else 150; a schedule STD. Adds a problem for each, and for every length that is
// not the catalogue's by more than kSameLength, every ANGLE that is not the drawn one by more than
// half a degree, every size the catalogue does not hold, and orifice flanges without taps. What is
// drawn stays as it is.
void check_sizes(Pipework& pipework);

}  // namespace spool::piping
