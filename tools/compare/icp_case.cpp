// Cases for refinement, from the campaign's scenes.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/compare/icp_case.h"

#include <algorithm>
#include <random>

#include "tools/campaign/labels.h"
#include "tools/campaign/scene.h"
#include "vision/design/design_model.h"
#include "vision/design/sampling.h"
#include "vision/scan/point_index.h"

namespace spool::compare {
namespace {

// The mesh as a design of one part, as a file without semantics is read.
DesignModel as_design(TriangleMesh mesh) {
  DesignModel model;
  Part part;
  part.name = "spool";
  part.triangle_count = static_cast<std::uint32_t>(mesh.triangles.size());
  model.triangle_part.assign(mesh.triangles.size(), 0);
  model.parts.push_back(part);
  model.mesh = std::move(mesh);
  return model;
}

Eigen::Vector3d random_direction(std::mt19937& random) {
  std::normal_distribution<double> gauss(0, 1);
  const double x = gauss(random), y = gauss(random), z = gauss(random);
  return Eigen::Vector3d(x, y, z).normalized();
}

// The object's points and the clutter near them, `count` in all, in no order.
PointCloud near_object(const campaign::Scene& scene, double within_m, std::size_t count,
                       std::mt19937& random) {
  PointCloud object, kept;
  for (std::size_t i = 0; i < scene.cloud.size(); ++i)
    if (scene.labels[i] < campaign::kFloor) object.points.push_back(scene.cloud.points[i]);
  const PointIndex index(object.points);
  kept.points = object.points;
  for (std::size_t i = 0; i < scene.cloud.size(); ++i)
    if (scene.labels[i] >= campaign::kFloor &&
        index.nearest(scene.cloud.points[i], static_cast<float>(within_m)))
      kept.points.push_back(scene.cloud.points[i]);
  std::shuffle(kept.points.begin(), kept.points.end(), random);
  if (kept.points.size() > count) kept.points.resize(count);
  return kept;
}

}  // namespace

Result<IcpCase> make_icp_case(const IcpCaseRequest& request) {
  std::mt19937 random{request.seed};
  campaign::SceneRequest wanted;
  wanted.seed = request.seed;
  wanted.station_error_m = request.station_error_m;
  // Three of four points are clutter, most of it too far off to be kept.
  wanted.clutter_ratio = 3;
  wanted.scene_points = 4 * request.source_points;
  const campaign::Scene scene = campaign::make_scene(wanted);

  IcpCase made;
  made.noise_m = wanted.noise_m;
  auto design = PreparedDesign::prepare(as_design(scene.mesh()));
  if (!design) return design.error();
  made.design = std::move(*design);
  const DesignModel& exterior = made.design->exterior;
  made.target = sample_surface(exterior, request.target_points, request.seed).cloud;
  made.source = near_object(scene, request.clutter_within_m, request.source_points, random);
  made.T_true = scene.objects.front().T_scan_design.inverse();
  const Eigen::Vector3d centre = exterior.bounds().cast<double>().center();
  Pose off = Pose::Identity();
  off.linear() = Eigen::AngleAxisd(request.off_rad, random_direction(random)).toRotationMatrix();
  off.translation() = centre - off.linear() * centre + request.off_m * random_direction(random);
  made.T_guess = off * made.T_true;
  return made;
}

double mean_displacement(const IcpCase& of, const Pose& T_design_scan) {
  const Pose error = T_design_scan * of.T_true.inverse();
  double sum = 0;
  for (const Eigen::Vector3f& p : of.target.points) {
    const Eigen::Vector3d q = p.cast<double>();
    sum += (error * q - q).norm();
  }
  return sum / static_cast<double>(of.target.size());
}

}  // namespace spool::compare
