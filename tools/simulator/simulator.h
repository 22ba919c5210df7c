// A scene, its camera and its motion: any frame by its number, with the truth about it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>

#include "tools/simulator/caster.h"
#include "tools/simulator/noise_field.h"
#include "tools/simulator/scene.h"
#include "tools/simulator/world.h"
#include "vision/core/depth_frame.h"

namespace spool::simulator {

// What making a frame needs beside the frame itself. Who makes many keeps it from one to the next:
// the first touch of fresh memory costs as much as half of the work.
struct FrameBuffers {
  IdealImage image;
  NoiseField noise;
};

// Const functions from any thread. Frame n is the same whenever and wherever it is asked for.
class Simulator {
 public:
  [[nodiscard]] static Result<Simulator> open(const std::filesystem::path& scene);

  [[nodiscard]] const Scene& scene() const { return scene_; }
  [[nodiscard]] const World& world() const { return *world_; }
  [[nodiscard]] Pose T_map_camera(std::int64_t index) const;
  [[nodiscard]] DepthFrame frame(std::int64_t index) const;
  void frame(std::int64_t index, FrameBuffers& buffers, DepthFrame& frame) const;  // the same
  // The same without sensor: exact depth and the part of each pixel.
  [[nodiscard]] IdealImage ideal(std::int64_t index) const;

 private:
  Simulator(Scene scene, std::unique_ptr<World> world, Caster caster)
      : scene_(std::move(scene)), world_(std::move(world)), caster_(std::move(caster)) {}
  void look(std::int64_t index, IdealImage& image) const;

  Scene scene_;
  std::unique_ptr<World> world_;  // where the caster expects it
  Caster caster_;
};

}  // namespace spool::simulator
