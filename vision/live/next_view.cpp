// From where to look next.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/live/next_view.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Cholesky>

#include "vision/core/parallel.h"
#include "vision/inspect/datum_fit.h"

namespace spool {
namespace {

constexpr float kPlace_m = 0.35F;  // half of what a PrimeSense shows across at 0.7 m
constexpr float kFacing = 0.5F;    // flatter than 60 degrees noise grows
constexpr float kFar_m = 0.8F;     // nothing of the design so near before it
// Three times the logarithm of 1.1: six axes, the root of the determinant.
const double kLeastGain = 3 * std::log(1.1);
constexpr double kAsGood = 0.5;  // of the best: what was said stays said
// Lower than so much, on the sphere about the spool, nobody holds a camera.
constexpr double kLow = -0.5;

// What a patch with that normal tells of a motion of its part about `middle`.
Vector6d lever(const SurfacePatch& patch, const Eigen::Vector3d& middle) {
  Vector6d h;
  const Eigen::Vector3d n = patch.normal.cast<double>();
  h << n, (patch.point.cast<double>() - middle).cross(n);
  return h;
}

double log_determinant(const Matrix6d& information) {
  return information.ldlt().vectorD().array().max(1e-12).log().sum();
}

// What is known of a part's place before it was seen: the trade's allowance at a joint.
Matrix6d allowed() {
  const DatumFitOptions joint;
  Vector6d inverse;
  inverse << Eigen::Vector3d::Constant(1 / (joint.joint_m * joint.joint_m)),
      Eigen::Vector3d::Constant(1 / (joint.joint_rad * joint.joint_rad));
  return inverse.asDiagonal();
}

constexpr double kKnownInformation = 1 / (kKnownSigma_m * kKnownSigma_m);

}  // namespace

NextView::NextView(std::shared_ptr<const SurfacePatches> patches, const DesignSurface& surface)
    : patches_(std::move(patches)),
      visible_(patches_->all().size(), 0),
      middle_(patches_->parts(), Eigen::Vector3d::Zero()),
      of_part_(patches_->parts()) {
  std::size_t made = 0;
  for (int n = 0; n < 27; ++n)
    if (n != 13)  // the middle
      sides_[made++] =
          Eigen::Vector3f(static_cast<float>(n % 3 - 1), static_cast<float>(n / 3 % 3 - 1),
                          static_cast<float>(n / 9 - 1))
              .normalized();
  const std::vector<SurfacePatch>& all = patches_->all();
  parallel_chunks(all.size(), 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k)
      for (std::size_t s = 0; s < kSides; ++s) {
        if (all[k].normal.dot(sides_[s]) < kFacing) continue;
        const float lift = 0.2F * all[k].radius_m;
        const Eigen::Vector3f from = all[k].point + lift * (all[k].normal + sides_[s]);
        if (!surface.cast(from, sides_[s], kFar_m)) visible_[k] |= 1U << s;
      }
  });
  for (std::size_t k = 0; k < all.size(); ++k) {
    const auto part = static_cast<std::size_t>(all[k].part);
    of_part_[part].push_back(static_cast<std::uint32_t>(k));
    middle_[part] += all[k].point.cast<double>();
  }
  for (std::size_t part = 0; part < middle_.size(); ++part)
    if (!of_part_[part].empty()) middle_[part] /= static_cast<double>(of_part_[part].size());
  std::vector<Eigen::Vector3f> centres;
  for (std::size_t k = 0; k < all.size(); ++k) {
    std::size_t place = 0;
    while (place < centres.size() && (centres[place] - all[k].point).norm() > kPlace_m) ++place;
    if (place == centres.size()) {
      centres.push_back(all[k].point);
      places_.emplace_back();
    }
    places_[place].patches.push_back(static_cast<std::uint32_t>(k));
  }
}

void NextView::clear() {
  next_ = 0;
  is_whole_ = false;
  said_.reset();
}

