// A design as fitters draw it: the centre lines of its parts, and where they meet.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "vision/core/result.h"
#include "vision/design/design_model.h"

namespace spool::guide {

// The axes of a drawing in the design frame: a PCF's design and a glTF's are y up, x east, z south.
struct Compass {
  Eigen::Vector3d east = Eigen::Vector3d::UnitX();
  Eigen::Vector3d north = -Eigen::Vector3d::UnitZ();
  Eigen::Vector3d up = Eigen::Vector3d::UnitY();
};

// A place of the centre lines, in east, north, up of the file (metres, not rebased).
struct LineNode {
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  int part = -1;   // whose centre or foot of a branch it is; -1: a joint or an open end
  int joint = -1;  // the design's joint that lies here; -1: none
  int open_part = -1, open_port = -1;  // the part whose open end it is
};

// A stretch of a part's centre line between two nodes.
struct LineEdge {
  int from = -1, to = -1;  // nodes
  int part = -1;
};

// A chain of edges in one line: what a drawing draws as a leg.
struct LineRun {
  std::vector<int> nodes;  // in order, one more than the edges
  std::vector<int> edges;
  Eigen::Vector3d direction = Eigen::Vector3d::UnitX();  // unit, first node to last
  bool is_skew = false;  // along none of east, north and up, by more than half a degree
};

struct CentreLine {
  std::vector<LineNode> nodes;
  std::vector<LineEdge> edges;
  std::vector<LineRun> runs;  // each edge is in one
};

// kBadInput where the design has no parts with ports, as a bare mesh or cloud: then there is
// nothing a line drawing could be made of, and the sentence says what would help. Branch fittings
// stand on their run's centre line. Pure; any thread.
[[nodiscard]] Result<CentreLine> centre_line(const DesignModel& design, const Compass& compass);

// Where a part's axes meet, in the design frame (m): of elbows, tees and crosses; nothing of parts
// whose ports lie in one line.
[[nodiscard]] std::optional<Eigen::Vector3d> centre_of(const Part& part);

}  // namespace spool::guide
