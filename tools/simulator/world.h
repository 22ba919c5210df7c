// All that the simulated camera can see, as one triangle mesh.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tools/simulator/as_built.h"
#include "tools/simulator/scene.h"
#include "vision/design/design_model.h"

namespace spool::simulator {

struct World {
  std::optional<DesignModel> design;
  AsBuilt as_built;  // empty without a design
  Pose T_map_design = Pose::Identity();
  Eigen::Vector3d centre =
      Eigen::Vector3d::Zero();              // m, map frame: of the spool, else of the clutter
  TriangleMesh mesh;                        // map frame, m
  std::vector<std::int32_t> triangle_part;  // of the design's; -1: clutter
  std::vector<std::uint8_t> bright;         // 1: machined or galvanised metal
};

// Reads the design and puts everything in its place. Flange faces (at a port of end FL, or the
// outer port of a flange without ends) count as bright metal.
[[nodiscard]] Result<World> build_world(const Scene& scene, const std::string& file);

}  // namespace spool::simulator
