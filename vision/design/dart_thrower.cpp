// A set of points no two of which are closer than a radius, grown one dart at a time.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/design/dart_thrower.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <limits>

namespace spool {
namespace {
constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
}  // namespace

DartThrower::DartThrower(double radius, std::size_t expected)
    : radius_(radius), heads_(std::bit_ceil(std::max<std::size_t>(4 * expected, 64)), kNone) {
  assert(radius > 0 && "a radius over zero");
  taken_.reserve(expected);
  next_.reserve(expected);
}

std::size_t DartThrower::slot(const Cell& cell) const {
  const std::uint64_t hash = static_cast<std::uint64_t>(cell[0]) * 0x9E3779B97F4A7C15ULL +
                             static_cast<std::uint64_t>(cell[1]) * 0xC2B2AE3D27D4EB4FULL +
                             static_cast<std::uint64_t>(cell[2]) * 0x165667B19E3779F9ULL;
  return static_cast<std::size_t>(hash ^ (hash >> 32)) & (heads_.size() - 1);
}

bool DartThrower::throw_dart(const Eigen::Vector3f& dart) {
  const Cell cell = (dart.cast<double>().array() / radius_).floor().cast<std::int64_t>();
  for (std::int64_t x = -1; x <= 1; ++x) {
    for (std::int64_t y = -1; y <= 1; ++y) {
      for (std::int64_t z = -1; z <= 1; ++z) {
        for (std::uint32_t other = heads_[slot(cell + Cell(x, y, z))]; other != kNone;
             other = next_[other]) {
          if ((taken_[other] - dart).cast<double>().squaredNorm() < radius_ * radius_) return false;
        }
      }
    }
  }
  std::uint32_t& head = heads_[slot(cell)];
  next_.push_back(head);
  head = static_cast<std::uint32_t>(taken_.size());
  taken_.push_back(dart);
  return true;
}

}  // namespace spool
