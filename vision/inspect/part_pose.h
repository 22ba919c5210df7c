// Where a part stands against the drawing, the datum aligned, and which of its motions nothing
// holds.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "vision/core/pose.h"

namespace spool {

// What is known beforehand of any motion of a part: as drawn, to within a metre and a radian. It is
// what is left where no feature says more: a variance of zero there would read as certainty, one
// that is missing could not be inverted, and this takes no part in any mean.
inline constexpr double kUnobservedSigma = 1;  // m, rad

// A motion of the part that its features do not hold: the error says nothing of it.
struct WeakMotion {
  Vector6d direction = Vector6d::Zero();  // unit, m and rad, in the part's own frame at its origin
  double sigma = 0;                       // along it, m and rad; near kUnobservedSigma
  std::string text;                       // "a turn about the axis of pipe_2"
};

// inverse(nominal) * measured of a part in its own frame, the measured datum frame laid onto the
// drawing's.
struct PartPose {
  bool is_measured = false;           // false: only the reason
  std::string reason;                 // why not
  Vector6d error = Vector6d::Zero();  // translation (m), rotation vector (rad)
  // Of a small motion m after it: nominal * error * pose_from_small(m) is true. With the doubt of
  // the datum, of the sensor's scale and of the welds that features were seen through. Along weak
  // motions it is kUnobservedSigma squared (more where the datum's own turn is not held).
  Matrix6d covariance = Matrix6d::Zero();
  std::vector<WeakMotion> weak;
  std::vector<std::string> rests_on;  // features, in words
  std::string datum;                  // what it is relative to
  bool is_off = false;  // by more than chance makes of a part as drawn once in a thousand times
};

}  // namespace spool
