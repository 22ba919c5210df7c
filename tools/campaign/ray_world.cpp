// Everything that stands in a scene, as patches in a tree of boxes that rays are cast through.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/campaign/ray_world.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace spool::campaign {
namespace {

using Eigen::Vector3d;
constexpr double kStart = 1e-5;  // m: a ray does not hit what it starts on

Eigen::AlignedBox3d box_of(const Placed& placed) {
  const Eigen::AlignedBox3d local = bounds(placed.patch);
  Eigen::AlignedBox3d box;
  for (int corner = 0; corner < 8; ++corner)
    box.extend(placed.T_scan_patch *
               local.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner)));
  // Flat patches get a thickness, so that rounding does not lose them.
  return {box.min() - Vector3d::Constant(1e-6), box.max() + Vector3d::Constant(1e-6)};
}

}  // namespace

RayWorld::RayWorld(std::vector<Placed> placed) : placed_(std::move(placed)) {
  for (const Placed& each : placed_) {
    boxes_.push_back(box_of(each));
    T_scan_patch_.emplace_back(each.T_scan_patch);
    T_patch_scan_.emplace_back(each.T_scan_patch.inverse());
  }
  order_.resize(placed_.size());
  std::iota(order_.begin(), order_.end(), 0U);
  if (!order_.empty()) build(0, static_cast<std::uint32_t>(order_.size()));
}

void RayWorld::build(std::uint32_t first, std::uint32_t count) {
  Eigen::AlignedBox3d whole, centres;
  for (std::uint32_t i = first; i < first + count; ++i) {
    whole.extend(boxes_[order_[i]]);
    centres.extend(boxes_[order_[i]].center());
  }
  const std::size_t self = nodes_.size();
  nodes_.push_back({whole.min(), whole.max(), first, count, 0});
  if (count <= 2) return;
  int axis = 0;
  centres.sizes().maxCoeff(&axis);
  const std::uint32_t half = count / 2;
  const auto begin = order_.begin() + first;
  std::nth_element(begin, begin + half, begin + count, [&](std::uint32_t a, std::uint32_t b) {
    return boxes_[a].center()[axis] < boxes_[b].center()[axis];
  });
  nodes_[self].count = 0;
  build(first, half);
  nodes_[self].right = static_cast<std::uint32_t>(nodes_.size());
  build(first + half, count - half);
}

template <bool Any>
std::optional<Hit> RayWorld::walk(const Vector3d& from, const Vector3d& direction,
                                  double far) const {
  std::optional<Hit> hit;
  if (nodes_.empty()) return hit;
  const Vector3d inverse = direction.cwiseInverse();
  std::array<std::uint32_t, 64> stack;
  std::size_t depth = 0;
  stack[depth++] = 0;
  while (depth > 0) {
    const std::uint32_t index = stack[--depth];
    const Node& node = nodes_[index];
    const Vector3d t0 = (node.low - from).cwiseProduct(inverse);
    const Vector3d t1 = (node.high - from).cwiseProduct(inverse);
    const double enter = t0.cwiseMin(t1).maxCoeff();
    const double leave = t0.cwiseMax(t1).minCoeff();
    if (enter > leave || leave < 0 || enter > far) continue;
    if (node.count == 0) {
      stack[depth++] = node.right;
      stack[depth++] = index + 1;
      continue;
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      const std::uint32_t place = order_[i];
      const Rigid& T = T_patch_scan_[place];
      const auto distance =
          first_hit(placed_[place].patch, T(from), T.turn * direction, kStart, far);
      if (!distance) continue;
      hit = Hit{*distance, place};
      if constexpr (Any) return hit;
      far = *distance;
    }
  }
  return hit;
}

std::optional<Hit> RayWorld::cast(const Vector3d& from, const Vector3d& direction,
                                  double far) const {
  return walk<false>(from, direction, far);
}

bool RayWorld::blocked(const Vector3d& from, const Vector3d& to) const {
  const double distance = (to - from).norm();
  return walk<true>(from, (to - from) / distance, distance - kStart).has_value();
}

Vector3d RayWorld::normal(std::uint32_t placed, const Vector3d& point) const {
  return T_scan_patch_[placed].turn *
         normal_at(placed_[placed].patch, T_patch_scan_[placed](point));
}

}  // namespace spool::campaign
