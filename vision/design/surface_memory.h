// What one search of the surface leaves behind for the next one close by.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include <Eigen/Core>

namespace spool {

// The elements of a surface (triangles, or points of a cloud) round a place: every element nearer
// to `at` than `reach_m` is among `elements`. By the triangle inequality they answer any query that
// lies less than reach_m from `at` by more than the answer's own distance, with no search. Belongs
// to one surface and one point that moves little between queries; a cache line wide.
struct alignas(64) SurfaceMemory {
  static constexpr std::size_t kElements = 12;
  static constexpr std::uint32_t kNone = 0xFFFFFFFFU;

  Eigen::Vector3f at = Eigen::Vector3f::Zero();     // m
  float reach_m = -1;                               // below 0: nothing is known
  std::array<std::uint32_t, kElements> elements{};  // kNone behind the last
};

// Distances in float are wrong by less than this (m) on anything a table or a shop holds: what
// would be decided by less is searched for again.
inline constexpr float kMemorySlack = 2e-6F;

}  // namespace spool
