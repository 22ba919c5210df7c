// Pairs of design elements, looked up by what does not change when the design moves.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/find/pair_table.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "vision/core/parallel.h"

namespace spool {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr std::size_t kDistanceBins = 24;
constexpr std::size_t kAngleBins = 7;      // of 11 degrees, from 15 to 90
constexpr std::size_t kDihedralBins = 24;  // of 15 degrees
constexpr std::size_t kBins = kDistanceBins * kAngleBins * kAngleBins * kDihedralBins;
constexpr float kLeastSine = 0.2588F;     // of 15 degrees
constexpr float kEitherWay = 0.17F;       // cosine of 80 degrees: noise may turn the sign
constexpr float kLeastOfSize = 0.2F;      // a short pair is a poor lever
constexpr std::size_t kMostPerBin = 300;  // common pairs say little, and each costs a trial

std::optional<PairFrame> frame_of(const Eigen::Vector3f& pa, const Eigen::Vector3f& da,
                                  const Eigen::Vector3f& pb, const Eigen::Vector3f& db) {
  PairFrame frame;
  const Eigen::Vector3f line = pb - pa;
  frame.distance = line.norm();
  if (!(frame.distance > 0)) return std::nullopt;
  const Eigen::Vector3f x = line / frame.distance;
  const float cos_a = da.dot(x);
  const float cos_b = db.dot(x);
  const Eigen::Vector3f across_a = da - cos_a * x;
  const Eigen::Vector3f across_b = db - cos_b * x;
  const float sin_a = across_a.norm();
  const float sin_b = across_b.norm();
  if (sin_a < kLeastSine || sin_b < kLeastSine) return std::nullopt;
  const Eigen::Vector3f y = across_a / sin_a;
  const Eigen::Vector3f z = x.cross(y);
  frame.axes << x, y, z;
  frame.middle = 0.5F * (pa + pb);
  frame.angle_a = std::atan2(sin_a, std::abs(cos_a));
  frame.angle_b = std::atan2(sin_b, std::abs(cos_b));
  frame.dihedral = std::atan2(across_b.dot(z), across_b.dot(y));
  return frame;
}

}  // namespace

std::optional<PairFrame> pair_frame(const Element& a, const Element& b) {
  const Eigen::Vector3f line = b.point - a.point;
  const Eigen::Vector3f da = a.direction.dot(line) < 0 ? -a.direction : a.direction;
  const Eigen::Vector3f db = b.direction.dot(line) < 0 ? -b.direction : b.direction;
  return frame_of(a.point, da, b.point, db);
}

std::size_t PairTable::bin(const PairFrame& frame) const {
  const auto at = [](float value, float from, float width, std::size_t count) {
    const float place = (value - from) / width;
    return std::min(count - 1, static_cast<std::size_t>(std::max(0.0F, place)));
  };
  const float least_angle = std::asin(kLeastSine);
  const float width = (kPi / 2 - least_angle) / kAngleBins;
  std::size_t bin = at(frame.distance, least_, 1 / per_bin_, kDistanceBins);
  bin = bin * kAngleBins + at(frame.angle_a, least_angle, width, kAngleBins);
  bin = bin * kAngleBins + at(frame.angle_b, least_angle, width, kAngleBins);
  return bin * kDihedralBins + at(frame.dihedral, -kPi, 2 * kPi / kDihedralBins, kDihedralBins);
}

