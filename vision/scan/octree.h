// An octree of bins over a cloud: split at their centre or at the mean of their points.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "vision/core/cancel.h"
#include "vision/core/cloud_view.h"

namespace spool {

enum class OctreeSplit {
  kEqual,     // eight bins of equal size
  kWeighted,  // at the mean of the bin's points (thesis 4.3.1)
};

// A bin is divided where it holds more points than its capacity or an edge longer than max_size_m,
// unless it is too deep or its longest edge is under min_size_m. (Appendix B asks that of the
// shortest edge, and could not divide a flat cloud.) What holds no point is never divided, nor is a
// bin for its capacity whose points coincide.
// Sizes are those of the bin, or with `size_of_points` those of the box of its points: weighted
// splits cut slivers off, whose bins are long though what they hold is not.
struct OctreeOptions {
  OctreeSplit split = OctreeSplit::kWeighted;
  std::size_t bin_capacity = 0;  // points; 0: a tenth of the finite points, rounded up
  int max_depth = std::numeric_limits<int>::max();                   // of any bin; the root's is 0
  double max_size_m = std::numeric_limits<double>::infinity();       // m
  double min_size_m = 1e3 * std::numeric_limits<double>::epsilon();  // m
  bool size_of_points = false;
};

struct OctreeBin {
  Eigen::AlignedBox3d bounds;                       // m; closed
  Eigen::AlignedBox3d extent;                       // m; of a leaf's points
  Eigen::Vector3d split = Eigen::Vector3d::Zero();  // m; greater goes to the upper child
  int depth = 0;
  std::int32_t parent = -1;       // -1: the root
  std::int32_t first_child = -1;  // eight in a row, x slowest, the lower side first; -1: a leaf
  std::uint32_t first_point = 0;  // its points in Octree::point_order()
  std::uint32_t point_count = 0;

  [[nodiscard]] bool is_leaf() const { return first_child < 0; }
};

// Immutable but for shrink(); const queries from many threads. Same input, same tree.
class Octree {
 public:
  Octree() = default;
  // Divides over the finite points (m). Looks at `watch`; a cancelled tree is whole as far as it
  // was divided.
  explicit Octree(std::span<const Eigen::Vector3f> points, const OctreeOptions& options = {},
                  const Watch& watch = {});

  // Parents before their children; empty without a finite point.
  [[nodiscard]] const std::vector<OctreeBin>& bins() const { return bins_; }
  // The leaf of each input point, -1 where it is not finite.
  [[nodiscard]] const std::vector<std::int32_t>& point_bins() const { return point_bins_; }
  // The finite points' places in the input, sorted by leaf.
  [[nodiscard]] const std::vector<std::uint32_t>& point_order() const { return point_order_; }

  // Makes every bin as small as its points allow, a bin without points a point of itself. Space
  // between the bins then belongs to the deepest bin round it.
  void shrink();

  // The deepest bin of at most `depth` that holds `query` (m), -1 outside the root or where it is
  // not finite. For an input point and no bound on depth: its leaf, before and after shrink().
  [[nodiscard]] std::int32_t query(const Eigen::Vector3d& query,
                                   int depth = std::numeric_limits<int>::max()) const;

 private:
  std::vector<OctreeBin> bins_;
  std::vector<std::int32_t> point_bins_;
  std::vector<std::uint32_t> point_order_;
};

}  // namespace spool
