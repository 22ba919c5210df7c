// Is the design where the frame says it is.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/live/surface_agreement.h"

#include <algorithm>
#include <cmath>

namespace spool {

namespace {
// Flatter than this to the line of sight (cosine), an edge of a pixel decides what is measured.
constexpr double kMinFacing = 0.3;
constexpr std::size_t kSamples = 1500;
constexpr double kLift = 1e-3;  // m off the surface that a sample itself lies on
}  // namespace

SurfaceAgreement surface_agreement(const SurfaceSamples& samples, const DesignSurface& surface,
                                   const DepthFrame& frame, const Camera& camera,
                                   const Pose& T_design_camera, double gate_m,
                                   std::span<const std::uint8_t> counts) {
  SurfaceAgreement count;
  const Pose T_camera_design = T_design_camera.inverse();
  const bool have_normals = samples.cloud.has_normals();
  const std::size_t step = std::max<std::size_t>(1, samples.cloud.size() / kSamples);
  for (std::size_t i = 0; i < samples.cloud.size(); i += step) {
    if (!counts.empty() && counts[static_cast<std::size_t>(samples.part[i])] == 0) continue;
    const Eigen::Vector3d p_camera = T_camera_design * samples.cloud.points[i].cast<double>();
    if (p_camera.z() <= 0.0) continue;
    if (have_normals) {
      const Eigen::Vector3d n = T_camera_design.linear() * samples.cloud.normals[i].cast<double>();
      if (-n.dot(p_camera.normalized()) < kMinFacing) continue;
    }
    const Eigen::Vector2d pixel = camera.project(p_camera);
    const auto u = std::lround(pixel.x());
    const auto v = std::lround(pixel.y());
    if (u < 0 || v < 0 || u >= frame.width || v >= frame.height) continue;
    const Eigen::Vector3d to_eye =
        (T_design_camera.translation() - samples.cloud.points[i].cast<double>());
    const Eigen::Vector3d direction = to_eye.normalized();
    const Eigen::Vector3d from = samples.cloud.points[i].cast<double>() + kLift * direction;
    if (surface.cast(from.cast<float>(), direction.cast<float>(),
                     static_cast<float>(to_eye.norm()))) {
      continue;  // the design hides itself
    }
    const std::uint16_t depth =
        frame.depth[static_cast<std::size_t>(v) * static_cast<std::size_t>(frame.width) +
                    static_cast<std::size_t>(u)];
    if (depth == 0) {
      ++count.unmeasured;
      continue;
    }
    const double behind = depth * camera.depth_unit_m - p_camera.z();
    if (behind > gate_m) {
      ++count.seen_through;
    } else if (behind < -gate_m) {
      ++count.hidden;
    } else {
      ++count.seen;
    }
  }
  return count;
}

}  // namespace spool
