// The error of every joint against the one before it, with covariance, blame and far effects.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "vision/core/cancel.h"
#include "vision/design/design_model.h"
#include "vision/inspect/joint_error.h"
#include "vision/measure/drawing.h"
#include "vision/measure/joint_chain.h"
#include "vision/measure/part_feature.h"
#include "vision/measure/rules.h"

namespace spool {

// Joints and ends of the chain from the datum outward (Nahangi & Haas 2014, thesis 3.3.2 method 1,
// on fitted features). `scale_u`: standard uncertainty of the sensor's scale, a fraction.
//
// Covariances are those of the features and of the scale, which all lengths share, through
// derivatives taken numerically; what two joints share of a feature is in each.
//
// A joint is significant where one of its observed errors (along, across, turn, tilt: chi-squared
// of its one or two components) is less probable, were there none, than kJointLevel over the number
// of such errors of the whole spool (Bonferroni). To blame is the significant one that is largest
// against its tolerance: of a length along and across, of an angle (a face: of alignment) where it
// tilts, of a length for what it does at each end beyond. Of a cancelled run nothing is known.
[[nodiscard]] ChainResult measure_joints(const DesignModel& design, const Drawing& drawing,
                                         const PartFeatures& features, const RuleSet& rules,
                                         double scale_u, const Watch& watch = {});

// The kinds of error of a joint: components of JointError::error.
struct ErrorGroup {
  BumpKind kind;
  std::vector<int> components;
};
[[nodiscard]] const std::vector<ErrorGroup>& error_groups();

// Of those components that are observed: the probability of at least this error where there is
// none; 1 where none is observed.
[[nodiscard]] double chance_of(const JointError& error, const ErrorGroup& group);
// How many such errors are observed on the whole chain.
[[nodiscard]] int observed_groups(const std::vector<JointError>& errors);

// The motion beyond the joint that an error is, as seen from the datum: at its nominal place.
[[nodiscard]] Pose error_motion(const JointError& joint, const Vector6d& error);

}  // namespace spool
