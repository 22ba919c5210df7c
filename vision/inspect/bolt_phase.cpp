// How a flange is turned about its axis: the phase of its bolt holes.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/inspect/bolt_phase.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace spool {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kStandsOut = 6;  // standard errors of the looks' mean
constexpr std::size_t kFewestLooks = 4, kMostLooks = 100;
constexpr double kLeastAmplitude = 0.05;  // of the share that looks through

std::size_t wrapped(double bin, double bins) {
  return static_cast<std::size_t>(std::fmod(std::fmod(bin, bins) + bins, bins));
}

double middle_of(std::size_t bin, std::size_t bins) {
  return (static_cast<double>(bin) + 0.5) / static_cast<double>(bins) * kTurn;
}

}  // namespace

BoltPhase::BoltPhase(const BoltHoles& holes, const BoltPhaseOptions& options)
    : holes_(holes), options_(options) {}

void BoltPhase::clear() {
  looks_.clear();
  turned_rad_ = look_age_s_ = 0;
}

void BoltPhase::add(const BoltLook& look, double passed_s) {
  if (look.bins.empty()) return;
  look_age_s_ += passed_s;
  if (looks_.empty() || look_age_s_ > options_.look_s) {
    if (looks_.size() == kMostLooks) looks_.erase(looks_.begin());
    looks_.push_back({Bins(look.bins.size()), look.pixel_m});
    look_age_s_ = 0;
  }
  Bins& to = looks_.back().bins;
  const auto bins = static_cast<double>(to.size());
  const double shift = -turned_rad_ / kTurn * bins;  // to the looks' own zero
  for (std::size_t i = 0; i < look.bins.size(); ++i) {
    const double at = static_cast<double>(i) + shift;
    const double low = std::floor(at);
    for (const double next : {0.0, 1.0}) {
      RingBin& bin = to[wrapped(low + next, bins)];
      const auto share = static_cast<float>(next > 0 ? at - low : 1 - (at - low));
      bin.seen += share * look.bins[i].seen;
      bin.through += share * look.bins[i].through;
    }
  }
}

BoltPhase::Bins BoltPhase::all_bins() const {
  Bins all(looks_.front().bins.size());
  for (const BoltLook& look : looks_)
    for (std::size_t i = 0; i < all.size(); ++i) {
      all[i].seen += look.bins[i].seen;
      all[i].through += look.bins[i].through;
    }
  return all;
}

std::optional<BoltTurn> BoltPhase::turn() const {
  if (looks_.size() < kFewestLooks) return std::nullopt;
  const Bins all = all_bins();
  const auto harmonic = hole_harmonic(all, holes_.count);
  if (!harmonic || !(harmonic->amplitude > kLeastAmplitude)) return std::nullopt;
  const double phase = harmonic->phase_rad;
  const double scatter = scatter_of_phase(all, std::polar(1.0, holes_.count * phase));
  if (!(kStandsOut * scatter < 1)) return std::nullopt;
  if (!are_holes(all, holes_.count, *harmonic)) return std::nullopt;
  double pixel_m = 0;
  for (const BoltLook& look : looks_) pixel_m += look.pixel_m / static_cast<double>(looks_.size());
  const double bias = options_.bias_px * pixel_m / (0.5 * holes_.bolt_circle_m);
  const double sigma = scatter / holes_.count;
  return BoltTurn{std::remainder(phase + turned_rad_ - holes_.clocking_rad, kTurn / holes_.count),
                  std::sqrt(sigma * sigma + bias * bias)};
}

// The standard error of the harmonic's phase (rad), by how the looks scatter across its
// `direction`; infinite where they hold nothing of it.
double BoltPhase::scatter_of_phase(const Bins& all, const std::complex<double>& direction) const {
  double through = 0, seen = 0;
  std::vector<std::complex<double>> waves(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    through += double{all[i].through};
    seen += double{all[i].seen};
    waves[i] = std::polar(1.0, holes_.count * middle_of(i, all.size())) * std::conj(direction);
  }
  double along = 0, across2 = 0;
  for (const BoltLook& look : looks_) {
    // Less what is seen of the ring, and how much, in the mean.
    std::complex<double> sum;
    for (std::size_t i = 0; i < waves.size(); ++i)
      sum += (double{look.bins[i].through} - through / seen * double{look.bins[i].seen}) * waves[i];
    along += sum.real();
    across2 += sum.imag() * sum.imag();
  }
  const auto count = static_cast<double>(looks_.size());
  return along > 0 ? std::sqrt(across2 * count / (count - 1)) / along
                   : std::numeric_limits<double>::infinity();
}

}  // namespace spool
