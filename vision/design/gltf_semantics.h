// What extras.spoolsight says of a glTF's nodes and scene (ARCHITECTURE, Files).
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "vision/design/design_model.h"

namespace tinygltf {
class Value;
}

namespace spool {

// How a node's own frame, in the file's units, lies in the part's frame: metres, rigid,
// right-handed.
struct NodeFrame {
  Eigen::Matrix3d part_from_node = Eigen::Matrix3d::Identity();  // scale, shear and mirroring
  double scale = 1;       // of lengths that the extras give in metres, by the node's own scale
  bool mirrored = false;  // clocking then runs the other way
};

// Reads a node's extras.spoolsight into `part`. What is of the wrong type warns and stays unset.
void read_part_semantics(const tinygltf::Value& extras, const NodeFrame& frame, Part& part,
                         std::vector<std::string>& warnings);

// Reads a scene's extras.spoolsight into `design`, whose parts are complete: joints and datums that
// name no part or port warn and are left out.
void read_scene_semantics(const tinygltf::Value& extras, DesignModel& design);

}  // namespace spool
