// A scene, its camera and its motion: any frame by its number, with the truth about it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>

#include "tools/simulator/caster.h"
#include "tools/simulator/scene.h"
#include "tools/simulator/world.h"
#include "vision/core/depth_frame.h"

namespace spool::simulator {

// Const functions from any thread. Frame n is the same whenever and wherever it is asked for.
class Simulator {
 public:
  [[nodiscard]] static Result<Simulator> open(const std::filesystem::path& scene);

  [[nodiscard]] const Scene& scene() const { return scene_; }
  [[nodiscard]] const World& world() const { return *world_; }
  [[nodiscard]] Pose T_map_camera(std::int64_t index) const;
  [[nodiscard]] DepthFrame frame(std::int64_t index) const;
  // The same without sensor: exact depth and the part of each pixel.
  [[nodiscard]] IdealImage ideal(std::int64_t index) const;

 private:
  Simulator(Scene scene, std::unique_ptr<World> world, Caster caster)
      : scene_(std::move(scene)), world_(std::move(world)), caster_(std::move(caster)) {}

  Scene scene_;
  std::unique_ptr<World> world_;  // where the caster expects it
  Caster caster_;
};

}  // namespace spool::simulator