void NextView::update(const PatchReadings& readings) {
  if (places_.empty()) return;
  weigh(places_[next_], readings);
  next_ = (next_ + 1) % places_.size();
  is_whole_ = is_whole_ || next_ == 0;
}

void NextView::weigh(Place& place, const PatchReadings& readings) const {
  const std::vector<SurfacePatch>& all = patches_->all();
  std::array<double, kSides> most{};
  place.looks.fill({});
  std::array<float, kSides> counted{};
  std::size_t from = 0;
  while (from < place.patches.size()) {  // part by part: patches stand in the order of parts
    const auto part = static_cast<std::size_t>(all[place.patches[from]].part);
    std::array<Matrix6d, kSides> more;
    more.fill(Matrix6d::Zero());
    std::size_t to = from;
    std::uint32_t sides = 0;
    for (; to < place.patches.size(); ++to) {
      const std::uint32_t k = place.patches[to];
      if (static_cast<std::size_t>(all[k].part) != part) break;
      const double lacks = kKnownInformation - readings.of(k).information;
      if (lacks <= 0) continue;
      const Vector6d h = lever(all[k], middle_[part]);
      const Matrix6d told = lacks * h * h.transpose();
      sides |= visible_[k];
      for (std::size_t s = 0; s < kSides; ++s) {
        if (!is_visible(k, s)) continue;
        more[s] += told;
        place.looks[s].target += all[k].area_m2 * all[k].point;
        counted[s] += all[k].area_m2;
      }
    }
    if (sides != 0) {
      Matrix6d known = allowed();
      for (const std::uint32_t k : of_part_[part]) {
        const double information = std::min(readings.of(k).information, kKnownInformation);
        if (information <= 0) continue;
        const Vector6d h = lever(all[k], middle_[part]);
        known += information * h * h.transpose();
      }
      const double before = log_determinant(known);
      for (std::size_t s = 0; s < kSides; ++s) {
        if ((sides >> s & 1U) == 0) continue;
        const double gain = 0.5 * (log_determinant(known + more[s]) - before);
        place.looks[s].gain += gain;
        if (gain <= most[s]) continue;
        most[s] = gain;
        place.looks[s].part = static_cast<int>(part);
      }
    }
    from = to;
  }
  for (std::size_t s = 0; s < kSides; ++s) {
    place.looks[s].direction = sides_[s];
    if (counted[s] > 0) place.looks[s].target /= counted[s];
  }
}

std::optional<NextLook> NextView::best(const Eigen::Vector3d& eye, const Eigen::Vector3d& sight,
                                       const Eigen::Vector3d& down) {
  if (!is_whole_) return std::nullopt;
  // A camera is held level or looks down: up is between its picture's up and its back.
  const Eigen::Vector3d up = -(down + sight).normalized();
  const auto worth = [&](std::size_t place, std::size_t s) {
    const NextLook& look = places_[place].looks[s];
    const Eigen::Vector3d side = sides_[s].cast<double>();
    if (side.dot(up) < kLow) return 0.0;
    const Eigen::Vector3d now = eye - look.target.cast<double>();
    // Of two as good the nearer: half as much is thought of the far side.
    return look.gain * (0.75 + 0.25 * side.dot(now.normalized()));
  };
  std::pair<std::size_t, std::size_t> best{0, 0};
  double most = 0;
  for (std::size_t place = 0; place < places_.size(); ++place)
    for (std::size_t s = 0; s < kSides; ++s)
      if (const double w = worth(place, s); w > most) {
        most = w;
        best = {place, s};
      }
  if (said_ && worth(said_->first, said_->second) >= kAsGood * most) best = *said_;
  const NextLook& look = places_[best.first].looks[best.second];
  if (most <= 0 || look.gain < kLeastGain) {
    said_.reset();
    return std::nullopt;
  }
  said_ = best;
  return look;
}

}  // namespace spool
