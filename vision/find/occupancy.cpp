// Is there a scan point near: one bit a cell.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/find/occupancy.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "vision/core/median.h"

namespace spool {
namespace {

constexpr double kCellsPerNear = 1.5;   // a cell is two thirds of what counts as near
constexpr int kCells = 1 << 20;         // along each side: a float tells them apart to a sixteenth
constexpr std::size_t kPlaces = 10000;  // so many points say where most are
constexpr std::uint32_t kFirstBits = 10;

// The median of each coordinate: a few far points do not move it.
Eigen::Vector3f middle_of(std::span<const Eigen::Vector3f> points) {
  Eigen::Vector3f middle = Eigen::Vector3f::Zero();
  const std::size_t step = points.size() / kPlaces + 1;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    std::vector<float> values;
    for (std::size_t i = 0; i < points.size(); i += step)
      if (points[i].allFinite()) values.push_back(points[i][axis]);
    if (values.empty()) continue;
    middle[axis] = median(values);
  }
  return middle;
}

}  // namespace

Occupancy::Occupancy(std::span<const Eigen::Vector3f> points, double near_m) {
  assert(near_m > 0 && "near is a distance");
  const double cell_m = near_m / kCellsPerNear;
  per_m_ = static_cast<float>(1.0 / cell_m);
  size_ = static_cast<float>(kCells);
  corner_ = middle_of(points).array() - static_cast<float>(0.5 * kCells * cell_m);
  resize_slots(kFirstBits);
  // The cells whose middle may be within near of a point of the cell at zero.
  constexpr auto kNear2 = static_cast<float>(kCellsPerNear * kCellsPerNear);
  const int wide = static_cast<int>(std::ceil(kCellsPerNear));
  std::vector<Eigen::Array3i> steps;
  for (int k = -wide; k <= wide; ++k)
    for (int j = -wide; j <= wide; ++j)
      for (int i = -wide; i <= wide; ++i) {
        const Eigen::Array3i step(i, j, k);
        const Eigen::Array3f least = (step.abs().cast<float>() - 0.5F).max(0.0F);
        if (least.square().sum() <= kNear2) steps.push_back(step);
      }
  for (const Eigen::Vector3f& point : points) {
    const Eigen::Array3f cell = (point - corner_).array() * per_m_;
    if (!((cell >= 0.0F).all() && (cell < size_).all())) continue;  // NaN too
    const Eigen::Array3i at = cell.cast<int>();
    const Eigen::Array3f inside = cell - at.cast<float>() - 0.5F;
    for (const Eigen::Array3i& step : steps)
      if ((step.cast<float>() - inside).square().sum() <= kNear2) set(at + step);
  }
}

// Where the key is, or the free place for it.
std::size_t Occupancy::slot_for(std::uint64_t key) const {
  std::size_t at = first_slot(key);
  while (slots_[at].key != key && slots_[at].key != 0) at = (at + 1) & (slots_.size() - 1);
  return at;
}

void Occupancy::resize_slots(std::uint32_t bits) {
  const std::vector<Slot> before = std::move(slots_);
  slots_.assign(std::size_t{1} << bits, Slot{});
  shift_ = 64 - bits;
  for (const Slot& slot : before)
    if (slot.key != 0) slots_[slot_for(slot.key)] = slot;
}

void Occupancy::set(const Eigen::Array3i& cell) {
  if (!((cell >= 0).all() && (cell < kCells).all())) return;
  const auto i = static_cast<std::uint32_t>(cell.x());
  const auto j = static_cast<std::uint32_t>(cell.y());
  const auto k = static_cast<std::uint32_t>(cell.z());
  const std::uint64_t key = key_of(i, j, k);
  std::size_t at = slot_for(key);
  if (slots_[at].key == 0) {
    if (bits_.size() / 8 * 2 >= slots_.size()) {
      resize_slots(64 - shift_ + 1);
      at = slot_for(key);
    }
    slots_[at] = {key, static_cast<std::uint32_t>(bits_.size())};
    bits_.resize(bits_.size() + 8, 0);
  }
  bits_[slots_[at].first + (k & 7U)] |= std::uint64_t{1} << bit_of(i, j);
}

}  // namespace spool
