// What a frame says of one cell of the map: here, hidden, or gone.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/scan/map_reading.h"

#include <cmath>

namespace spool {
namespace {

constexpr float kSigmas = 3.0F;
constexpr float kNearest = 0.05F;  // m; nothing is measured nearer
constexpr float kGrazing = 0.26F;  // cos 75 deg: the sensor sees nothing beyond (ARCHITECTURE)
constexpr float kAlike = 0.7F;     // cosine between the normals of one surface, noise included

}  // namespace

MapReader::MapReader(const SeenFrame& frame, const ReadingNoise& noise, const Pose& T_map_camera)
    : frame_(frame),
      noise_(noise),
      R_map_camera_(T_map_camera.linear().cast<float>()),
      R_camera_map_(R_map_camera_.transpose()),
      t_map_camera_(T_map_camera.translation().cast<float>()),
      fx_(static_cast<float>(frame.camera.fx)),
      fy_(static_cast<float>(frame.camera.fy)),
      cx_(static_cast<float>(frame.camera.cx)),
      cy_(static_cast<float>(frame.camera.cy)) {}

bool MapReader::may_see(const Eigen::AlignedBox3f& box) const {
  const Eigen::Vector3f middle = R_camera_map_ * (box.center() - t_map_camera_);
  const float radius = 0.5F * box.diagonal().norm();
  if (middle.z() < -radius) return false;
  // The sides of the view as planes through the eye: n . middle > radius is outside.
  const auto outside = [&](float across, float focal, float low, float high) {
    const float left = (-low * middle.z() - focal * across) / std::hypot(low, focal);
    const float right = (focal * across - high * middle.z()) / std::hypot(high, focal);
    return left > radius || right > radius;
  };
  return !outside(middle.x(), fx_, cx_ + 0.5F, static_cast<float>(frame_.camera.width) - cx_) &&
         !outside(middle.y(), fy_, cy_ + 0.5F, static_cast<float>(frame_.camera.height) - cy_);
}

CellReading MapReader::read(const MapCell& cell) const {
  CellReading reading;
  const Eigen::Vector3f mean = R_camera_map_ * (cell.mean - t_map_camera_);
  if (!(mean.z() > kNearest)) return reading;
  const Eigen::Vector3f normal = R_camera_map_ * cell.normal;
  const float facing = -normal.dot(mean) / mean.norm();
  if (facing < kGrazing) return reading;
  reading.z = mean.z();
  reading.u = static_cast<int>(std::lround(fx_ * mean.x() / mean.z() + cx_));
  reading.v = static_cast<int>(std::lround(fy_ * mean.y() / mean.z() + cy_));
  const int width = frame_.camera.width;
  if (reading.u < 0 || reading.v < 0 || reading.u >= width || reading.v >= frame_.camera.height)
    return reading;
  const auto pixel = static_cast<std::size_t>(reading.v * width + reading.u);
  const Eigen::Vector3f point = frame_.cloud.points[pixel];
  if (!(point.z() > 0)) return reading;
  reading.residual = normal.dot(point - mean);
  reading.variance = noise_.variance(mean.z(), facing);
  const float gate = kSigmas * std::sqrt(reading.variance + cell.variance());
  if (reading.residual < -gate) {
    // Along the normal, so towards the back of the surface: farther than the cell.
    if (is_looked_through(reading, mean, normal, gate)) reading.sight = CellSight::kThrough;
    return reading;
  }
  if (reading.residual > gate) {
    reading.sight = CellSight::kHidden;
    return reading;
  }
  const Eigen::Vector3f seen_normal = frame_.cloud.normals[pixel];
  if (seen_normal.isZero() || seen_normal.dot(normal) < kAlike) return reading;
  reading.sight = CellSight::kAgrees;
  reading.point = R_map_camera_ * point + t_map_camera_;
  reading.normal = R_map_camera_ * seen_normal;
  return reading;
}

// Rims move by a pixel from frame to frame: the neighbours must have seen through as well.
bool MapReader::is_looked_through(const CellReading& reading, const Eigen::Vector3f& mean,
                                  const Eigen::Vector3f& normal, float gate) const {
  int behind = 0;
  for (int v = reading.v - 1; v <= reading.v + 1; ++v)
    for (int u = reading.u - 1; u <= reading.u + 1; ++u) {
      if (u < 0 || v < 0 || u >= frame_.camera.width || v >= frame_.camera.height) continue;
      const Eigen::Vector3f& point =
          frame_.cloud.points[static_cast<std::size_t>(v * frame_.camera.width + u)];
      if (!(point.z() > 0)) continue;
      if (normal.dot(point - mean) >= -gate) return false;
      ++behind;
    }
  return behind >= 5;  // most of the nine
}

}  // namespace spool
