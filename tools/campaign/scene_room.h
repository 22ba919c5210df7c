// The room of a scene: the object as built among clutter, before any sensor looks.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "tools/campaign/ray_world.h"
#include "tools/campaign/scene.h"

namespace spool::campaign {

// Streams of the request's seed: what one purpose draws does not move another's numbers.
enum Stream : std::uint64_t {
  kPlacing = 101,
  kStations,
  kFurnishing,
  kRemoving,
  kShuffling,
  kDefects,
  kThinning,
  kBumping,
  kWelding
};

// The scene's truth without its points, and everything that stands there.
struct SceneRoom {
  Scene scene;
  std::vector<Placed> placed = {};
  Eigen::AlignedBox3d object = {};  // m, scan frame, round all copies
  double area_m2 = 0;               // of the object, that can be seen from somewhere
};

// Scan frame: z up, the floor at z = 0. The same for the same request.
[[nodiscard]] SceneRoom make_room(const SceneRequest& request);

}  // namespace spool::campaign
