// What a structured-light camera makes of each pixel: jitter, shadow, losses, noise, disparity
// steps.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/campaign/hand_camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "tools/campaign/correlated_noise.h"
#include "vision/core/parallel.h"

namespace spool::campaign {
namespace {

using Eigen::Vector3d;
constexpr double kDegree = std::numbers::pi / 180;

// What a pixel's ray hits.
struct Seen {
  double z = 0;          // m along the optical axis; 0: nothing within reach
  double incidence = 0;  // rad
  const Placed* placed = nullptr;
  Vector3d point = Vector3d::Zero();  // m, scan frame
};

struct Frame {
  const RayWorld& world;
  const RayWorld* moving;
  const HandheldSettings& settings;
  Pose T_scan_camera;
  std::uint32_t seed;
  int index;
  int columns, rows;  // of the pixels that are cast
  std::vector<Seen> seen = {};

  [[nodiscard]] Random random(int row, int purpose) const {
    return {seed, (static_cast<std::uint64_t>(index) << 32) +
                      static_cast<std::uint64_t>(purpose * 10'000 + row)};
  }

  // The lateral noise of Nguyen et al., 0.8 px, moves where a pixel looks; neighbours move alike.
  void look(int row) {
    const CorrelatedNoise jitter_u(seed, index * 4);
    const CorrelatedNoise jitter_v(seed, index * 4 + 1);
    for (int column = 0; column < columns; ++column) {
      const double u = column * settings.pixel_step;
      const double v = row * settings.pixel_step;
      const Vector3d camera_ray =
          settings.ray(u + 0.8 * jitter_u.at(u, v), v + 0.8 * jitter_v.at(u, v));
      const double length = camera_ray.norm();
      const Vector3d direction = T_scan_camera.linear() * camera_ray / length;
      const RayWorld* hit_world = &world;
      auto hit = world.cast(T_scan_camera.translation(), direction, settings.farthest_m * length);
      if (moving != nullptr) {
        const double far = hit ? hit->distance : settings.farthest_m * length;
        if (const auto nearer = moving->cast(T_scan_camera.translation(), direction, far)) {
          hit = nearer;
          hit_world = moving;
        }
      }
      Seen& pixel = seen[static_cast<std::size_t>(row * columns + column)];
      if (!hit || hit->distance / length < settings.nearest_m) continue;
      pixel.z = hit->distance / length;
      pixel.placed = &hit_world->placed()[hit->placed];
      pixel.point = T_scan_camera.translation() + hit->distance * direction;
      const double cosine = std::abs(hit_world->normal(hit->placed, pixel.point).dot(direction));
      pixel.incidence = std::acos(std::min(1.0, cosine));
    }
  }

  // Next to a step in depth the correlation window holds two surfaces, and often matches neither.
  [[nodiscard]] bool at_edge(int row, int column) const {
    const double z = seen[static_cast<std::size_t>(row * columns + column)].z;
    for (const auto& [r, c] : {std::pair(row - 1, column), std::pair(row + 1, column),
                               std::pair(row, column - 1), std::pair(row, column + 1)}) {
      if (r < 0 || r >= rows || c < 0 || c >= columns) continue;
      const double other = seen[static_cast<std::size_t>(r * columns + c)].z;
      if (other == 0 || std::abs(other - z) > 0.04 * z) return true;
    }
    return false;
  }

  void measure(int row, std::vector<Reading>& readings) const {
    const CorrelatedNoise noise(seed, index * 4 + 2);
    const Vector3d projector = T_scan_camera * Vector3d(-settings.baseline_m, 0, 0);
    Random losing = random(row, 1);
    for (int column = 0; column < columns; ++column) {
      const Seen& pixel = seen[static_cast<std::size_t>(row * columns + column)];
      const double limit = (72.5 + 1.5 * losing.normal()) * kDegree;
      const bool edge_lost = losing.chance(0.6);
      if (pixel.z == 0 || pixel.incidence > limit || (edge_lost && at_edge(row, column))) continue;
      if (world.blocked(projector, pixel.point)) continue;
      if (moving != nullptr && moving->blocked(projector, pixel.point)) continue;
      const double u = column * settings.pixel_step;
      const double v = row * settings.pixel_step;
      // Quantisation is part of the published noise, so the rest is less.
      const double fb = settings.focal_px * settings.baseline_m;
      const double step = pixel.z * pixel.z / fb * settings.disparity_step_px;
      const double sigma = axial_noise(pixel.z, pixel.incidence);
      const double rest = std::sqrt(std::max(0.0, sigma * sigma - step * step / 12));
      const double z = pixel.z + rest * noise.at(u, v);
      const double steps = std::round(fb / z / settings.disparity_step_px);
      readings[static_cast<std::size_t>(row * columns + column)] = {
          fb / (steps * settings.disparity_step_px), pixel.placed};
    }
  }
};

}  // namespace

double axial_noise(double z, double incidence) {
  const double theta = std::min(incidence, 80 * kDegree);
  const double grazing = theta / (std::numbers::pi / 2 - theta);
  return 0.0012 + 0.0019 * (z - 0.4) * (z - 0.4) +
         (theta > 60 * kDegree ? 0.0001 / std::sqrt(z) * grazing * grazing : 0);
}

Pose looking(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  Pose pose = Pose::Identity();
  pose.translation() = from;
  pose.linear().col(2) = (to - from).normalized();
  pose.linear().col(0) = pose.linear().col(2).cross(Eigen::Vector3d::UnitZ()).normalized();
  pose.linear().col(1) = pose.linear().col(2).cross(pose.linear().col(0));
  return pose;
}

std::vector<Reading> read_frame(const RayWorld& world, const RayWorld* moving,
                                const HandheldSettings& settings, const Pose& T_scan_camera,
                                std::uint32_t seed, int frame) {
  const int columns = settings.columns();
  const auto rows = static_cast<std::size_t>(settings.rows());
  Frame camera{world, moving, settings, T_scan_camera, seed, frame, columns, settings.rows()};
  camera.seen.resize(static_cast<std::size_t>(columns) * rows);
  parallel_chunks(rows, 8, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) camera.look(static_cast<int>(row));
  });
  std::vector<Reading> readings(camera.seen.size());
  parallel_chunks(rows, 8, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) camera.measure(static_cast<int>(row), readings);
  });
  return readings;
}

}  // namespace spool::campaign
