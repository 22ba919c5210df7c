// Nearest neighbours: nanoflann behind a type of ours. Metres in, metres out.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "vision/core/cancel.h"

namespace spool {

struct Neighbour {
  std::uint32_t index = 0;  // into the indexed points
  float distance = 0;       // m
};

// A k-d tree over borrowed points, which must outlive it. Points that are not finite are left out.
// Queries are const and may run on many threads. Every search is bounded by `max_distance` (m): far
// queries are a k-d tree's trap (some thirty times slower).
class PointIndex {
 public:
  PointIndex();
  // Cancelled while it is built, it is empty.
  explicit PointIndex(std::span<const Eigen::Vector3f> points, const Watch& watch = {});
  PointIndex(PointIndex&&) noexcept;
  PointIndex& operator=(PointIndex&&) noexcept;
  ~PointIndex();

  [[nodiscard]] std::size_t size() const;  // finite points indexed
  [[nodiscard]] std::optional<Neighbour> nearest(const Eigen::Vector3f& query,
                                                 float max_distance) const;
  // Whether there is one; ends at the first that is met.
  [[nodiscard]] bool is_within(const Eigen::Vector3f& query, float max_distance) const;
  // Up to k neighbours, nearest first, appended to nothing: `out` is cleared (its memory is
  // reused).
  void nearest_k(const Eigen::Vector3f& query, std::size_t k, float max_distance,
                 std::vector<Neighbour>& out) const;
  // All neighbours within `radius`, in no order.
  void within(const Eigen::Vector3f& query, float radius, std::vector<Neighbour>& out) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace spool