PairTable::PairTable(std::vector<Element> elements, double size_m, const Watch& watch)
    : elements_(std::move(elements)),
      least_(static_cast<float>(kLeastOfSize * size_m)),
      most_(static_cast<float>(size_m)),
      per_bin_(static_cast<float>(kDistanceBins) / (most_ - least_)) {
  assert(elements_.size() < 65536 && "elements are numbered in 16 bits");
  // Every pair once, by its first element; then counted into bins in that order, so that the table
  // is the same on any number of threads.
  struct Placed {
    std::uint32_t bin;
    Entry entry;
  };
  std::vector<std::vector<Placed>> of_first(elements_.size());
  parallel_chunks(elements_.size(), 8, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end && !watch.cancelled(); ++i)
      for (std::size_t j = 0; j < elements_.size(); ++j)
        if (i != j)
          each_way(i, j, [&](std::size_t bin, const Entry& entry) {
            of_first[i].push_back({static_cast<std::uint32_t>(bin), entry});
          });
  });
  first_.assign(kBins + 1, 0);
  std::vector<std::uint32_t> count(kBins, 0);
  for (const auto& some : of_first) {
    if (watch.cancelled()) return;
    for (const Placed& placed : some) ++count[placed.bin];
  }
  for (std::size_t at = 0; at < kBins; ++at)
    first_[at + 1] =
        first_[at] + static_cast<std::uint32_t>(std::min<std::size_t>(count[at], kMostPerBin));
  entries_.resize(first_.back());
  // A full bin keeps every nth, evenly over the order of the elements.
  std::vector<std::uint32_t> met(kBins, 0), kept(kBins, 0);
  for (const auto& some : of_first) {
    if (watch.cancelled()) break;
    for (const auto& [at, entry] : some) {
      const std::uint32_t room = first_[at + 1] - first_[at];
      const std::uint64_t due = std::uint64_t{met[at]++} * room / count[at];
      if (due < kept[at] || kept[at] >= room) continue;
      entries_[first_[at] + kept[at]++] = entry;
    }
  }
  if (!watch.cancelled()) return;
  first_.assign(kBins + 1, 0);
  entries_ = {};
}

template <class Use>
void PairTable::each_way(std::size_t i, std::size_t j, const Use& use) const {
  const Element& a = elements_[i];
  const Element& b = elements_[j];
  const Eigen::Vector3f line = b.point - a.point;
  const float distance = line.norm();
  if (distance < least_ || distance > most_) return;
  const float along_a = a.direction.dot(line) / distance;
  const float along_b = b.direction.dot(line) / distance;
  for (const int flip_a : {0, 1}) {
    if ((flip_a != 0 ? -along_a : along_a) < -kEitherWay) continue;
    for (const int flip_b : {0, 1}) {
      if ((flip_b != 0 ? -along_b : along_b) < -kEitherWay) continue;
      const auto frame = frame_of(a.point, flip_a != 0 ? -a.direction : a.direction, b.point,
                                  flip_b != 0 ? -b.direction : b.direction);
      if (frame)
        use(bin(*frame),
            Entry{static_cast<std::uint16_t>(i), static_cast<std::uint16_t>(j),
                  static_cast<std::uint8_t>(flip_a), static_cast<std::uint8_t>(flip_b)});
    }
  }
}

std::size_t PairTable::count(const PairFrame& frame) const {
  if (frame.distance < least_ || frame.distance > most_) return 0;
  const std::size_t at = bin(frame);
  return first_[at + 1] - first_[at];
}

Eigen::Isometry3f PairTable::pose(const PairFrame& frame, std::size_t nth) const {
  const Entry& entry = entries_[first_[bin(frame)] + nth];
  const Element& a = elements_[entry.a];
  const Element& b = elements_[entry.b];
  const auto design = frame_of(a.point, entry.flip_a != 0 ? -a.direction : a.direction, b.point,
                               entry.flip_b != 0 ? -b.direction : b.direction);
  assert(design && "an entry is a pair with a frame");
  // What the two pairs' dihedral angles differ by is shared between both ends.
  const float turn = 0.5F * std::remainder(design->dihedral - frame.dihedral, 2 * kPi);
  Eigen::Isometry3f T = Eigen::Isometry3f::Identity();
  T.linear() = design->axes * Eigen::AngleAxisf(turn, Eigen::Vector3f::UnitX()).toRotationMatrix() *
               frame.axes.transpose();
  T.translation() = design->middle - T.linear() * frame.middle;
  return T;
}

}  // namespace spool
