// What the simulated camera looks at, as a JSON file describes it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "vision/core/camera.h"
#include "vision/core/pose.h"
#include "vision/core/result.h"

namespace spool::simulator {

// How one part was built other than drawn. Everything is in the part's own frame.
struct AsBuiltChange {
  std::string part;
  Eigen::Vector3d translation_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d rotation_rad = Eigen::Vector3d::Zero();  // rotation vector
  std::string about;      // the port that the rotation leaves in place; empty: the part's origin
  double length_m = 0;    // a pipe longer by this; its end nearer the datum stays
  bool followers = true;  // the parts joined on beyond it move along
  bool missing = false;   // the part is not there; the parts beyond it are
};

enum class BodyKind { kBox, kCylinder };

// A thing that is not of the design: clutter, the table, the floor.
struct Body {
  std::string name;
  BodyKind kind = BodyKind::kBox;
  Eigen::Vector3d size_m =
      Eigen::Vector3d::Ones();         // box: edges; cylinder: diameter, diameter, length
  Pose T_map_body = Pose::Identity();  // the body's centre; a cylinder's axis is its z
  bool bright_metal = false;
};

enum class TrajectoryKind { kOrbit, kFixed };

// Hand-held round the spool, or standing still.
struct Trajectory {
  TrajectoryKind kind = TrajectoryKind::kOrbit;
  std::optional<Eigen::Vector3d> centre_m;  // map frame; unset: the middle of the spool
  double near_m = 0.6, far_m = 1.2;         // distance to the centre
  double sweep_rad = 2.0;                   // to either side of the first view
  double start_rad = 0.0;                 // azimuth of the middle of the sweep, from map x to map y
  double low_rad = 0.45, high_rad = 1.0;  // elevation above the horizon
  double period_s = 40;                   // there and back
  double tremor_m = 0.004, tremor_rad = 0.008;  // standard deviations of the hand's
  std::uint32_t seed = 1;
  Pose T_map_camera = Pose::Identity();  // of a fixed one
};

// The simulated depth camera (ARCHITECTURE, The sensor).
struct SensorSettings {
  Camera camera;
  double frames_per_second = 30;
  bool noise = true;    // off: exact depth, rounded to counts only
  bool dropout = true;  // grazing angles and bright metal
  bool shadow = true;   // what the projector does not light
  std::uint32_t seed = 1;
  double baseline_m = 0.075;  // projector to camera
  double near_m = 0.4, far_m = 4.0;
  double radial_warp = 0;  // fraction of depth at the image's corner
  double scale_error = 0;  // fraction of depth
  bool mirrored = false;   // the driver mirrors until it is told not to, as many do
};

// When the live device goes away and comes back, on its own clock.
struct Unplugging {
  double at_s = 0;
  double for_s = 1;
};

// Map frame: metres, z up.
struct Scene {
  std::filesystem::path design;  // empty: no spool
  Pose T_map_design = Pose::Identity();
  bool on_table = true;  // T_map_design not given: y up becomes z up, resting on the table's middle
  std::vector<AsBuiltChange> as_built;
  std::vector<Body> bodies;
  double table_height_m = 0;
  Trajectory trajectory;
  SensorSettings sensor;
  std::vector<Unplugging> unplug;
};

// Reads a scene; a design's path is relative to the scene's file. kBadInput with one sentence
// naming file and key for anything missing, of the wrong kind, not finite or out of range.
[[nodiscard]] Result<Scene> read_scene(const std::filesystem::path& path);

}  // namespace spool::simulator
