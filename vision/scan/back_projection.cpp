// Depth counts to metres: the one place where a depth image becomes points.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/scan/back_projection.h"

#include <cassert>
#include <cmath>
#include <limits>
#include <string>

#include "vision/core/parallel.h"

namespace spool {
namespace {

std::string size_text(int width, int height) {
  return std::to_string(width) + "x" + std::to_string(height);
}

}  // namespace

Result<PointCloud> back_project(const DepthFrame& frame, const Camera& camera) {
  if (!camera.is_valid())
    return Error{
        ErrorCode::kBadInput,
        "the camera's intrinsics are not usable (size, focal length and depth unit must be "
        "finite and positive); correct the camera's calibration"};
  if (!frame.is_consistent() || frame.width != camera.width || frame.height != camera.height)
    return Error{ErrorCode::kBadInput, "depth frame " + std::to_string(frame.index) + " is " +
                                           size_text(frame.width, frame.height) + " with " +
                                           std::to_string(frame.depth.size()) +
                                           " readings, but the camera is " +
                                           size_text(camera.width, camera.height) +
                                           "; use the intrinsics of this sensor and image size"};

  const auto width = static_cast<std::size_t>(frame.width);
  const auto height = static_cast<std::size_t>(frame.height);
  PointCloud cloud;
  cloud.width = frame.width;
  cloud.height = frame.height;
  cloud.points.resize(width * height);

  std::vector<double> x_per_z(width);
  for (std::size_t u = 0; u < width; ++u)
    x_per_z[u] = (static_cast<double>(u) - camera.cx) / camera.fx;

  const DepthWarp& warp = camera.calibration.warp;
  const bool is_bent = !warp.is_flat();
  assert((!is_bent || warp.most() < 1) && "depth stays in front of the camera");

  constexpr std::size_t kRows = 32;  // about 20 000 points a task
  constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
  parallel_chunks(height, kRows, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      const double y_per_z = (static_cast<double>(v) - camera.cy) / camera.fy;
      const auto bend = warp.row(picture_share(static_cast<double>(v), frame.height));
      const std::uint16_t* const counts = frame.depth.data() + v * width;
      Eigen::Vector3f* const points = cloud.points.data() + v * width;
      for (std::size_t u = 0; u < width; ++u) {
        double z = counts[u] * camera.depth_unit_m;
        if (is_bent) {
          const double x = picture_share(static_cast<double>(u), frame.width);
          z /= 1 + bend[0] + x * (bend[1] + x * (bend[2] + x * (bend[3] + x * bend[4])));
        }
        const bool seen = counts[u] != 0;
        points[u] = Eigen::Vector3f(seen ? static_cast<float>(x_per_z[u] * z) : kNone,
                                    seen ? static_cast<float>(y_per_z * z) : kNone,
                                    seen ? static_cast<float>(z) : kNone);
      }
    }
  });
  return cloud;
}

PointCloud measured_points(const PointCloud& organised) {
  PointCloud measured;
  measured.origin = organised.origin;
  const bool has_normals = organised.has_normals();
  const bool has_pixels = !organised.pixels.empty();
  measured.points.reserve(organised.size());
  measured.pixels.reserve(organised.size());
  if (has_normals) measured.normals.reserve(organised.size());
  for (std::size_t i = 0; i < organised.size(); ++i) {
    if (!organised.points[i].allFinite()) continue;
    measured.points.push_back(organised.points[i]);
    measured.pixels.push_back(has_pixels ? organised.pixels[i] : static_cast<std::uint32_t>(i));
    if (has_normals) measured.normals.push_back(organised.normals[i]);
  }
  return measured;
}

}  // namespace spool
