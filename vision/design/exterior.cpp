// The surface that a sensor outside can see, found by casting rays from every triangle.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/design/exterior.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

#include <Eigen/Geometry>

#include "vision/core/parallel.h"

namespace spool {
namespace {

constexpr std::size_t kFrontRays = 16;
constexpr std::size_t kBackRays =
    4;  // a sheet wound the wrong way is still seen; inside a wall all rays end

template <std::size_t N>
constexpr std::size_t kAway = (N + 5) / 6;  // a sixth of the view: a bore shows some radii deep
constexpr float kSmall = 0.02F;             // of the design's size: seen as a whole or not at all
constexpr int kSeenPlaces =
    3;  // of 16; a strip of a long bore shows its first tenth at an open end

// Directions about z with the density of the cosine: what sensors see at a grazing angle they lose.
template <std::size_t N>
std::array<Eigen::Vector3f, N> cosine_directions() {
  std::array<Eigen::Vector3f, N> directions;
  for (std::size_t i = 0; i < N; ++i) {
    const double u = (static_cast<double>(i) + 0.5) / N;
    const double angle =
        static_cast<double>(i) * std::numbers::pi * (3 - std::sqrt(5.0));  // golden angle
    directions[i] = Eigen::Vector3d(std::sqrt(u) * std::cos(angle), std::sqrt(u) * std::sin(angle),
                                    std::sqrt(1 - u))
                        .cast<float>();
  }
  return directions;
}

// Whether some ray from the point gets away, on either side of the surface.
class Outlook {
 public:
  Outlook(const DesignSurface& surface, float size) : surface_(surface), size_(size) {}

  [[nodiscard]] bool is_seen(const Eigen::Vector3f& p, const Eigen::Vector3f& normal) const {
    const float lift = 1e-5F * size_;  // off the surface itself, far under any wall
    return escapes(p + lift * normal, normal, front_) || escapes(p - lift * normal, -normal, back_);
  }

 private:
  template <std::size_t N>
  bool escapes(const Eigen::Vector3f& from, const Eigen::Vector3f& normal,
               const std::array<Eigen::Vector3f, N>& directions) const {
    const Eigen::Matrix3f turn =
        Eigen::Quaternionf::FromTwoVectors(Eigen::Vector3f::UnitZ(), normal).toRotationMatrix();
    std::size_t away = 0;
    for (const Eigen::Vector3f& d : directions)
      if (!surface_.cast(from, (turn * d).normalized(), size_) && ++away >= kAway<N>) return true;
    return false;
  }

  const DesignSurface& surface_;
  float size_;
  std::array<Eigen::Vector3f, kFrontRays> front_ = cosine_directions<kFrontRays>();
  std::array<Eigen::Vector3f, kBackRays> back_ = cosine_directions<kBackRays>();
};

// The middles of the 16 like triangles that one falls into, as weights of its corners.
std::array<Eigen::Vector3f, 16> sixteenths() {
  std::array<Eigen::Vector3f, 16> places;
  std::size_t n = 0;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; i + j < 4; ++j)
      for (const int up : {1, 2}) {
        if (up == 2 && i + j > 2) continue;
        const float a = (static_cast<float>(i) + static_cast<float>(up) / 3.0F) / 4.0F;
        const float b = (static_cast<float>(j) + static_cast<float>(up) / 3.0F) / 4.0F;
        places[n++] = {a, b, 1 - a - b};
      }
  return places;
}

}  // namespace

DesignModel exterior_of(const DesignModel& design, const DesignSurface& surface) {
  if (design.is_cloud()) return design;
  const auto size = static_cast<float>(design.bounds().diagonal().norm());
  const Outlook outlook(surface, size);
  const std::array<Eigen::Vector3f, 16> places = sixteenths();
  const auto& triangles = design.mesh.triangles;
  std::vector<std::uint8_t> seen(triangles.size(), 0);
  parallel_chunks(triangles.size(), 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      Eigen::Matrix3f corners;
      for (Eigen::Index i = 0; i < 3; ++i)
        corners.col(i) = design.mesh.vertices[triangles[t][static_cast<std::size_t>(i)]];
      const Eigen::Vector3f ab = corners.col(1) - corners.col(0);
      const Eigen::Vector3f ac = corners.col(2) - corners.col(0);
      const Eigen::Vector3f normal = ab.cross(ac).normalized();
      if (!normal.allFinite() || normal.isZero()) continue;
      const float longest = std::max({ab.norm(), ac.norm(), (ab - ac).norm()});
      if (longest < kSmall * size) {
        seen[t] = outlook.is_seen(corners.rowwise().mean(), normal) ? 1 : 0;
        continue;
      }
      int count = 0;
      for (const Eigen::Vector3f& weights : places)
        if (count < kSeenPlaces && outlook.is_seen(corners * weights, normal)) ++count;
      seen[t] = count >= kSeenPlaces ? 1 : 0;
    }
  });
  if (std::none_of(seen.begin(), seen.end(), [](std::uint8_t s) { return s != 0; })) return design;

  DesignModel exterior = design;
  exterior.mesh.triangles.clear();
  exterior.triangle_part.clear();
  for (Part& part : exterior.parts) {
    const std::uint32_t first = part.first_triangle;
    const std::uint32_t last = first + part.triangle_count;
    part.first_triangle = static_cast<std::uint32_t>(exterior.mesh.triangles.size());
    for (std::uint32_t t = first; t < last; ++t) {
      if (seen[t] == 0) continue;
      exterior.mesh.triangles.push_back(triangles[t]);
      exterior.triangle_part.push_back(design.triangle_part[t]);
    }
    part.triangle_count =
        static_cast<std::uint32_t>(exterior.mesh.triangles.size()) - part.first_triangle;
  }
  return exterior;
}

SurfaceSamples seen_samples(const SurfaceSamples& samples, const DesignModel& design,
                            const DesignSurface& surface) {
  if (design.is_cloud()) return samples;
  const Outlook outlook(surface, static_cast<float>(design.bounds().diagonal().norm()));
  std::vector<std::uint8_t> seen(samples.part.size(), 0);
  parallel_chunks(seen.size(), 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      seen[i] = outlook.is_seen(samples.cloud.points[i], samples.cloud.normals[i]) ? 1 : 0;
  });
  if (std::none_of(seen.begin(), seen.end(), [](std::uint8_t s) { return s != 0; })) return samples;
  SurfaceSamples some;
  some.radius_m = samples.radius_m;
  some.cloud.origin = samples.cloud.origin;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (seen[i] == 0) continue;
    some.cloud.points.push_back(samples.cloud.points[i]);
    some.cloud.normals.push_back(samples.cloud.normals[i]);
    some.part.push_back(samples.part[i]);
  }
  return some;
}

}  // namespace spool
