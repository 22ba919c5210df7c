// The surface that a sensor outside can see, found by casting rays from every triangle.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/design/exterior.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "vision/core/parallel.h"

namespace spool {
namespace {

constexpr std::size_t kFrontRays = 16;
constexpr std::size_t kBackRays =
    4;  // a sheet wound the wrong way is still seen; inside a wall all rays end

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

template <std::size_t N>
bool escapes(const DesignSurface& surface, const Eigen::Vector3f& from,
             const Eigen::Vector3f& normal, const std::array<Eigen::Vector3f, N>& directions,
             float far) {
  const Eigen::Matrix3f turn =
      Eigen::Quaternionf::FromTwoVectors(Eigen::Vector3f::UnitZ(), normal).toRotationMatrix();
  return std::any_of(directions.begin(), directions.end(), [&](const Eigen::Vector3f& d) {
    return !surface.cast(from, (turn * d).normalized(), far);
  });
}

}  // namespace

DesignModel exterior_of(const DesignModel& design, const DesignSurface& surface) {
  if (design.is_cloud()) return design;
  const auto size = static_cast<float>(design.bounds().diagonal().norm());
  const float lift = 1e-5F * size;  // off the triangle itself, far under any wall
  static const auto front = cosine_directions<kFrontRays>();
  static const auto back = cosine_directions<kBackRays>();
  constexpr std::array<std::array<float, 3>, 4> kPlaces{
      {{0.34F, 0.33F, 0.33F}, {0.8F, 0.1F, 0.1F}, {0.1F, 0.8F, 0.1F}, {0.1F, 0.1F, 0.8F}}};
  const auto& triangles = design.mesh.triangles;
  std::vector<std::uint8_t> seen(triangles.size(), 0);
  parallel_chunks(triangles.size(), 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      const Eigen::Vector3f& a = design.mesh.vertices[triangles[t][0]];
      const Eigen::Vector3f& b = design.mesh.vertices[triangles[t][1]];
      const Eigen::Vector3f& c = design.mesh.vertices[triangles[t][2]];
      const Eigen::Vector3f cross = (b - a).cross(c - a);
      if (!(cross.norm() > 0)) continue;
      const Eigen::Vector3f normal = cross.normalized();
      for (const auto& w : kPlaces) {
        const Eigen::Vector3f p = w[0] * a + w[1] * b + w[2] * c;
        if (!escapes(surface, p + lift * normal, normal, front, size) &&
            !escapes(surface, p - lift * normal, -normal, back, size))
          continue;
        seen[t] = 1;
        break;
      }
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

}  // namespace spool
