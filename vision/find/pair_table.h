// Pairs of design elements, looked up by what does not change when the design moves.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "vision/core/cancel.h"
#include "vision/core/pose.h"
#include "vision/find/elements.h"

namespace spool {

// Two elements seen from the line between them: the frame (columns: along the line, across it
// towards the first direction, their cross product) and the invariants of the pair.
struct PairFrame {
  Eigen::Matrix3f axes = Eigen::Matrix3f::Identity();
  Eigen::Vector3f middle = Eigen::Vector3f::Zero();  // m
  float distance = 0;                                // m
  float angle_a = 0, angle_b = 0;  // rad, each direction to the line, in [0, pi/2]
  float dihedral = 0;              // rad, from the first direction to the second about the line
};

// Nothing where a direction lies within 15 degrees of the line: it does not say how the pair is
// turned about it. Directions are taken with the sign that goes along the line.
[[nodiscard]] std::optional<PairFrame> pair_frame(const Element& a, const Element& b);

// The oriented pairs of the thesis (4.3.2) without its fixed distance: every distance from a fifth
// of the size up, hashed by distance, two angles and the dihedral angle (which, unlike the angle
// between the directions, tells a pair from its mirror image). Immutable; const queries from many
// threads.
class PairTable {
 public:
  PairTable() = default;
  // At most some thousands of elements: pairs grow with the square. `size_m`: the design's
  // diameter. Empty where it was cancelled.
  PairTable(std::vector<Element> elements, double size_m, const Watch& watch = {});

  [[nodiscard]] bool empty() const { return entries_.empty(); }
  [[nodiscard]] const std::vector<Element>& elements() const { return elements_; }
  [[nodiscard]] float least_distance() const { return least_; }
  [[nodiscard]] float most_distance() const { return most_; }
  // How many pairs look like `frame`.
  [[nodiscard]] std::size_t count(const PairFrame& frame) const;
  // The pose that lays the scene's pair on the nth of them; design from scene.
  [[nodiscard]] Eigen::Isometry3f pose(const PairFrame& frame, std::size_t nth) const;

 private:
  struct Entry {
    std::uint16_t a = 0, b = 0;
    std::uint8_t flip_a = 0, flip_b = 0;
  };
  [[nodiscard]] std::size_t bin(const PairFrame& frame) const;
  // The pair's bins: where a direction lies nearly across the line, noise may turn its sign, and
  // the pair stands under both.
  template <class Use>
  void each_way(std::size_t i, std::size_t j, const Use& use) const;

  std::vector<Element> elements_;
  float least_ = 0, most_ = 0, per_bin_ = 0;
  std::vector<std::uint32_t> first_;  // of each bin, and one past the last
  std::vector<Entry> entries_;
};

}  // namespace spool
