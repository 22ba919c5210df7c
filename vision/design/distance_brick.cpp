// What one brick of a distance volume holds: two smooth distances whose lesser is the true one.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/design/distance_brick.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace spool {
namespace {

constexpr std::size_t kTexels = kBrickSide * kBrickSide * kBrickSide;

using Distances = std::array<float, kTexels>;
using Sides = std::array<std::uint8_t, kTexels>;  // 0 or 1

std::size_t texel(std::size_t x, std::size_t y, std::size_t z) {
  return (z * kBrickSide + y) * kBrickSide + x;
}

float lesser(float a, float b) { return std::abs(b) < std::abs(a) ? b : a; }

// The two gradients that differ most, roughly; each texel goes to the nearer one, then to the
// nearer of the two sides' means.
Sides tell_apart(const BrickTexels& texels) {
  const auto most_unlike = [&](const Eigen::Vector3f& direction) {
    return std::min_element(texels.begin(), texels.end(),
                            [&](const DistanceSample& a, const DistanceSample& b) {
                              return a.outward.dot(direction) < b.outward.dot(direction);
                            })
        ->outward;
  };
  Eigen::Vector3f mean = Eigen::Vector3f::Zero();
  for (const DistanceSample& sample : texels) mean += sample.outward;
  std::array<Eigen::Vector3f, 2> centre;
  centre[0] = most_unlike(mean);
  centre[1] = most_unlike(centre[0]);
  Sides sides{};
  for (int round = 0; round < 2; ++round) {
    std::array<Eigen::Vector3f, 2> sum{Eigen::Vector3f::Zero(), Eigen::Vector3f::Zero()};
    for (std::size_t i = 0; i < kTexels; ++i) {
      const Eigen::Vector3f& g = texels[i].outward;
      sides[i] = (g - centre[1]).squaredNorm() < (g - centre[0]).squaredNorm() ? 1 : 0;
      sum[sides[i]] += g;
    }
    for (std::size_t s = 0; s < 2; ++s)
      if (sum[s].squaredNorm() > 0) centre[s] = sum[s].normalized();
  }
  return sides;
}

// Calls `body(texel, x, y, z)` for each texel.
template <class Body>
void for_texels(const Body& body) {
  for (std::size_t z = 0; z < kBrickSide; ++z)
    for (std::size_t y = 0; y < kBrickSide; ++y)
      for (std::size_t x = 0; x < kBrickSide; ++x) body(texel(x, y, z), x, y, z);
}

// One side's distance carried on over all texels, ring by ring, each along the gradients of those
// beside it that have one. Both sides hold a texel.
Distances carried_on(BrickTexels texels, const Sides& sides, std::uint8_t side, float spacing_m) {
  std::array<std::uint8_t, kTexels> known{};
  for (std::size_t i = 0; i < kTexels; ++i) known[i] = sides[i] == side ? 1 : 0;
  const auto around = [](std::size_t i) {
    return std::pair(i > 0 ? i - 1 : i, std::min(i + 1, kBrickSide - 1));
  };
  for (std::uint8_t ring = 1; std::find(known.begin(), known.end(), 0) != known.end(); ++ring) {
    for_texels([&](std::size_t here, std::size_t x, std::size_t y, std::size_t z) {
      if (known[here] != 0) return;
      const auto [x0, x1] = around(x);
      const auto [y0, y1] = around(y);
      const auto [z0, z1] = around(z);
      DistanceSample sum;
      float weights = 0;
      for (std::size_t k = z0; k <= z1; ++k)
        for (std::size_t j = y0; j <= y1; ++j)
          for (std::size_t i = x0; i <= x1; ++i) {
            const std::size_t there = texel(i, j, k);
            if (known[there] == 0 || known[there] > ring) continue;
            const Eigen::Vector3f steps(static_cast<float>(x) - static_cast<float>(i),
                                        static_cast<float>(y) - static_cast<float>(j),
                                        static_cast<float>(z) - static_cast<float>(k));
            const DistanceSample& beside = texels[there];
            const float weight = 1 / steps.squaredNorm();
            sum.distance_m += weight * (beside.distance_m + spacing_m * beside.outward.dot(steps));
            sum.outward += weight * beside.outward;
            weights += weight;
          }
      if (weights == 0) return;
      known[here] = static_cast<std::uint8_t>(ring + 1);
      texels[here] = {sum.distance_m / weights, sum.outward.normalized()};
    });
  }
  Distances distances{};
  for (std::size_t i = 0; i < kTexels; ++i) distances[i] = texels[i].distance_m;
  return distances;
}

// The cell's eight corners.
std::array<std::size_t, 8> corners_of(std::size_t x, std::size_t y, std::size_t z) {
  std::array<std::size_t, 8> corners{};
  for (std::size_t k = 0; k < 8; ++k)
    corners[k] = texel(x + (k & 1U), y + (k >> 1U & 1U), z + (k >> 2U));
  return corners;
}

// Whether the lesser of two sides is the nearer one all over each cell, as it is at the texels. Not
// where a side passes through zero in a cell that it does not hold alone: another surface, or an
// edge, that is not there.
bool sides_hold(const std::array<Distances, 2>& of_side, const Sides& sides) {
  for (std::size_t z = 0; z < kBrickCells; ++z)
    for (std::size_t y = 0; y < kBrickCells; ++y)
      for (std::size_t x = 0; x < kBrickCells; ++x) {
        const std::array<std::size_t, 8> corners = corners_of(x, y, z);
        const auto all = [&](const auto& predicate) {
          return std::all_of(corners.begin(), corners.end(), predicate);
        };
        if (all([&](std::size_t c) { return of_side[0][c] == of_side[1][c]; })) continue;
        for (std::size_t s = 0; s < 2; ++s) {
          if (all([&](std::size_t c) { return sides[c] == s; })) continue;  // its own cell
          if (!all([&](std::size_t c) { return of_side[s][c] > 0; }) &&
              !all([&](std::size_t c) { return of_side[s][c] < 0; }))
            return false;
        }
      }
  return true;
}

// The most that the lesser of two interpolated distances is off by in the middles of cells: as it
// counts, DistanceBrick::error_m.
float error_of(const Distances& own, const Distances& other, const BrickMiddles& middles,
               float spacing_m, const BrickLimits& limits) {
  float worst = 0;
  std::size_t middle = 0;
  for (std::size_t z = 0; z < kBrickCells; ++z)
    for (std::size_t y = 0; y < kBrickCells; ++y)
      for (std::size_t x = 0; x < kBrickCells; ++x) {
        const float exact = middles[middle++].distance_m;
        float a = 0;
        float b = 0;
        for (const std::size_t corner : corners_of(x, y, z)) {
          a += own[corner] / 8;
          b += other[corner] / 8;
        }
        const float found = lesser(a, b);
        // The cell comes so near to the surface.
        const float nearest =
            std::min(std::abs(exact), std::abs(found)) - kHalfDiagonal * spacing_m;
        if (nearest > limits.band_m) continue;
        const float counts = nearest > limits.near_m ? 1 / kFurtherOff : 1.0F;
        worst = std::max(worst, counts * std::abs(found - exact));
      }
  return worst;
}

DistanceBrick packed(const Distances& first, const Distances& second, float error_m) {
  DistanceBrick brick;
  for (std::size_t i = 0; i < kTexels; ++i)
    brick.texels[i] = {Eigen::half(first[i]), Eigen::half(second[i])};
  brick.error_m = error_m;
  return brick;
}

}  // namespace

