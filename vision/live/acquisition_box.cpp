// The acquisition box.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/live/acquisition_box.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "vision/core/parallel.h"

namespace spool {

namespace {

constexpr std::size_t kCandidates = 200, kVoters = 2000;
constexpr float kAlike = 0.985F;     // cosine, 10 degrees
constexpr double kLeastShare = 0.2;  // of the normals, for a plane to be what most of it shows
constexpr std::size_t kRows = 32;

// At most `limit` normals, spread evenly over the picture.
std::vector<Eigen::Vector3f> some_normals(const PointCloud& scan, std::size_t limit) {
  std::vector<Eigen::Vector3f> out;
  const std::size_t step = std::max<std::size_t>(1, scan.normals.size() / limit);
  for (std::size_t i = 0; i < scan.normals.size(); i += step)
    if (scan.normals[i].squaredNorm() > 0.5F) out.push_back(scan.normals[i]);  // zero: none
  return out;
}

// The direction that most of the surface faces; nothing where it faces everywhere.
std::optional<Eigen::Vector3d> dominant_normal(const PointCloud& scan) {
  const std::vector<Eigen::Vector3f> voters = some_normals(scan, kVoters);
  std::size_t most = 0;
  Eigen::Vector3f best = Eigen::Vector3f::Zero();
  for (const Eigen::Vector3f& candidate : some_normals(scan, kCandidates)) {
    std::size_t votes = 0;
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    for (const Eigen::Vector3f& normal : voters) {
      if (normal.dot(candidate) < kAlike) continue;
      ++votes;
      sum += normal;
    }
    if (votes <= most) continue;
    most = votes;
    best = sum;
  }
  if (static_cast<double>(most) < kLeastShare * static_cast<double>(voters.size()) || most == 0)
    return std::nullopt;
  return best.cast<double>().normalized();
}

// z along the plane's normal, y away from the camera along the plane.
Pose upright(const PointCloud& scan) {
  Pose T_box_camera = Pose::Identity();
  const std::optional<Eigen::Vector3d> up = dominant_normal(scan);
  if (!up) return T_box_camera;
  // Down on a plane that is faced, the picture's own up goes away from the camera.
  const Eigen::Vector3d forward = std::abs(up->z()) < 0.9
                                      ? Eigen::Vector3d::UnitZ()
                                      : Eigen::Vector3d(-Eigen::Vector3d::UnitY());
  const Eigen::Vector3d away = (forward - up->dot(forward) * *up).normalized();
  T_box_camera.linear().row(0) = away.cross(*up).transpose();
  T_box_camera.linear().row(1) = away.transpose();
  T_box_camera.linear().row(2) = up->transpose();
  return T_box_camera;
}

DepthFrame only_inside(const DepthFrame& frame, const AcquisitionBox& box, const Camera& camera) {
  DepthFrame inside = frame;
  const auto width = static_cast<std::size_t>(frame.width);
  const Eigen::Isometry3f T = box.T_box_scene.cast<float>();
  parallel_chunks(
      static_cast<std::size_t>(frame.height), kRows, [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v) {
          for (std::size_t u = 0; u < width; ++u) {
            std::uint16_t& count = inside.depth[v * width + u];
            const Eigen::Vector3d point = camera.back_project(
                static_cast<double>(u), static_cast<double>(v), count * camera.depth_unit_m);
            if (!box.bounds.contains(T * point.cast<float>())) count = 0;
          }
        }
      });
  return inside;
}

PointCloud only_inside(const PointCloud& scan, const AcquisitionBox& box) {
  PointCloud inside;
  inside.origin = scan.origin;
  for (std::size_t i = 0; i < scan.size(); ++i) {
    if (!box.contains(scan.points[i])) continue;
    inside.points.push_back(scan.points[i]);
    if (scan.has_normals()) inside.normals.push_back(scan.normals[i]);
    if (!scan.pixels.empty()) inside.pixels.push_back(scan.pixels[i]);
  }
  return inside;
}

}  // namespace

Eigen::AlignedBox3f box_about(const DesignModel& design, double margin_m) {
  const Eigen::AlignedBox3d bounds = design.bounds();
  return {(bounds.min().array() - margin_m).matrix().cast<float>(),
          (bounds.max().array() + margin_m).matrix().cast<float>()};
}

AcquisitionBox box_between(const Eigen::Vector3f& corner, const Eigen::Vector3f& opposite,
                           const PointCloud& scan, const DesignModel& design) {
  AcquisitionBox box;
  box.T_box_scene = upright(scan);
  const Eigen::Isometry3f T = box.T_box_scene.cast<float>();
  box.bounds.extend(T * corner);
  box.bounds.extend(T * opposite);
  const Eigen::Vector3f sizes = design.bounds().sizes().cast<float>();
  const float along = 0.5F * sizes.minCoeff();
  const Eigen::Vector3f margin(along, along, sizes.maxCoeff());
  box.bounds.min() -= margin;
  box.bounds.max() += margin;
  return box;
}

VisionStatePtr only_inside(const VisionState& state, const AcquisitionBox& box,
                           const Camera& camera, std::uint64_t revision) {
  auto inside = std::make_shared<VisionState>();
  inside->revision = revision;
  inside->alignment = state.alignment;
  inside->frame = std::make_shared<DepthFrame>(only_inside(*state.frame, box, camera));
  inside->scan = only_inside(state.scan, box);
  inside->stride_px = state.stride_px;
  inside->hint = state.hint;
  inside->camera = state.camera;
  inside->T_map_camera = state.T_map_camera;
  inside->camera_covariance = state.camera_covariance;
  inside->map = state.map;
  inside->T_design_camera = state.T_design_camera;
  return inside;
}

}  // namespace spool
