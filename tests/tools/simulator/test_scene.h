// Scenes as tests write them.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fstream>
#include <string>

#include "tests/support/temporary_folder.h"
#include "tools/simulator/simulator.h"

namespace spool::simulator {

// A camera at the map's origin that looks along y: its x is the map's x, its y the map's -z.
inline constexpr char kLooksAlongY[] =
    R"("table": null, "floor": false,
       "trajectory": {"kind": "fixed", "T_map_camera": [1,0,0,0, 0,0,1,0, 0,-1,0,0, 0,0,0,1]})";

// Opens {kLooksAlongY, more}.
inline Result<Simulator> open_scene(const std::string& more) {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "scene.json";
  std::ofstream(path) << "{" << kLooksAlongY << (more.empty() ? "" : ",") << more << "}";
  return Simulator::open(path);
}

// A thick plate, its near face at `depth` m from the camera, turned by `tilt` rad about the
// vertical.
inline std::string plate(double depth, double tilt = 0) {
  // The near face's centre stays at `depth` on the optical axis.
  const double half = 0.05;
  return R"({"kind": "box", "size_m": [20, 0.1, 20], "position_m": [)" +
         std::to_string(-half * std::sin(tilt)) + "," +
         std::to_string(depth + half * std::cos(tilt)) + R"(, 0], "rotation_rad": [0, 0, )" +
         std::to_string(tilt) + "]}";
}

}  // namespace spool::simulator
