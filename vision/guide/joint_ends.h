// A design's joints as seen from one of their parts: own port, the neighbour and its port.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "vision/design/design_model.h"

namespace spool::guide {

// One joint from the side of a part; indices into the design's joints, parts and ports.
struct JointEnd {
  int joint = -1;
  int port = -1;
  int neighbour = -1;
  int neighbour_port = -1;
};

// The joints of each part, in the design's order. Joints of which a part or port is not there are
// left out. Pure; any thread.
[[nodiscard]] std::vector<std::vector<JointEnd>> joint_ends(const DesignModel& design);

// The joint at a part's port; nothing where that end is open.
[[nodiscard]] std::optional<JointEnd> at_port(const std::vector<JointEnd>& ends, int port);

// A port of a part in the design frame: place (m) and unit direction outward.
struct PortPlace {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();
};
[[nodiscard]] PortPlace place_of(const Part& part, int port);

// The port that looks the other way in line with `port`, the furthest of them; -1 where there is
// none (an elbow's, a cap's).
[[nodiscard]] int opposite_port(const Part& part, int port);

}  // namespace spool::guide
