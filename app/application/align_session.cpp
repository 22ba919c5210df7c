// The three-point alignment as the fitter does it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/application/align_session.h"

#include <algorithm>

namespace spool {

namespace {
constexpr std::size_t kPairsNeeded = 3;
}

std::optional<Landmark> AlignSession::lit() const {
  if (chosen_) return chosen_;
  for (const Landmark& landmark : proposed_) {
    const bool used = std::any_of(pairs_.begin(), pairs_.end(), [&](const PointPair& pair) {
      return pair.design == landmark.position;
    });
    if (!used) return landmark;
  }
  return std::nullopt;
}

bool AlignSession::pick_scan_point(const Eigen::Vector3d& p_camera) {
  const std::optional<Landmark> point = lit();
  if (!point) return false;
  pairs_.push_back({point->position, p_camera});
  chosen_.reset();
  result_ = pairs_.size() < kPairsNeeded ? PairsAlignment{} : align_pairs(pairs_);
  return true;
}

void AlignSession::undo() {
  if (chosen_) {
    chosen_.reset();
    return;
  }
  if (pairs_.empty()) return;
  pairs_.pop_back();
  result_ = pairs_.size() < kPairsNeeded ? PairsAlignment{} : align_pairs(pairs_);
}

void AlignSession::clear() {
  chosen_.reset();
  pairs_.clear();
  result_ = {};
}

}  // namespace spool
