// An octree of bins over a cloud: split at their centre or at the mean of their points.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/scan/octree.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace spool {
namespace {

using Places = std::vector<std::uint32_t>;

// Divides the bins of one tree, the points' places sorted along.
class Divider {
 public:
  Divider(std::span<const Eigen::Vector3f> points, const OctreeOptions& options,
          std::vector<OctreeBin>& bins, Places& order)
      : points_(points), options_(options), bins_(bins), order_(order), sorted_(order.size()) {}

  [[nodiscard]] bool wants_division(const OctreeBin& bin) const {
    if (bin.point_count == 0 || bin.depth >= options_.max_depth) return false;
    const Eigen::AlignedBox3d box = extent(bin);
    Eigen::Index axis = 0;
    double longest = bin.bounds.sizes().maxCoeff(&axis);
    // Between neighbouring numbers there is no centre.
    const double centre = bin.bounds.center()[axis];
    if (centre <= bin.bounds.min()[axis] || centre >= bin.bounds.max()[axis]) return false;
    if (options_.size_of_points) longest = box.sizes().maxCoeff();
    if (longest < options_.min_size_m) return false;
    if (longest > options_.max_size_m) return true;
    return bin.point_count > options_.bin_capacity && !box.sizes().isZero(0.0);
  }

  void divide(std::size_t number) {
    OctreeBin& bin = bins_[number];
    const Eigen::Vector3d split = bin.split = split_of(bin);
    const auto begin = order_.begin() + bin.first_point;
    const auto end = begin + bin.point_count;
    std::array<std::uint32_t, 9> first{};  // of each child, then the end
    const auto child_of = [&](std::uint32_t place) {
      const Eigen::Vector3d p = points_[place].cast<double>();
      return (p.x() > split.x() ? 4U : 0U) + (p.y() > split.y() ? 2U : 0U) +
             (p.z() > split.z() ? 1U : 0U);
    };
    for (auto it = begin; it != end; ++it) ++first[child_of(*it) + 1];
    for (std::size_t c = 1; c < first.size(); ++c) first[c] += first[c - 1];
    std::array<std::uint32_t, 8> next{};
    std::copy_n(first.begin(), 8, next.begin());
    for (auto it = begin; it != end; ++it) sorted_[next[child_of(*it)]++] = *it;
    std::copy_n(sorted_.begin(), bin.point_count, begin);

    const OctreeBin parent = bin;  // the children move the bins
    bins_[number].first_child = static_cast<std::int32_t>(bins_.size());
    for (std::uint32_t c = 0; c < 8; ++c) {
      OctreeBin child;
      child.depth = parent.depth + 1;
      child.parent = static_cast<std::int32_t>(number);
      child.first_point = parent.first_point + first[c];
      child.point_count = first[c + 1] - first[c];
      for (Eigen::Index axis = 0; axis < 3; ++axis) {
        const bool upper = ((c >> (2 - static_cast<std::uint32_t>(axis))) & 1U) != 0;
        child.bounds.min()[axis] = upper ? split[axis] : parent.bounds.min()[axis];
        child.bounds.max()[axis] = upper ? parent.bounds.max()[axis] : split[axis];
      }
      bins_.push_back(child);
    }
  }

 private:
  [[nodiscard]] Eigen::AlignedBox3d extent(const OctreeBin& bin) const {
    Eigen::AlignedBox3d box;
    for (std::uint32_t i = 0; i < bin.point_count; ++i)
      box.extend(points_[order_[bin.first_point + i]].cast<double>());
    return box;
  }

  // Along an axis on which all points coincide the mean would cut nothing off, however often it is
  // taken: the centre does.
  [[nodiscard]] Eigen::Vector3d split_of(const OctreeBin& bin) const {
    const Eigen::Vector3d centre = bin.bounds.center();
    if (options_.split == OctreeSplit::kEqual) return centre;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::uint32_t i = 0; i < bin.point_count; ++i)
      sum += points_[order_[bin.first_point + i]].cast<double>();
    const Eigen::Vector3d mean = sum / bin.point_count;
    const Eigen::AlignedBox3d box = extent(bin);
    Eigen::Vector3d split;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      // Rounding may put the mean on the largest point or past it: nothing would be greater.
      const bool cuts = mean[axis] >= box.min()[axis] && mean[axis] < box.max()[axis];
      split[axis] = cuts ? mean[axis] : centre[axis];
    }
    return split;
  }

  std::span<const Eigen::Vector3f> points_;
  const OctreeOptions& options_;
  std::vector<OctreeBin>& bins_;
  Places& order_;
  Places sorted_;  // of the bin at hand
};

}  // namespace

Octree::Octree(std::span<const Eigen::Vector3f> points, const OctreeOptions& options,
               const Watch& watch)
    : point_bins_(points.size(), -1) {
  OctreeBin root;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!points[i].allFinite()) continue;
    point_order_.push_back(static_cast<std::uint32_t>(i));
    root.bounds.extend(points[i].cast<double>());
  }
  if (point_order_.empty()) return;
  root.point_count = static_cast<std::uint32_t>(point_order_.size());
  bins_.push_back(root);
  OctreeOptions settled = options;
  if (settled.bin_capacity == 0) settled.bin_capacity = (point_order_.size() + 9) / 10;
  Divider divider(points, settled, bins_, point_order_);
  // Children come after their parent, so one pass meets them all.
  for (std::size_t number = 0; number < bins_.size() && !watch.cancelled(); ++number)
    if (divider.wants_division(bins_[number])) divider.divide(number);
  for (std::size_t number = 0; number < bins_.size(); ++number) {
    OctreeBin& bin = bins_[number];
    if (!bin.is_leaf()) continue;
    for (std::uint32_t i = 0; i < bin.point_count; ++i) {
      const std::uint32_t place = point_order_[bin.first_point + i];
      point_bins_[place] = static_cast<std::int32_t>(number);
      bin.extent.extend(points[place].cast<double>());
    }
  }
}

void Octree::shrink() {
  // Children before their parents. The split planes stay: they say which child a place is next to.
  for (auto bin = bins_.rbegin(); bin != bins_.rend(); ++bin) {
    if (!bin->is_leaf()) {
      bin->extent.setEmpty();
      for (int c = 0; c < 8; ++c)
        bin->extent.extend(bins_[static_cast<std::size_t>(bin->first_child + c)].extent);
    }
    const Eigen::Vector3d corner = bin->bounds.min();
    bin->bounds = bin->point_count > 0 ? bin->extent : Eigen::AlignedBox3d(corner, corner);
  }
}

std::int32_t Octree::query(const Eigen::Vector3d& query, int depth) const {
  if (bins_.empty() || !query.allFinite() || !bins_[0].bounds.contains(query)) return -1;
  std::int32_t number = 0;
  while (true) {
    const OctreeBin& bin = bins_[static_cast<std::size_t>(number)];
    if (bin.is_leaf() || bin.depth >= depth) return number;
    const std::int32_t child = bin.first_child + (query.x() > bin.split.x() ? 4 : 0) +
                               (query.y() > bin.split.y() ? 2 : 0) +
                               (query.z() > bin.split.z() ? 1 : 0);
    if (!bins_[static_cast<std::size_t>(child)].bounds.contains(query)) return number;
    number = child;
  }
}

}  // namespace spool
