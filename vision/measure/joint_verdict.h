// What may be said of one joint, by the dimensions that go across it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "vision/inspect/dimension.h"
#include "vision/inspect/joint_error.h"

namespace spool {

// Standards judge dimensions, not joints: a joint is ok where every dimension across it (between
// parts on both of its sides) is, and it is itself off by no more than its tolerances; not_ok where
// one of them is and it is the joint to blame, off by more than its tolerances. Otherwise one that
// was measured is suspicious. None is ok that no dimension goes across.
[[nodiscard]] Verdict joint_verdict(const JointError& joint,
                                    const std::vector<Dimension>& dimensions);

// Whether both sides of the joint lie between the dimension's ends.
[[nodiscard]] bool goes_across(const Dimension& dimension, const JointError& joint);

}  // namespace spool
