// What each fitted feature at a part says of where that part stands.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "vision/design/design_model.h"
#include "vision/measure/feature_geometry.h"
#include "vision/measure/part_feature.h"
#include "vision/measure/rules.h"

namespace spool {

enum class PoseHold : std::uint8_t {
  kLine,   // an axis: two shifts across it and two tilts
  kPlane,  // a face: the shift along its normal and two tilts
  kTurn,   // bolt holes: the turn about the face's normal, modulo their pitch
  kStop,   // where a pipe ends: the shift along its own axis
};

struct PoseEvidence {
  PoseHold kind = PoseHold::kLine;
  int feature = -1;                        // an axis, a face or holes
  int own_axis = -1;                       // of a stop: the pipe's own axis
  bool is_face = false;                    // of a stop: a face, else an axis that crosses
  Pose T_part_nominal = Pose::Identity();  // where the drawing has it; z as the feature's
  double pitch_rad = 0;                    // of holes
  // What the welds between it and the part may be off by, as standard deviations; of the part's own
  // feature none.
  double weld_u_m = 0, weld_u_rad = 0;
  std::string text;  // for people: "the axis of pipe_1, through W2"

  [[nodiscard]] Eigen::Index rows() const;
};

// Of a part with features of its own: these, and
// - a flange: the axes of pipes at its welds, which say where its middle is,
// - a pipe: what stops it, which is a flange's face at its end, or beyond an elbow, a tee or a
// cross
//   at its end the axis of that fitting's other pipe (where the two axes pass nearest).
// Of a part without: the axes and faces of its neighbours, through the welds between.
// A neighbour tells of a part only as far as the weld between is as drawn: it may be off by half of
// what `rules` allow a length and an alignment, as a standard deviation (of PFI ES-3 where they say
// nothing), and a stop across a fitting by two welds. Bolted joints say nothing.
[[nodiscard]] std::vector<PoseEvidence> pose_evidence(const DesignModel& design,
                                                      const PartFeatures& features,
                                                      const RuleSet& rules, int part);

// How far the feature in `state` is off from where it would be if the part stood at `error` (part's
// own frame): m and rad, of as many rows as it holds. `T_part_state` maps the state's frame into
// the part's nominal one.
[[nodiscard]] Eigen::VectorXd residual_of(const PoseEvidence& evidence, const Pose& error,
                                          const Pose& T_part_state, const FeatureState& state);

}  // namespace spool
