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

IdealImage Simulator::ideal(std::int64_t index) const {
  IdealImage image;
  // A little beyond the sensor's reach, so that noise decides about what lies at its end.
  caster_.cast(scene_.sensor.camera, T_map_camera(index), 1.2 * scene_.sensor.far_m, image);
  return image;
}

DepthFrame Simulator::frame(std::int64_t index) const {
  DepthFrame frame;
  sense(scene_.sensor, ideal(index), index, frame);
  return frame;
}

}  // namespace spool::simulator
