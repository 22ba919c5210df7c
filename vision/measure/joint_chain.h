// The spool as a chain of links between fitted features, each carried on by the one before.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "vision/design/design_model.h"
#include "vision/measure/feature_geometry.h"
#include "vision/measure/part_feature.h"

namespace spool {

// What holds a flange's turn about its axis: its bolt holes, modulo their pitch.
struct TurnHold {
  int holes = -1;  // feature; -1: nothing holds it
  double pitch_rad = 0;
};

// From one part with a feature to the next one outward, over joints and parts without features.
struct ChainLink {
  int from = -1, to = -1;                  // features
  int before = -1;                         // the link that ends at `from`; -1: it is the root
  std::vector<int> joints;                 // of the design, outward
  Pose T_design_joint = Pose::Identity();  // nominal, see JointError
  std::vector<int> parts;                  // of the design that hang on it
  bool is_clock = false;                   // its bend holds the turn about the root
  TurnHold turn;                           // of `to`, a face
};

// A joint that has no link: what hangs on it has no feature.
struct LooseJoint {
  int joint = -1, part_near = -1, part_far = -1;
};

// The chain starts from the pipe on the datum's face: the datum is that face's centre and that
// pipe's axis (datum_frame()). Without a datum it starts from the first pipe that was measured.
struct JointChain {
  int root = -1;                 // feature, an axis; -1: there is no chain
  int face = -1;                 // feature that holds the root's place along itself; -1: none
  int clock = -1;                // the first link with a bend; -1: there is none
  TurnHold turn;                 // of the root about itself, by the face; nothing: by `clock`
  std::vector<ChainLink> links;  // outward: of each the one before stands before it
  std::vector<LooseJoint> loose;
  std::string text;  // what it starts from, or why there is none
};

// A joint in a loop holds nothing alone and ends the chain. Holes that stand near half a pitch off
// (is_one_holed()) hold no turn: whether by half a pitch forth or back nobody knows.
[[nodiscard]] JointChain joint_chain(const DesignModel& design, const Drawing& drawing,
                                     const PartFeatures& features);

// The motion of each feature's part from its nominal place (design frame), the root first as
// `root`, then one a link. What a feature does not hold (a pipe's slide and turn, a face's shift
// and turn) it takes over from what lies before it: there the joint's error is zero. (Nahangi &
// Haas 2014, thesis 3.3.2 method 1: forward kinematics.)
struct ChainState {
  Pose root = Pose::Identity();
  std::vector<Pose> links;
};
[[nodiscard]] ChainState chain_state(const JointChain& chain, const PartFeatures& features,
                                     const FeatureState& state);

// Whether an axis along `p` (joint's frame) leaves the line before it; then it is chosen to be
// right along the joint's x, else along its z.
[[nodiscard]] bool is_bend(const Eigen::Vector3d& p);

// The error of a link, see JointError.
[[nodiscard]] Vector6d link_error(const JointChain& chain, int link, const ChainState& state);

}  // namespace spool
