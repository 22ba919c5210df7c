// Triangles from loops of points: strips between loops of equal length, seams between any two.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/campaign/mesh_builder.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>

namespace spool::campaign {

using Eigen::Vector3d;

void MeshBuilder::in_frame(const Pose& T_mesh_frame, bool inward) {
  T_mesh_frame_ = T_mesh_frame;
  inward_ = inward;
}

void MeshBuilder::triangle(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  corners_.push_back(T_mesh_frame_ * a);
  corners_.push_back(T_mesh_frame_ * (inward_ ? c : b));
  corners_.push_back(T_mesh_frame_ * (inward_ ? b : c));
}

void MeshBuilder::quad(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& d) {
  triangle(a, b, c);
  triangle(a, c, d);
}

void MeshBuilder::strip(const Loop& lower, const Loop& upper) {
  assert(lower.size() == upper.size() && "loops of equal length");
  for (std::size_t i = 0; i < lower.size(); ++i) {
    const std::size_t j = (i + 1) % lower.size();
    quad(lower[i], lower[j], upper[j], upper[i]);
  }
}

void MeshBuilder::ring(const Loop& inner, const Loop& outer, const Vector3d& centre,
                       const Vector3d& up) {
  const Vector3d x = up.unitOrthogonal();
  const Vector3d y = up.cross(x);
  // Both loops as angles round the centre, merged: each step goes on along the loop that is behind.
  const auto by_angle = [&](const Loop& loop) {
    std::vector<std::pair<double, Vector3d>> sorted;
    for (const Vector3d& p : loop)
      sorted.emplace_back(std::atan2((p - centre).dot(y), (p - centre).dot(x)), p);
    std::sort(sorted.begin(), sorted.end(),
              [](const auto& a, const auto& b) { return a.first < b.first; });
    sorted.emplace_back(sorted.front().first + 2 * std::numbers::pi, sorted.front().second);
    return sorted;
  };
  const auto in = by_angle(inner);
  const auto out = by_angle(outer);
  for (std::size_t i = 0, o = 0; i + 1 < in.size() || o + 1 < out.size();) {
    const bool move_outer =
        i + 1 == in.size() || (o + 1 < out.size() && out[o + 1].first <= in[i + 1].first);
    if (move_outer) {
      triangle(in[i].second, out[o].second, out[o + 1].second);
      ++o;
    } else {
      triangle(in[i].second, out[o].second, in[i + 1].second);
      ++i;
    }
  }
}

TriangleMesh MeshBuilder::welded() const {
  TriangleMesh mesh;
  std::map<std::array<std::int64_t, 3>, std::uint32_t> known;
  const auto index = [&](const Vector3d& p) {
    // Round sizes must not lie on the edge of a cell, where rounding would part them.
    std::array<std::int64_t, 3> key;
    for (int i = 0; i < 3; ++i)
      key[static_cast<std::size_t>(i)] = std::llround(p[i] * 1e7 + 0.31731);
    const auto [place, is_new] = known.try_emplace(key, mesh.vertices.size());
    if (is_new) mesh.vertices.push_back(p.cast<float>());
    return place->second;
  };
  for (std::size_t i = 0; i < corners_.size(); i += 3) {
    const Triangle t = {index(corners_[i]), index(corners_[i + 1]), index(corners_[i + 2])};
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) mesh.triangles.push_back(t);
  }
  return mesh;
}

}  // namespace spool::campaign
