// How probable it is that what was measured lies within its tolerance (JCGM 106:2012).
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "vision/inspect/verdict.h"

namespace spool {

struct Conformance {
  double probability = 0;  // of lying within the tolerance
  // A value within the tolerance would be read so far off once in twenty times at most, and one
  // within half of it once in a thousand. Where a measurement is far coarser than the tolerance the
  // probability of any value is small, and says nothing against it; and of the tens of dimensions
  // of one drawing some part would be accused by chance nearly always. The second binds where u is
  // over 0.3 of the tolerance.
  bool is_beyond = false;
};

inline constexpr double kProvedRight = 0.95, kProvedWrong = 0.05;
// ok from a probability of 0.95 on; not_ok to 0.05 where the reading is beyond as well (ISO
// 14253-1's default of 95 %, for either side who must prove); between, nobody can tell.
[[nodiscard]] Verdict decide(const Conformance& conformance);

// Of a deviation that was found to be `deviation` with standard uncertainty `u` (all in one unit; u
// over 0), nothing known of it beforehand: JCGM 106, 7. Beyond: 1.645 u over the tolerance, 3.291 u
// over half of it.
[[nodiscard]] Conformance conformance_of(double deviation, double u, double tolerance);

// Of a tilt of two components with that covariance (rad): the probability in the disc, in strips by
// the midpoint rule. Beyond: 2.448 standard deviations over the tolerance, 3.717 over half of it,
// which two components together exceed once in twenty and once in a thousand times.
[[nodiscard]] Conformance conformance_of(const Eigen::Vector2d& tilt,
                                         const Eigen::Matrix2d& covariance, double tolerance);

}  // namespace spool
