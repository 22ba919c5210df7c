// The three-point alignment as the fitter does it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/application/align_session.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace spool {

namespace {
constexpr std::size_t kPairsNeeded = 3;
constexpr double kLikely = 0.5;
// The proposal's order also says how well a finger finds a point: it holds as long as the geometry
// does not lose more than this to the best that is left.
constexpr double kGoodShare = 0.5;
}  // namespace

AlignSession::AlignSession(std::vector<Landmark> proposed, Evidence evidence)
    : proposed_(std::move(proposed)),
      evidence_(std::move(evidence)),
      skipped_(proposed_.size(), false) {
  propose(std::vector<double>{});
}

std::optional<Landmark> AlignSession::lit() const {
  if (chosen_) return chosen_;
  return next_ ? std::optional(proposed_[*next_]) : std::nullopt;
}

void AlignSession::choose_design_point(Landmark point) {
  chosen_ = std::move(point);
  refused_ = false;
}

bool AlignSession::can_skip() const { return lit().has_value() && pairs_.size() < kPairsNeeded; }

std::optional<Landmark> AlignSession::lit_after_skip() const {
  const bool chose_another = chosen_ && !(next_ && chosen_->position == proposed_[*next_].position);
  const auto& index = chose_another ? next_ : after_next_;
  return index ? std::optional(proposed_[*index]) : std::nullopt;
}

void AlignSession::skip() {
  const std::optional<Landmark> point = lit();
  if (!point) return;
  for (std::size_t i = 0; i < proposed_.size(); ++i) {
    if (proposed_[i].position == point->position) skipped_[i] = true;
  }
  chosen_.reset();
  refused_ = false;
  propose();
}

bool AlignSession::pick_scan_point(const Eigen::Vector3d& p_camera) {
  const std::optional<Landmark> point = lit();
  if (!point) return false;
  pairs_.push_back({point->position, p_camera});
  chosen_.reset();
  refused_ = false;
  result_ = pairs_.size() < kPairsNeeded ? PairsAlignment{} : align_pairs(pairs_);
  propose();
  return true;
}

void AlignSession::undo() {
  refused_ = false;
  if (chosen_) {
    chosen_.reset();
    return;
  }
  if (pairs_.empty()) return;
  pairs_.pop_back();
  result_ = pairs_.size() < kPairsNeeded ? PairsAlignment{} : align_pairs(pairs_);
  propose();
}

void AlignSession::clear() {
  chosen_.reset();
  refused_ = false;
  pairs_.clear();
  result_ = {};
  skipped_.assign(proposed_.size(), false);
  propose();
}

void AlignSession::propose() { propose(evidence_ ? evidence_(pairs_) : std::vector<double>{}); }

void AlignSession::propose(const std::vector<double>& likelihood) {
  std::vector<std::size_t> open, likely;
  for (std::size_t i = 0; i < proposed_.size(); ++i) {
    const bool used = std::any_of(pairs_.begin(), pairs_.end(), [&](const PointPair& pair) {
      return pair.design == proposed_[i].position;
    });
    if (used || skipped_[i]) continue;
    open.push_back(i);
    if (i >= likelihood.size() || likelihood[i] >= kLikely) likely.push_back(i);
  }
  // What seems not to be measured comes last: the fitter may see better.
  const auto take = [&]() -> std::optional<std::size_t> {
    const std::optional<std::size_t> best = best_of(likely.empty() ? open : likely);
    if (best) {
      std::erase(open, *best);
      std::erase(likely, *best);
    }
    return best;
  };
  next_ = take();
  after_next_ = take();
}

// How much a point adds to the picks: far from the first, off the line of the first two.
double AlignSession::worth(const Landmark& landmark) const {
  const Eigen::Vector3d& p = landmark.position;
  if (pairs_.empty()) return 1;
  if (pairs_.size() == 2) {
    return (pairs_[1].design - pairs_[0].design).cross(p - pairs_[0].design).norm();
  }
  double nearest = std::numeric_limits<double>::infinity();
  for (const PointPair& pair : pairs_) nearest = std::min(nearest, (p - pair.design).norm());
  return nearest;
}

// The first that adds enough.
std::optional<std::size_t> AlignSession::best_of(const std::vector<std::size_t>& open) const {
  double most = 0;
  for (const std::size_t i : open) most = std::max(most, worth(proposed_[i]));
  for (const std::size_t i : open) {
    if (worth(proposed_[i]) >= kGoodShare * most) return i;
  }
  return std::nullopt;
}

}  // namespace spool
