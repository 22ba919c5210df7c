// How a flange's bolt holes are turned against the drawing, seen from the datum.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "vision/design/design_model.h"
#include "vision/inspect/joint_tree.h"
#include "vision/measure/datum_frame.h"
#include "vision/measure/part_feature.h"

namespace spool {

struct HolesRotation {
  std::string from;        // what holds the turn that it is measured from: part/holes, a node
  double nominal_rad = 0;  // the first hole's clocking, right-handed about the part's z
  std::vector<int> parts;  // that lie in it
  int answers = -1;        // the flange; -1: something between may have been rolled as well
  bool is_one_holed = false;
  bool is_datum = false;  // its holes are what all else is turned by: there is nothing to measure
  std::function<double(const FeatureState&)> at;  // rad, as nominal_rad; empty: not measured
  std::string why_not;
};

// `tree`: the joint_tree() of the design. The turn of the flange `part` (with holes) about its own
// axis from where the drawing has it in the datum frame: known modulo the pitch of its holes only,
// and stated as the least. Seen from a datum that is turned by holes alone, modulo what both
// pitches have in common. The datum's own holes are compared with the node furthest off its axis.
//
// It is the flange's own unless a leg on the way from the datum runs as the flange's axis does:
// what was rolled about that leg turned the flange too. One-holed is always the flange's own.
[[nodiscard]] HolesRotation rotation_of_holes(const DesignModel& design, const Drawing& drawing,
                                              const PartFeatures& features, const DatumFrame& datum,
                                              const FeatureState& measured,
                                              std::span<const JointBranch> tree, int part);

}  // namespace spool
