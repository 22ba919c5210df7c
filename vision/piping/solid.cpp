// Closed bodies of triangles out of loops of shared vertices.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/piping/solid.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace spool::piping {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

void add_triangle(Solid& solid, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  if (a != b && b != c && c != a) solid.triangles.push_back({a, b, c});
}

double widest(std::span<const Station> stations) {
  double radius = 0;
  for (const Station& each : stations) radius = std::max(radius, each.outer);
  return radius;
}

}  // namespace

int sides_of(double radius) {
  // A chord lies r (1 - cos(pi / n)) inside its circle.
  const double share = std::clamp(1 - kChordError / std::max(radius, 1e-6), -1.0, 1.0);
  const double sides = std::numbers::pi / std::max(std::acos(share), 1e-3);
  return std::clamp(4 * static_cast<int>(std::ceil(sides / 4)), 24, 240);
}

Loop add_loop(Solid& solid, std::span<const Eigen::Vector3d> points) {
  Loop loop;
  loop.reserve(points.size());
  for (const Eigen::Vector3d& point : points) {
    loop.push_back(static_cast<std::uint32_t>(solid.vertices.size()));
    solid.vertices.push_back(point);
  }
  return loop;
}

Loop add_circle(Solid& solid, const Eigen::Isometry3d& frame, double radius, int sides) {
  std::vector<Eigen::Vector3d> points;
  points.reserve(static_cast<std::size_t>(sides));
  for (int i = 0; i < sides; ++i) {
    const double angle = kTurn * i / sides;
    points.push_back(frame *
                     Eigen::Vector3d(radius * std::cos(angle), radius * std::sin(angle), 0));
  }
  return add_loop(solid, points);
}

void add_strip(Solid& solid, const Loop& lower, const Loop& upper) {
  assert(lower.size() == upper.size() && "a strip joins loops of one length");
  for (std::size_t i = 0; i < lower.size(); ++i) {
    const std::size_t j = (i + 1) % lower.size();
    add_triangle(solid, lower[i], lower[j], upper[j]);
    add_triangle(solid, lower[i], upper[j], upper[i]);
  }
}

void add_zip(Solid& solid, const Loop& lower, std::span<const double> lower_angles,
             const Loop& upper, std::span<const double> upper_angles) {
  const auto angle = [](std::span<const double> angles, std::size_t i) {
    return angles[i % angles.size()] + kTurn * static_cast<double>(i / angles.size());
  };
  std::size_t i = 0;
  std::size_t j = 0;
  while (i < lower.size() || j < upper.size()) {
    const bool goes_lower =
        j == upper.size() ||
        (i < lower.size() && angle(lower_angles, i + 1) <= angle(upper_angles, j + 1));
    const std::uint32_t a = lower[i % lower.size()];
    const std::uint32_t b = upper[j % upper.size()];
    if (goes_lower) {
      ++i;
      add_triangle(solid, a, lower[i % lower.size()], b);
    } else {
      ++j;
      add_triangle(solid, a, upper[j % upper.size()], b);
    }
  }
}

void add_fan(Solid& solid, const Loop& loop, const Eigen::Vector3d& apex) {
  const auto top = static_cast<std::uint32_t>(solid.vertices.size());
  solid.vertices.push_back(apex);
  for (std::size_t i = 0; i < loop.size(); ++i)
    add_triangle(solid, loop[i], loop[(i + 1) % loop.size()], top);
}

void add_tube(Solid& solid, std::span<const Station> stations) {
  assert(stations.size() >= 2 && "a tube has two ends");
  const bool is_hollow = stations.front().inner > 0;
  const int sides = sides_of(widest(stations));
  std::vector<Loop> outer;
  std::vector<Loop> inner;
  for (std::size_t s = 0; s < stations.size(); ++s) {
    // A step in one wall alone leaves the other's circle where it is: the same vertices.
    const auto circle = [&](std::vector<Loop>& loops, double Station::*radius) {
      const bool is_same = s > 0 && stations[s].*radius == stations[s - 1].*radius &&
                           stations[s].frame.matrix() == stations[s - 1].frame.matrix();
      loops.push_back(is_same ? loops.back()
                              : add_circle(solid, stations[s].frame, stations[s].*radius, sides));
    };
    circle(outer, &Station::outer);
    if (is_hollow) circle(inner, &Station::inner);
  }
  for (std::size_t s = 0; s + 1 < stations.size(); ++s) {
    add_strip(solid, outer[s], outer[s + 1]);
    if (is_hollow) add_strip(solid, inner[s + 1], inner[s]);
  }
  if (is_hollow) {
    add_strip(solid, outer.back(), inner.back());
    add_strip(solid, inner.front(), outer.front());
    return;
  }
  add_fan(solid, outer.back(), stations.back().frame.translation());
  Loop backwards = outer.front();
  std::reverse(backwards.begin(), backwards.end());
  add_fan(solid, backwards, stations.front().frame.translation());
}

void add_revolved(Solid& solid, std::span<const Eigen::Vector2d> chain) {
  assert(chain.size() >= 3 && "a chain has its two poles and something between");
  double radius = 0;
  for (const Eigen::Vector2d& each : chain) radius = std::max(radius, each[0]);
  const int sides = sides_of(radius);
  std::vector<Loop> loops;
  for (std::size_t i = 1; i + 1 < chain.size(); ++i) {
    if (i > 1 && chain[i] == chain[i - 1]) continue;
    Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
    frame.translation().z() = chain[i][1];
    loops.push_back(add_circle(solid, frame, chain[i][0], sides));
  }
  for (std::size_t i = 0; i + 1 < loops.size(); ++i) add_strip(solid, loops[i], loops[i + 1]);
  Loop first = loops.front();
  std::reverse(first.begin(), first.end());
  add_fan(solid, first, {0, 0, chain.front()[1]});
  add_fan(solid, loops.back(), {0, 0, chain.back()[1]});
}

}  // namespace spool::piping
