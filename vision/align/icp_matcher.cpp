// Correspondences of ICP: searched once, then mostly remembered.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/align/icp_matcher.h"

#include <algorithm>
#include <cmath>

#include "vision/core/parallel.h"
#include "vision/scan/spatial_order.h"

namespace spool {
namespace {

constexpr std::size_t kGrain = 2048;
constexpr std::size_t kMostMemories = std::size_t{1} << 20U;  // 64 MiB

}  // namespace

Indices near_points(const CloudView& scan, const DesignSurface& surface, const Pose& T, float reach,
                    const Watch& watch) {
  std::vector<std::uint8_t> near(scan.size(), 0);
  const Eigen::Isometry3f T_f = T.cast<float>();
  parallel_chunks(scan.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    if (watch.cancelled()) return;
    for (std::size_t i = begin; i < end; ++i)
      if (scan.points[i].allFinite()) near[i] = surface.is_within(T_f * scan.points[i], reach);
  });
  Indices indices;
  for (std::size_t i = 0; i < scan.size(); ++i)
    if (near[i]) indices.push_back(static_cast<std::uint32_t>(i));
  put_in_spatial_order(scan.points, indices, watch);
  return indices;
}

Indices strewn(const Indices& all, std::size_t count) {
  if (all.size() <= count) return all;
  Indices some;
  const auto limit = static_cast<std::uint32_t>(4294967295.0 * static_cast<double>(count) /
                                                static_cast<double>(all.size()));
  for (const std::uint32_t i : all) {
    std::uint32_t h = i * 2654435761u;  // Knuth's multiplicative hash, then a mix
    h ^= h >> 16;
    h *= 2246822519u;
    h ^= h >> 13;
    if (h <= limit) some.push_back(i);
  }
  return some;
}

void Matcher::choose(const Indices& indices, bool coarsely) {
  coarsely_ = coarsely;
  const auto copy = [&](std::span<const Eigen::Vector3f> from, std::vector<Eigen::Vector3f>& to) {
    to.resize(from.empty() ? 0 : indices.size());
    for (std::size_t k = 0; k < to.size(); ++k) to[k] = from[indices[k]];
  };
  copy(scan_.points, points_);
  copy(scan_.normals, normals_);
  memories_.clear();
  if (!coarsely && indices.size() <= kMostMemories) memories_.resize(indices.size());
}

void Matcher::match(const Pose& T, double gate, double margin, const Watch& watch,
                    std::vector<Correspondence>& matches) {
  matches.resize(points_.size());
  const Eigen::Isometry3f T_f = T.cast<float>();
  const auto cosine = static_cast<float>(std::cos(options_.max_normal_angle_rad));
  // Past an edge the closest point stops moving along the surface: it says nothing about the
  // plane.
  const auto off_edge = static_cast<float>(std::max(3 * options_.noise_m, 0.25 * gate));
  const auto gate_f = static_cast<float>(gate);
  const auto margin_f = static_cast<float>(2 * margin);
  const bool remember = margin > 0 && !memories_.empty();
  parallel_chunks(points_.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    if (watch.cancelled()) return;
    for (std::size_t k = begin; k < end; ++k) {
      matches[k] = {};
      const Eigen::Vector3f p = T_f * points_[k];
      const auto hit = remember    ? surface_.closest(p, gate_f, margin_f, memories_[k])
                       : coarsely_ ? surface_.closest_tangent(p, gate_f)
                                   : surface_.closest(p, gate_f);
      if (!hit || hit->normal.squaredNorm() < 0.5F) continue;
      const Eigen::Vector3f offset = p - hit->point;
      const float residual = hit->normal.dot(offset);
      if (offset.squaredNorm() - residual * residual > off_edge * off_edge) continue;
      if (!normals_.empty()) {
        const Eigen::Vector3f& n = normals_[k];
        const float facing = hit->normal.dot(T_f.linear() * n);
        const bool known = n.squaredNorm() > 0.5F;
        if (known && (options_.oriented_normals ? facing : std::abs(facing)) < cosine) continue;
      }
      matches[k] = {p, hit->normal, residual, 1.0F};
    }
  });
}

}  // namespace spool
