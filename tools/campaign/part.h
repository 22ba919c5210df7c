// A part of a spool or frame by its standard sizes: its ports, and its surface as patches.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tools/campaign/patch.h"

namespace spool::campaign {

enum class PartKind { kPipe, kElbow, kTee, kReducer, kFlange, kCap, kTube };
[[nodiscard]] const char* word(PartKind kind);  // pipe, elbow, ...

// A pipe, reducer, cap or tube runs from z = 0 upwards; an elbow leaves z = 0 upwards and bends to
// x; a tee's run is as a pipe, its branch looks to x; a flange's face lies in z = 0 and looks down.
struct PartSpec {
  PartKind kind = PartKind::kPipe;
  std::string name;
  double nps = 0, nps2 = 0;  // inches; nps2 of a reducer's small end and of a tee's branch
  double length_m = 0;       // of a pipe or tube
  double angle_rad = 0;      // of an elbow
  double width_m = 0;        // of a square tube
};

inline constexpr double kTubeWall = 0.006;  // m

struct PartPort {
  std::string_view name;
  Pose T_part_port = Pose::Identity();  // z outward
  double nps = 0;
  std::string_view end;  // BW, FL or PL
};

// pipe, elbow, reducer, tube: in, out; tee: in, out, branch; flange: face, weld; cap: in.
[[nodiscard]] std::vector<PartPort> ports_of(const PartSpec& spec);

// The whole surface, bores included, in the part's frame.
[[nodiscard]] std::vector<Patch> patches_of(const PartSpec& spec);

// Distance (m) from an elbow's bend centre to its middle line: B16.9's long radius, and for 45
// degrees the arc that meets the standard's centre to end.
[[nodiscard]] double bend_radius(const PartSpec& elbow);

// The angle (rad) of a flange's first bolt hole: holes straddle the x axis.
[[nodiscard]] double hole_clocking(int holes);

}  // namespace spool::campaign
