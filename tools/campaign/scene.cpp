// A scene to measure accuracy on: what the sensor makes of a room.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/campaign/scene.h"

#include <algorithm>
#include <cmath>

#include "tools/campaign/design_glb.h"
#include "tools/campaign/handheld.h"
#include "tools/campaign/laser.h"
#include "tools/campaign/removal.h"
#include "tools/campaign/scene_room.h"
#include "tools/campaign/thin_to.h"

namespace spool::campaign {
namespace {

// `area` (m2) is what could be seen of the object.
PointTargets targets_of(const SceneRequest& request, double area) {
  const double scene = request.density_ratio > 0
                           ? request.density_ratio * static_cast<double>(kModelPoints)
                           : static_cast<double>(request.scene_points);
  // The ratios hold for what is left after the removal.
  const double left = scene / (1 + request.clutter_ratio);
  // Without the object the scene is cropped where it would be with it.
  if (request.copies == 0) return {0, static_cast<std::size_t>(std::lround(scene)), left / area};
  return {static_cast<std::size_t>(std::lround(left / request.completeness)),
          static_cast<std::size_t>(std::lround(scene - left))};
}

std::vector<SensedPoint> sense(const SceneRequest& request, const RayWorld& world,
                               const PointTargets& targets, const Eigen::AlignedBox3d& object,
                               const Scene& scene) {
  if (request.sensor == SensorKind::kHandheld) {
    const auto points = scan_by_hand(world, {}, scene.T_scan_camera, request.seed);
    return thinned_to(points, targets, object, Random(request.seed, kThinning));
  }
  LaserSettings laser;
  laser.noise_m = request.noise_m;
  laser.station_error_m = request.station_error_m;
  laser.stations = scene.station_positions;
  return scan_with_laser(world, laser, targets, object, request.seed);
}

void shuffle(std::vector<SensedPoint>& points, Random random) {
  for (std::size_t i = points.size(); i > 1; --i)
    std::swap(points[i - 1], points[static_cast<std::size_t>(random.bits() % i)]);
}

}  // namespace

Scene make_scene(const SceneRequest& request) {
  SceneRoom room = make_room(request);
  Scene& scene = room.scene;
  const RayWorld world(std::move(room.placed));
  std::vector<SensedPoint> points =
      sense(request, world, targets_of(request, room.area_m2), room.object, scene);
  scene.completeness =
      remove_pieces(scene, request.completeness, Random(request.seed, kRemoving), points);
  shuffle(points, Random(request.seed, kShuffling));
  for (const SensedPoint& each : points) {
    scene.cloud.points.push_back(each.point);
    scene.labels.push_back(each.label);
    scene.instances.push_back(each.instance);
    scene.stations.push_back(each.station);
    if (each.instance != kNoInstance) ++scene.object_points;
  }
  if (scene.object_points > 0)
    scene.clutter_ratio = static_cast<double>(points.size() - scene.object_points) /
                          static_cast<double>(scene.object_points);
  return std::move(room.scene);
}

std::string Scene::glb() const { return design_glb(design); }

TriangleMesh Scene::mesh() const { return design_mesh(design); }

}  // namespace spool::campaign
