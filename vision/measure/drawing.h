// The design as an isometric shows it: faces, centres and ends, and the straight legs between them.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "vision/design/design_model.h"

namespace spool {

// Where dimensions end: a flange's face, the point that an elbow's or a tee's centrelines meet in,
// a pipe's or a cap's end.
enum class NodeKind : std::uint8_t { kFace, kCentre, kEnd };

struct DrawingNode {
  NodeKind kind = NodeKind::kEnd;
  int part = -1;
  int port = -1;                                    // of a face or end; -1: none
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  // m, design frame
  std::vector<int> legs;                            // that end here
};

// A straight run of centreline between two nodes.
struct DrawingLeg {
  int from = -1, to = -1;                                // nodes
  Eigen::Vector3d direction = Eigen::Vector3d::UnitX();  // unit, from -> to, design frame
  double length_m = 0;                                   // along it
  std::vector<int> parts;                                // in order, the nodes' own included
  std::vector<int> pipes;                                // of these
  double nps = 0;                                        // the largest; inches, 0 unknown
};

struct Drawing {
  std::vector<DrawingNode> nodes;
  std::vector<DrawingLeg> legs;
};

// From ports and joints. A leg that runs into something of which the centreline is not known (a
// part with one port that is no cap, an olet, a valve with three ports) is left out; so is one
// whose ends do not lie on one line, but for a step across it (an eccentric reducer).
[[nodiscard]] Drawing drawing_of(const DesignModel& design);

// "flange_1/face", "elbow_1/centre".
[[nodiscard]] std::string name_of(const DrawingNode& node, const DesignModel& design);

// The port of a flange or blind that is its face; -1: none.
[[nodiscard]] int face_port(const Part& part);

}  // namespace spool
