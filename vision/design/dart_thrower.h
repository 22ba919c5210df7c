// A set of points no two of which are closer than a radius, grown one dart at a time.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace spool {

// Takes a dart where no earlier one lies within `radius` (m, over 0). A hashed grid of cells of
// that edge: a dart looks at 27 cells.
class DartThrower {
 public:
  DartThrower(double radius, std::size_t expected);

  // True where the dart was taken.
  bool throw_dart(const Eigen::Vector3f& dart);

  [[nodiscard]] std::size_t size() const { return taken_.size(); }

 private:
  using Cell = Eigen::Array<std::int64_t, 3, 1>;
  [[nodiscard]] std::size_t slot(const Cell& cell) const;

  double radius_;  // m
  std::vector<Eigen::Vector3f> taken_;
  std::vector<std::uint32_t> heads_;  // hashed chains: the last dart of each slot,
  std::vector<std::uint32_t> next_;   // and the one before each dart
};

}  // namespace spool
