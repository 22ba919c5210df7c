// What may be said of one joint, by the dimensions that go across it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/measure/joint_verdict.h"

#include <algorithm>

namespace spool {

bool goes_across(const Dimension& dimension, const JointError& joint) {
  const auto has = [&](int part) {
    return std::ranges::find(dimension.parts, part) != dimension.parts.end();
  };
  return has(joint.part_near) && has(joint.part_far);
}

Verdict joint_verdict(const JointError& joint, const std::vector<Dimension>& dimensions) {
  if (!joint.is_measured) return Verdict::kNotMeasured;
  const bool is_beyond = joint.against_tolerance > 1;
  bool is_proved = !is_beyond, is_judged = false;
  for (const Dimension& dimension : dimensions) {
    if (!goes_across(dimension, joint)) continue;
    if (dimension.status == Verdict::kNotOk && joint.is_to_blame && is_beyond)
      return Verdict::kNotOk;
    is_judged = true;
    is_proved = is_proved && dimension.status == Verdict::kOk;
  }
  return is_judged && is_proved ? Verdict::kOk : Verdict::kSuspicious;
}

}  // namespace spool
