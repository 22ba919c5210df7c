// One spool as a shop builds it, scanned and inspected.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/campaign/dimension_trial.h"

#include "tools/campaign/built_truth.h"
#include "tools/campaign/depth_video.h"
#include "tools/campaign/hand_motion.h"
#include "tools/campaign/scene_design.h"
#include "tools/campaign/scene_room.h"
#include "vision/core/median.h"
#include "vision/scan/back_projection.h"
#include "vision/scan/noise_estimate.h"
#include "vision/scan/normals.h"
#include "vision/scan/reading_noise.h"

namespace spool::campaign {
namespace {

// Streams of a seed that scenes do not draw from.
constexpr std::uint64_t kScale = 301;

// A scan in metres by a sensor whose metre is a little long.
struct Scan {
  PointCloud cloud;
  NoiseModel noise;
  Pose T_design_scan = Pose::Identity();
  double correlated = 1;
};

Scan cloud_scan(const SceneRequest& request, Scene& scene) {
  scene = make_scene(request);
  Scan scan;
  scan.noise.constant_m = estimate_noise(scene.cloud);
  scan.cloud = scene.cloud;
  scan.T_design_scan = scene.objects.front().T_scan_design.inverse();
  return scan;
}

Result<Scan> frame_scan(const SceneRequest& request, Scene& scene) {
  SceneRoom room = make_room(request);
  const RayWorld world(std::move(room.placed));
  HandSettings hand;
  hand.nearest_m = 0.7;
  hand.farthest_m = 1.0;
  HandheldSettings settings;
  settings.pixel_step = 1;
  const HandMotion motion(world, room.object, hand, request.seed);
  const Pose T_scan_camera = motion.T_scan_camera(0);
  const DepthFrame frame = film(world, nullptr, settings, T_scan_camera, request.seed, 0, 0);
  const Camera camera = camera_of(settings);
  auto organised = back_project(frame, camera);
  if (!organised) return organised.error();
  Scan scan;
  estimate_organised_normals(*organised, camera, scan.noise);
  scan.cloud = measured_points(*organised);
  scan.T_design_scan = room.scene.objects.front().T_scan_design.inverse() * T_scan_camera;
  scan.correlated = correlated_readings(camera, 1);
  scene = std::move(room.scene);
  return scan;
}

// Depth that is bent by r^2 from the picture's middle to its corners.
void warp(double corner_m, PointCloud& cloud) {
  std::vector<float> depths;
  float most = 0;
  for (const Eigen::Vector3f& p : cloud.points) {
    depths.push_back(p.z());
    most = std::max(most, (p.head<2>() / p.z()).squaredNorm());
  }
  const double share = corner_m / static_cast<double>(median(depths));
  for (Eigen::Vector3f& p : cloud.points)
    p *= 1 + static_cast<float>(share) * (p.head<2>() / p.z()).squaredNorm() / most;
}

// `datum`: the face that offsets and rotations are seen from.
std::optional<double> truth_of(const Dimension& stated, const BuiltTruth& built,
                               const BuiltTruth& drawn, const std::string& datum) {
  std::optional<double> value;
  if (stated.kind == "rotation") return built.turn(drawn, datum, stated.from, stated.to);
  if (stated.kind == "angle")
    value = built.angle(stated.from, stated.to);
  else if (stated.kind == "face_alignment")
    value = built.lean(stated.from, stated.to);
  else if (stated.kind != "offset")  // no truth of these here
    value = built.length(stated.from, stated.to);
  if (value) *value -= stated.nominal;
  return value;
}

}  // namespace

std::vector<DimensionRow> dimension_rows() {
  SceneRequest laser{.kind = ObjectKind::kRandomSpool, .noise_m = 0.002, .scene_points = 160'000};
  laser.clutter_ratio = 3;
  laser.joint_m = 0.001;
  laser.joint_rad = 0.002;
  laser.cut_m = 0.001;
  SceneRequest hand = laser;
  hand.sensor = SensorKind::kHandheld;
  SceneRequest small = laser;
  small.kind = ObjectKind::kSmallSpool;
  std::vector<DimensionRow> rows;
  // What scanners' makers and registration reports state is what these scenes have.
  const double stations_m = laser.station_error_m;
  rows.push_back({.name = "laser, calibrated", .request = laser, .warp_u_m = stations_m});
  rows.push_back({.name = "laser, uncalibrated",
                  .request = laser,
                  .scale_u = 0.005,
                  .warp_u_m = 0.002 / 4});  // as of any cloud: a quarter of its noise
  rows.push_back({.name = "merged hand-held, calibrated", .request = hand});
  rows.push_back({.name = "one frame, calibrated", .request = small, .single_frame = true});
  SceneRequest exact = laser;
  exact.joint_m = exact.joint_rad = exact.cut_m = 0;
  exact.defects = {{.kind = DefectKind::kLong, .amount = 4.5}};
  rows.push_back({.name = "pipe 4.5 mm long, laser", .request = exact, .warp_u_m = stations_m});
  exact.defects = {{.kind = DefectKind::kTilted, .amount = 0.75}};
  rows.push_back(
      {.name = "flange leans 0.75 deg, laser", .request = exact, .warp_u_m = stations_m});
  // What no shop would call a tolerance.
  const auto gross = [&](DefectKind kind, double amount, const std::string& text) {
    SceneRequest wrong = laser;
    wrong.defects = {{.kind = kind, .amount = amount}};
    rows.push_back({.name = "gross: " + text, .request = wrong, .warp_u_m = stations_m});
  };
  gross(DefectKind::kLong, 25, "pipe 25 mm long");
  gross(DefectKind::kTilted, 3, "flange leans 3 deg");
  gross(DefectKind::kClocked, 0, "flange one-holed");
  gross(DefectKind::kTurned, 90, "elbow rolled 90 deg");
  gross(DefectKind::kMissing, 0, "flange missing");
  return rows;
}

Result<TriedSpool> run_dimensions(const DimensionRow& row, std::uint32_t seed) {
  SceneRequest request = row.request;
  request.seed = seed;
  Scene scene;
  auto scan =
      row.single_frame ? frame_scan(request, scene) : Result<Scan>(cloud_scan(request, scene));
  if (!scan) return scan.error();
  auto design = prepare_design(scene);
  if (!design) return design.error();
  Random random(seed, kScale);
  const double scale = 1 + row.scale_error + row.scale_u * random.normal();
  if (row.corner_warp_m != 0) warp(row.corner_warp_m, scan->cloud);
  // About the camera or, of a cloud, the datum: there the pose stays what it is.
  const Eigen::Vector3f fixed =
      row.single_frame ? Eigen::Vector3f(Eigen::Vector3f::Zero())
                       : Eigen::Vector3f(scan->T_design_scan.inverse().translation().cast<float>());
  for (Eigen::Vector3f& p : scan->cloud.points) p = fixed + static_cast<float>(scale) * (p - fixed);
  if (row.single_frame) {
    // The nearest pose of the datum in the picture that is too large.
    Pose T_scan_design = scan->T_design_scan.inverse();
    T_scan_design.translation() *= scale;
    scan->T_design_scan = T_scan_design.inverse();
  }
  InspectorOptions options;
  options.align = AlignMethod::kPose;
  options.T_design_scan = scan->T_design_scan;
  options.single_frame = row.single_frame;
  options.scale_u = row.stated_scale_u.value_or(row.scale_u);
  options.warp_u_m = row.warp_u_m;
  options.correlated = scan->correlated;
  auto inspection = Inspector(*design).process(scan->cloud, scan->noise, options);
  if (!inspection) return inspection.error();
  const BuiltTruth built(scene.as_built), drawn(scene.design);
  const std::string datum = inspection->datum.substr(0, inspection->datum.find(' '));
  TriedSpool tried;
  tried.defects = scene.request.defects;
  tried.scale = inspection->scale;
  tried.true_scale = scale;
  tried.warp = inspection->warp;
  tried.status = inspection->status;
  for (const spool::Part& part : (*design)->model.parts) {
    if (part.kind == spool::PartKind::kPipe)
      tried.largest_nps = std::max(tried.largest_nps, part.nps);
    tried.flanges += part.kind == spool::PartKind::kFlange ? 1 : 0;
  }
  for (const Dimension& dimension : inspection->dimensions)
    tried.dimensions.push_back(
        {dimension, truth_of(dimension, built, drawn, datum),
         dimension.answers < 0
             ? 0
             : (*design)->model.parts[static_cast<std::size_t>(dimension.answers)].nps});
  for (const PartFinding& part : inspection->parts)
    if (part.status == Verdict::kNotOk)
      tried.wrong_parts.push_back((*design)->model.parts[static_cast<std::size_t>(part.part)].name);
  return tried;
}

}  // namespace spool::campaign
