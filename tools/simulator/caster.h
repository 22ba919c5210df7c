// What an ideal camera sees: exact depth, incidence and material of each pixel, by ray casting.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "tools/simulator/world.h"
#include "vision/core/camera.h"
#include "vision/core/pose.h"

namespace spool::simulator {

// Row-major, row 0 at the top.
struct IdealImage {
  int width = 0, height = 0;         // px
  std::vector<float> depth;          // m along the optical axis; 0: nothing there
  std::vector<float> incidence;      // rad between the ray and the surface's normal, 0 to pi/2
  std::vector<std::int32_t> part;    // of the design; -1: clutter or nothing
  std::vector<std::uint8_t> bright;  // 1: bright metal
};

// Embree over the world. Const casts from any thread.
class Caster {
 public:
  [[nodiscard]] static Result<Caster> create(const World& world);
  Caster(Caster&&) noexcept;
  Caster& operator=(Caster&&) noexcept;
  ~Caster();

  // Depth up to far_m. The world must be alive.
  void cast(const Camera& camera, const Pose& T_map_camera, double far_m, IdealImage& image) const;

 private:
  struct Impl;
  explicit Caster(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace spool::simulator