DistanceBrick make_plain_brick(const BrickTexels& texels) {
  Distances whole{};
  for (std::size_t i = 0; i < kTexels; ++i) whole[i] = texels[i].distance_m;
  return packed(whole, whole, 0);
}

DistanceBrick make_brick(const BrickTexels& texels, const BrickMiddles& middles, float spacing_m,
                         const BrickLimits& limits) {
  Distances whole{};
  for (std::size_t i = 0; i < kTexels; ++i) whole[i] = texels[i].distance_m;
  const float error_m = error_of(whole, whole, middles, spacing_m, limits);
  if (error_m <= limits.tolerance_m) return packed(whole, whole, error_m);

  const Sides sides = tell_apart(texels);
  if (std::count(sides.begin(), sides.end(), sides[0]) == kTexels)
    return packed(whole, whole, error_m);
  std::array<Distances, 2> of_side{carried_on(texels, sides, 0, spacing_m),
                                   carried_on(texels, sides, 1, spacing_m)};
  // The side that is not the nearest can be no nearer; where it is of the other sign it must not
  // tie.
  for (Distances& side : of_side)
    for (std::size_t i = 0; i < kTexels; ++i)
      if (std::abs(side[i]) < std::abs(whole[i]))
        side[i] = side[i] * whole[i] > 0 ? whole[i] : -1.01F * whole[i];
  if (!sides_hold(of_side, sides)) return packed(whole, whole, error_m);
  const float error_of_two_m = error_of(of_side[0], of_side[1], middles, spacing_m, limits);
  if (error_of_two_m < error_m) return packed(of_side[0], of_side[1], error_of_two_m);
  return packed(whole, whole, error_m);
}

}  // namespace spool
