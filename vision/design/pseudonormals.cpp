// Normals that give the right sign of distance everywhere on a mesh: sums over welded edges and
// corners.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/design/pseudonormals.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <utility>

#include <Eigen/Geometry>

#include "vision/design/vertex_welding.h"

namespace spool {
namespace {

// One of the three edges of a triangle, by its welded ends.
struct HalfEdge {
  std::uint64_t key = 0;  // smaller end above, larger below
  std::uint32_t triangle = 0;
  std::uint32_t side = 0;  // 0 ab, 1 bc, 2 ca
};

Eigen::Vector3f unit_or_zero(const Eigen::Vector3d& v) {
  const double length = v.norm();
  if (!(length > 1e-9)) return Eigen::Vector3f::Zero();
  return (v / length).cast<float>();
}

// Welded corners of every triangle: vertices of different parts stay apart.
std::vector<Triangle> weld_by_part(const TriangleMesh& mesh, std::span<const std::int32_t> part,
                                   std::size_t& corner_count) {
  const float tolerance = welding_tolerance(mesh.vertices);
  const std::vector<std::uint32_t> welded = weld_vertices(mesh.vertices, tolerance);
  std::vector<Triangle> corners(mesh.triangles.size());
  std::map<std::pair<std::int32_t, std::uint32_t>, std::uint32_t> shared;
  // A vertex mostly belongs to the part that used it first; only the others need the map.
  std::vector<std::int32_t> owner(mesh.vertices.size(), -2);
  corner_count = mesh.vertices.size();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t vertex = welded[mesh.triangles[t][k]];
      if (owner[vertex] == -2) owner[vertex] = part[t];
      if (owner[vertex] == part[t]) {
        corners[t][k] = vertex;
        continue;
      }
      const auto [entry, is_new] =
          shared.try_emplace({part[t], vertex}, static_cast<std::uint32_t>(corner_count));
      if (is_new) ++corner_count;
      corners[t][k] = entry->second;
    }
  }
  return corners;
}

std::vector<HalfEdge> sorted_edges(const std::vector<Triangle>& corners) {
  std::vector<HalfEdge> edges;
  edges.reserve(corners.size() * 3);
  for (std::uint32_t t = 0; t < corners.size(); ++t) {
    for (std::uint32_t side = 0; side < 3; ++side) {
      const auto [low, high] = std::minmax(corners[t][side], corners[t][(side + 1) % 3]);
      edges.push_back({(std::uint64_t{low} << 32U) | high, t, side});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const HalfEdge& a, const HalfEdge& b) {
    return std::pair(a.key, a.triangle) < std::pair(b.key, b.triangle);
  });
  return edges;
}

}  // namespace

std::vector<TriangleNormals> pseudonormals(const TriangleMesh& mesh,
                                           std::span<const std::int32_t> part) {
  assert(part.size() == mesh.triangles.size() && "a part for every triangle");
  std::size_t corner_count = 0;
  const std::vector<Triangle> corners = weld_by_part(mesh, part, corner_count);
  std::vector<TriangleNormals> normals(corners.size());
  std::vector<Eigen::Vector3d> corner_sum(corner_count, Eigen::Vector3d::Zero());
  for (std::size_t t = 0; t < corners.size(); ++t) {
    std::array<Eigen::Vector3d, 3> p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = mesh.vertices[mesh.triangles[t][k]].cast<double>();
    const Eigen::Vector3d cross = (p[1] - p[0]).cross(p[2] - p[0]);
    const double length = cross.norm();
    normals[t].fill(Eigen::Vector3f::Zero());
    if (!(length > 0)) continue;
    const Eigen::Vector3d normal = cross / length;
    normals[t][0] = normal.cast<float>();
    for (std::size_t k = 0; k < 3; ++k) {
      const Eigen::Vector3d to_next = p[(k + 1) % 3] - p[k];
      const Eigen::Vector3d to_last = p[(k + 2) % 3] - p[k];
      corner_sum[corners[t][k]] +=
          std::atan2(to_next.cross(to_last).norm(), to_next.dot(to_last)) * normal;
    }
  }
  const std::vector<HalfEdge> edges = sorted_edges(corners);
  for (std::size_t begin = 0; begin < edges.size();) {
    std::size_t end = begin;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (; end < edges.size() && edges[end].key == edges[begin].key; ++end) {
      sum += normals[edges[end].triangle][0].cast<double>();
    }
    for (std::size_t e = begin; e < end; ++e) {
      TriangleNormals& own = normals[edges[e].triangle];
      const Eigen::Vector3f normal = unit_or_zero(sum);
      own[1 + edges[e].side] = normal.isZero() ? own[0] : normal;  // two sides of a sheet cancel
    }
    begin = end;
  }
  for (std::size_t t = 0; t < corners.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Eigen::Vector3f normal = unit_or_zero(corner_sum[corners[t][k]]);
      normals[t][4 + k] = normal.isZero() ? normals[t][0] : normal;
    }
  }
  return normals;
}

}  // namespace spool
