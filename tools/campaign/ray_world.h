// Everything that stands in a scene, as patches in a tree of boxes that rays are cast through.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "tools/campaign/patch.h"

namespace spool::campaign {

// A patch where it stands, and whose it is.
struct Placed {
  Patch patch;  // T_part_patch is not used
  Pose T_scan_patch = Pose::Identity();
  std::uint16_t label = 0;    // of a scene's labels
  std::uint8_t instance = 0;  // which copy of the object; kNoInstance: clutter
};
inline constexpr std::uint8_t kNoInstance = 255;

// A pose as rays use it: Eigen keeps a pose as 4x4, which products do not vectorise.
struct Rigid {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();  // m
  explicit Rigid(const Pose& pose) : turn(pose.linear()), shift(pose.translation()) {}
  [[nodiscard]] Eigen::Vector3d operator()(const Eigen::Vector3d& p) const {
    return turn * p + shift;
  }
};

struct Hit {
  double distance = 0;  // m
  std::uint32_t placed = 0;
};

// Immutable once built; const from many threads.
class RayWorld {
 public:
  explicit RayWorld(std::vector<Placed> placed);

  [[nodiscard]] const std::vector<Placed>& placed() const { return placed_; }
  // The first hit along the unit direction, nearer than `far` (m). Scan frame.
  [[nodiscard]] std::optional<Hit> cast(const Eigen::Vector3d& from,
                                        const Eigen::Vector3d& direction, double far) const;
  // Whether anything stands between the two points, the last 10 micrometres at either end left out.
  [[nodiscard]] bool blocked(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const;
  [[nodiscard]] const Rigid& T_scan_patch(std::uint32_t placed) const {
    return T_scan_patch_[placed];
  }
  // A box round the patch, scan frame (m).
  [[nodiscard]] const Eigen::AlignedBox3d& box(std::uint32_t placed) const {
    return boxes_[placed];
  }
  [[nodiscard]] Eigen::Vector3d normal(std::uint32_t placed, const Eigen::Vector3d& point) const;

 private:
  struct Node {
    Eigen::Vector3d low, high;
    std::uint32_t first = 0, count = 0;  // patches of a leaf, by order_
    std::uint32_t right = 0;             // the left child follows its parent
  };
  void build(std::uint32_t first, std::uint32_t count);
  template <bool Any>
  [[nodiscard]] std::optional<Hit> walk(const Eigen::Vector3d& from,
                                        const Eigen::Vector3d& direction, double far) const;

  std::vector<Placed> placed_;
  std::vector<Rigid> T_scan_patch_, T_patch_scan_;
  std::vector<Eigen::AlignedBox3d> boxes_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace spool::campaign
