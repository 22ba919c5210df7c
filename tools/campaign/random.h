// Random numbers that depend on a seed and nothing else: the same on any machine and thread.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include <Eigen/Core>

namespace spool::campaign {

// SplitMix64 (Steele, Lea & Flood 2014). The standard library's distributions differ between
// libraries; these do not.
class Random {
 public:
  // Streams of one seed are independent of each other: one for each purpose or index.
  Random(std::uint64_t seed, std::uint64_t stream)
      : state_(mixed(seed * 0x9E3779B97F4A7C15U + mixed(stream + 0x632BE59BD9B4E019U))) {}

  std::uint64_t bits() {
    state_ += 0x9E3779B97F4A7C15U;
    return mixed(state_);
  }
  // In [0, 1).
  double uniform() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  // In [0, count).
  int below(int count) { return static_cast<int>(uniform() * count); }
  bool chance(double probability) { return uniform() < probability; }
  // Mean 0, standard deviation 1 (Box & Muller 1958).
  double normal() {
    const double radius = std::sqrt(-2 * std::log(1 - uniform()));
    return radius * std::cos(2 * std::numbers::pi * uniform());
  }
  Eigen::Vector3d normals() {
    const double x = normal();
    const double y = normal();
    return {x, y, normal()};
  }
  // Unit, all directions alike.
  Eigen::Vector3d direction() {
    const double z = uniform(-1, 1);
    const double angle = uniform(0, 2 * std::numbers::pi);
    const double radius = std::sqrt(1 - z * z);
    return {radius * std::cos(angle), radius * std::sin(angle), z};
  }

 private:
  static std::uint64_t mixed(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBU;
    return z ^ (z >> 31);
  }

  std::uint64_t state_;
};

}  // namespace spool::campaign
