// The body of a component out of the catalogue, where the file puts it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "vision/piping/pipework.h"
#include "vision/piping/solid.h"

namespace spool::piping {

// Positions and directions in the part's own frame, metres.
struct PartPort {
  std::string name;  // in out weld face run branch branch2
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();  // unit, outward
  double nps = 0;
  std::string end;
  int port = 0;  // the component's, or kOnRun
};

struct PartHoles {
  int count = 0;
  double bolt_circle = 0, clocking = 0;  // m, rad from x about +z
};

struct PartMark {
  std::string type;  // tap vent drain spindle flat_side
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();  // unit
  double size = 0;                                       // m
};

struct PartShape {
  Eigen::Isometry3d T_file_part = Eigen::Isometry3d::Identity();
  Solid solid;
  std::vector<PartPort> ports;
  std::optional<PartHoles> holes;
  std::vector<PartMark> marks;
  double nps = 0, nps2 = 0;
};

// The shape of a component of a connected pipework. A flange's z is its axis and looks out of the
// face, its bolt holes straddle x, which looks up, or north where the axis is vertical (two-holed
// on the natural centre lines; PCF does not hold clocking). Pipes, elbows and reducers have z along
// their way from the first end, tees and crosses along the run from the centre, with x towards the
// branch. What the catalogue does not hold is drawn as a plain body between its ends. Nothing for
// welds, bolts, supports, and for what has no length; then, where that is odd, a problem says so.
[[nodiscard]] std::optional<PartShape> shape_of(const Pipework& pipework, int component,
                                                std::vector<Problem>& problems);

}  // namespace spool::piping
