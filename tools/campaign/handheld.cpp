// What a structured-light camera makes of each pixel: jitter, shadow, losses, noise, disparity
// steps.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/campaign/handheld.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

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
  std::uint32_t placed = 0;
  Vector3d point = Vector3d::Zero();  // m, scan frame
};

struct Frame {
  const RayWorld& world;
  const HandheldSettings& settings;
  Pose T_scan_camera;
  std::uint32_t seed;
  int index;
  int columns, rows;  // of the pixels that are cast
  std::vector<Seen> seen = {};

  [[nodiscard]] Vector3d ray(double u, double v) const {
    return {(u - 0.5 * (settings.width - 1)) / settings.focal_px,
            (v - 0.5 * (settings.height - 1)) / settings.focal_px, 1};
  }
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
      const Vector3d camera_ray = ray(u + 0.8 * jitter_u.at(u, v), v + 0.8 * jitter_v.at(u, v));
      const double length = camera_ray.norm();
      const Vector3d direction = T_scan_camera.linear() * camera_ray / length;
      const auto hit =
          world.cast(T_scan_camera.translation(), direction, settings.farthest_m * length);
      Seen& pixel = seen[static_cast<std::size_t>(row * columns + column)];
      if (!hit || hit->distance / length < settings.nearest_m) continue;
      pixel.z = hit->distance / length;
      pixel.placed = hit->placed;
      pixel.point = T_scan_camera.translation() + hit->distance * direction;
      const double cosine = std::abs(world.normal(hit->placed, pixel.point).dot(direction));
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

  void measure(int row, std::vector<SensedPoint>& points) const {
    const CorrelatedNoise noise(seed, index * 4 + 2);
    const Vector3d projector = T_scan_camera * Vector3d(-settings.baseline_m, 0, 0);
    Random losing = random(row, 1);
    for (int column = 0; column < columns; ++column) {
      const Seen& pixel = seen[static_cast<std::size_t>(row * columns + column)];
      const double limit = (72.5 + 1.5 * losing.normal()) * kDegree;
      const bool edge_lost = losing.chance(0.6);
      if (pixel.z == 0 || pixel.incidence > limit || (edge_lost && at_edge(row, column))) continue;
      if (world.blocked(projector, pixel.point)) continue;
      const double u = column * settings.pixel_step;
      const double v = row * settings.pixel_step;
      // Quantisation is part of the published noise, so the rest is less.
      const double fb = settings.focal_px * settings.baseline_m;
      const double step = pixel.z * pixel.z / fb * settings.disparity_step_px;
      const double sigma = axial_noise(pixel.z, pixel.incidence);
      const double rest = std::sqrt(std::max(0.0, sigma * sigma - step * step / 12));
      const double z = pixel.z + rest * noise.at(u, v);
      const double steps = std::round(fb / z / settings.disparity_step_px);
      const Vector3d point =
          T_scan_camera * (ray(u, v) * (fb / (steps * settings.disparity_step_px)));
      const Placed& placed = world.placed()[pixel.placed];
      points.push_back(
          {point.cast<float>(), placed.label, placed.instance, static_cast<std::uint8_t>(index)});
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

std::vector<SensedPoint> scan_by_hand(const RayWorld& world, const HandheldSettings& settings,
                                      const std::vector<Pose>& T_scan_camera, std::uint32_t seed) {
  std::vector<SensedPoint> points;
  const int columns = (settings.width + settings.pixel_step - 1) / settings.pixel_step;
  const int rows = (settings.height + settings.pixel_step - 1) / settings.pixel_step;
  for (std::size_t i = 0; i < T_scan_camera.size(); ++i) {
    Frame frame{world, settings, T_scan_camera[i], seed, static_cast<int>(i), columns, rows};
    const auto count = static_cast<std::size_t>(rows);
    frame.seen.resize(static_cast<std::size_t>(columns) * count);
    parallel_chunks(count, 8, [&](std::size_t begin, std::size_t end) {
      for (std::size_t row = begin; row < end; ++row) frame.look(static_cast<int>(row));
    });
    std::vector<std::vector<SensedPoint>> measured(count);
    parallel_chunks(count, 8, [&](std::size_t begin, std::size_t end) {
      for (std::size_t row = begin; row < end; ++row)
        frame.measure(static_cast<int>(row), measured[row]);
    });
    for (const auto& row : measured) points.insert(points.end(), row.begin(), row.end());
  }
  return points;
}

}  // namespace spool::campaign
