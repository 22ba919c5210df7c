// A scene, its camera and its motion: any frame by its number.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/simulator/simulator.h"

#include "tools/simulator/sensor_model.h"
#include "tools/simulator/trajectory.h"

namespace spool::simulator {

Result<Simulator> Simulator::open(const std::filesystem::path& path) {
  auto scene = read_scene(path);
  if (!scene) return scene.error();
  auto built = build_world(*scene, path.string());
  if (!built) return built.error();
  auto world = std::make_unique<World>(*std::move(built));
  auto caster = Caster::create(*world);
  if (!caster) return caster.error();
  return Simulator(*std::move(scene), std::move(world), *std::move(caster));
}

Pose Simulator::T_map_camera(std::int64_t index) const {
  const double seconds = static_cast<double>(index) / scene_.sensor.frames_per_second;
  return camera_pose(scene_.trajectory, scene_.trajectory.centre_m.value_or(world_->centre),
                     seconds);
}

void Simulator::look(std::int64_t index, IdealImage& image) const {
  // A little beyond the sensor's reach, so that noise decides about what lies at its end.
  caster_.cast(scene_.sensor.camera, T_map_camera(index), 1.2 * scene_.sensor.far_m, image);
}

IdealImage Simulator::ideal(std::int64_t index) const {
  IdealImage image;
  look(index, image);
  return image;
}

void Simulator::frame(std::int64_t index, FrameBuffers& buffers, DepthFrame& frame) const {
  look(index, buffers.image);
  sense(scene_.sensor, buffers.image, index, buffers.noise, frame);
}

DepthFrame Simulator::frame(std::int64_t index) const {
  FrameBuffers buffers;
  DepthFrame made;
  frame(index, buffers, made);
  return made;
}

}  // namespace spool::simulator
