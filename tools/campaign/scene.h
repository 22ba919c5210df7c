// A scene to measure accuracy on: an object as built among clutter, as a sensor saw it, and the
// whole truth about it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "tools/campaign/defects.h"
#include "tools/campaign/designs.h"
#include "tools/campaign/labels.h"
#include "vision/core/point_cloud.h"
#include "vision/core/triangle_mesh.h"

namespace spool::campaign {

enum class SensorKind { kLaser, kHandheld };

// The thesis's density ratio (4.4.2.1) is scene points over the points that the design was sampled
// with: its ratio 10 is a scene of 100 000.
inline constexpr std::size_t kModelPoints = 10'000;

struct SceneRequest {
  ObjectKind kind = ObjectKind::kPipeSpool3m;
  std::uint32_t seed = 1;
  bool braced = true;  // a box frame with members that break its symmetry
  int copies = 1;      // how many objects of the design stand there; 0: none

  SensorKind sensor = SensorKind::kLaser;
  double noise_m = 0.003;           // laser: standard deviation along the ray
  int stations = 4;                 // laser
  double station_error_m = 0.0006;  // laser: each station's registration, one axis
  int frames = 36;                  // handheld

  std::size_t scene_points = 80'000;
  double density_ratio = 0;   // over 0: scene_points is this times kModelPoints
  double clutter_ratio = 12;  // points of clutter for each point of the object
  double completeness = 1;  // share of the object's points that is left, the rest cut off in whole
                            // pieces
  std::vector<Defect> defects = {};
  // What every shop is off by: standard deviations of each weld, along and about each axis of its
  // port, and of each pipe's cut length.
  double joint_m = 0, joint_rad = 0, cut_m = 0;
};

// One object of the design that stands in the scene.
struct Instance {
  Pose T_scan_design = Pose::Identity();  // at the first part
  std::vector<Pose> T_scan_part = {};     // as built, of every member of `as_built`
};

struct Scene {
  SceneRequest request;                      // its defects completed: which part, how much
  PointCloud cloud;                          // m, scan frame, z up, in no order
  std::vector<std::uint16_t> labels = {};    // member of `as_built`, or 1000 and up for clutter
  std::vector<std::uint8_t> instances = {};  // of each point, kNoInstance for clutter
  std::vector<std::uint8_t> stations = {};   // of each point; the frame of a handheld sensor

  Assembly design, as_built;  // as_built may hold more members behind the design's
  std::vector<Instance> objects = {};
  std::vector<Pose> symmetries = {};  // that map the design onto itself, the identity first
  std::vector<Eigen::Vector3d> station_positions = {};  // m, scan frame; laser
  std::vector<Pose> T_scan_camera = {};                 // of each frame; handheld

  std::size_t object_points = 0;
  double clutter_ratio = 0;  // as it came out; of an empty scene 0
  double completeness = 1;

  // The design as a file's bytes, and as one mesh in the design frame.
  [[nodiscard]] std::string glb() const;
  [[nodiscard]] TriangleMesh mesh() const;
};

// The same scene for the same request, whatever the number of threads. Scenes that differ in
// density, completeness, noise, or in whether the object is there show the same room; the object
// stands in the same place with defects too, unless they would reach through the floor.
[[nodiscard]] Scene make_scene(const SceneRequest& request);

}  // namespace spool::campaign
