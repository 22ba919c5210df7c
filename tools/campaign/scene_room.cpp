// What stands where in a scene, before any sensor looks.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/campaign/scene_room.h"

#include <algorithm>
#include <cmath>

#include "tools/campaign/clutter.h"
#include "tools/campaign/handheld.h"
#include "tools/campaign/laser.h"
#include "tools/campaign/placement.h"
#include "tools/campaign/symmetry.h"

namespace spool::campaign {
namespace {

using Eigen::Vector3d;

struct Stage {
  Room room;
  std::vector<Eigen::AlignedBox3d> objects = {};
  Eigen::AlignedBox3d object = {};  // round all of them
  std::vector<Ground> tables = {};  // that an object lies on
};

std::vector<Pose> moved(const Pose& T_scan_design, std::vector<Pose> poses) {
  for (Pose& pose : poses) pose = T_scan_design * pose;
  return poses;
}

Eigen::AlignedBox3d box_of(const Boxes& boxes, std::size_t first) {
  Eigen::AlignedBox3d box;
  for (std::size_t i = first; i < boxes.size(); ++i) box.extend(boxes[i]);
  return box;
}

// Where the object stands is drawn for the design as drawn, so that a defect does not move the
// datum; but what would reach through floor or table lifts it.
Stage place_objects(const SceneRequest& request, Scene& scene) {
  Stage stage;
  Random random(request.seed, kPlacing);
  const bool frame = request.kind == ObjectKind::kBoxFrame;
  const bool small = request.kind == ObjectKind::kSmallSpool;
  const int copies = std::max(request.copies, 1);
  double edge = 0;  // of the copies before, along x
  for (int copy = 0; copy < copies; ++copy) {
    const double table = random.uniform(0.75, 0.95);
    const double stands = random.chance(0.8) ? random.uniform(0.45, 0.8) : 0.02;
    const double height = frame ? 0.001 : small ? table + 0.002 : stands;
    Instance instance{laid_down(scene.design, height, frame, random)};
    const double through = height - lowest_of(scene.as_built, instance.T_scan_design);
    if (through > 0) instance.T_scan_design.pretranslate(Vector3d(0, 0, through));
    Room alone;
    instance.T_scan_part = moved(instance.T_scan_design, poses_of(scene.as_built));
    add_assembly(scene.as_built, instance.T_scan_part, 0, true, static_cast<std::uint8_t>(copy),
                 alone);
    // A copy stands beside the one before it, half a metre off.
    const Eigen::AlignedBox3d lone = box_of(alone.taken, 0);
    const Vector3d shift(copy == 0 ? 0 : edge + 0.5 - lone.min().x(), 0, 0);
    edge = lone.max().x() + shift.x();
    instance.T_scan_design.pretranslate(shift);
    instance.T_scan_part = moved(instance.T_scan_design, poses_of(scene.as_built));
    const std::size_t first = stage.room.placed.size();
    const std::size_t first_taken = stage.room.taken.size();
    add_assembly(scene.as_built, instance.T_scan_part, 0, true, static_cast<std::uint8_t>(copy),
                 stage.room);
    stage.objects.push_back(box_of(stage.room.taken, first_taken));
    stage.object.extend(stage.objects.back());
    const std::vector<Placed> object(stage.room.placed.begin() + static_cast<long>(first),
                                     stage.room.placed.end());
    if (small) {
      const double margin = copies > 1 ? 0.2 : 0.45;
      const Vector3d half = stage.objects.back().sizes() / 2 + Vector3d::Constant(margin);
      const Ground top{stage.objects.back().center().head<2>(), half.head<2>(), table};
      add_table(top, stage.room);
      stage.tables.push_back(top);
    } else if (!frame && height > 0.1) {
      add_stands(object, random, stage.room);
    }
    scene.objects.push_back(instance);
  }
  return stage;
}

// Fills the room round what stands there already; `area` (m2) is what can be seen of the object.
void furnish(const SceneRequest& request, double area, const Assembly& design, Stage& stage) {
  // At one spacing for all, clutter needs its ratio of that area. A part of it is the floor's; the
  // room is as large as the rest needs.
  const double needed = std::clamp(request.clutter_ratio * area, 2.0, 600.0);
  const double half = 0.5 * std::sqrt(0.6 * needed);
  const Vector3d reach = stage.object.min().cwiseAbs().cwiseMax(stage.object.max().cwiseAbs());
  stage.room.half_x = std::max({stage.room.half_x, half, reach.x() + 1.5});
  stage.room.half_y = std::max({stage.room.half_y, half, reach.y() + 1.5});
  add_floor_and_walls(stage.room);
  std::vector<double> sizes;
  for (const Member& member : design.members)
    if (member.spec.kind == PartKind::kPipe) sizes.push_back(member.spec.nps);
  if (sizes.empty()) sizes = {3, 4, 6};
  Random random(request.seed, kFurnishing);
  // On a table a third of what there is to see lies beside the object.
  double left = 0.6 * needed;
  for (const Ground& top : stage.tables) {
    add_items(left / 3, top, sizes, random, stage.room);
    left *= 2.0 / 3;
  }
  const Ground floor{{0, 0}, {stage.room.half_x, stage.room.half_y}, 0};
  add_items(left, floor, sizes, random, stage.room);
}

// Every weld and cut a little off.
void weld(const SceneRequest& request, Assembly& as_built) {
  Random random(request.seed, kWelding);
  for (Member& member : as_built.members) {
    if (member.spec.kind == PartKind::kPipe)
      member.spec.length_m += request.cut_m * random.normal();
    if (member.parent < 0 || member.parent_port < 0) continue;
    const Vector3d shift = request.joint_m * random.normals();
    const Vector3d turn = request.joint_rad * random.normals();
    Pose error(Eigen::Translation3d{shift});
    if (turn.norm() > 0) error.rotate(Eigen::AngleAxisd(turn.norm(), turn.normalized()));
    member.joint_error = error * member.joint_error;
  }
}

}  // namespace

SceneRoom make_room(const SceneRequest& request) {
  SceneRoom made{Scene{request}};
  Scene& scene = made.scene;
  scene.design = design_of(request.kind, request.seed, request.braced);
  scene.as_built =
      with_defects(scene.design, Random(request.seed, kDefects), scene.request.defects);
  if (request.joint_m > 0 || request.joint_rad > 0 || request.cut_m > 0)
    weld(request, scene.as_built);
  scene.symmetries = symmetries_of(scene.design);
  Stage stage = place_objects(request, scene);
  Random random(request.seed, kStations);
  scene.station_positions = stations_round(stage.object, request.stations, random, stage.room);
  made.area_m2 =
      seen_object_area(RayWorld(stage.room.placed), scene.station_positions, request.seed);
  furnish(request, made.area_m2, scene.design, stage);
  if (request.sensor == SensorKind::kHandheld)
    scene.T_scan_camera = walk_round(RayWorld(stage.room.placed), {.frames = request.frames},
                                     stage.object, request.seed);
  if (request.copies == 0) {
    // Where the object would have stood there is nothing; all else is as with it.
    scene.objects.clear();
    std::erase_if(stage.room.placed,
                  [](const Placed& each) { return each.instance != kNoInstance; });
  }
  made.object = stage.object;
  made.placed = std::move(stage.room.placed);
  return made;
}

}  // namespace spool::campaign
