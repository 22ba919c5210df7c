// How a flange is turned about its axis: the phase of its bolt holes.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/inspect/bolt_phase.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Cholesky>

namespace spool {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kStandsOut = 6;  // standard errors of the looks' mean
constexpr std::size_t kFewestLooks = 4, kMostLooks = 100;
constexpr double kLeastAmplitude = 0.05;  // of the share that looks through
constexpr double kWindow = 0.125;         // of the pitch to either side of a hole, or between two
constexpr float kFewest = 6;              // readings in a window, of the weight they have
constexpr double kOfTwice = 0.4;  // of twice the amplitude: so far a hole's own share stands out
constexpr int kLeastHoles = 3;

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
      BoltLook::Bin& bin = to[wrapped(low + next, bins)];
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
  using Row = Eigen::Matrix<double, 7, 1>;
  Eigen::Matrix<double, 7, 7> normal = 1e-6 * Eigen::Matrix<double, 7, 7>::Identity();
  Row right = Row::Zero();
  const Bins all = all_bins();
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double angle = middle_of(i, all.size());
    const double n = holes_.count * angle;
    Row row;
    row << 1, std::cos(n), std::sin(n), std::cos(angle), std::sin(angle), std::cos(2 * angle),
        std::sin(2 * angle);
    normal += double{all[i].seen} * row * row.transpose();
    right += double{all[i].through} * row;
  }
  const Row fit = normal.ldlt().solve(right);
  const std::complex<double> harmonic(fit[1], fit[2]);
  const double amplitude = std::abs(harmonic);
  if (!(amplitude > kLeastAmplitude)) return std::nullopt;
  const double scatter = scatter_of_phase(all, harmonic / amplitude);
  if (!(kStandsOut * scatter < 1)) return std::nullopt;
  const double phase = std::arg(harmonic) / holes_.count;
  if (!are_holes(all, phase, amplitude)) return std::nullopt;
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

// Of what was seen round an angle of the bins, the share that looked through.
std::optional<double> BoltPhase::share_at(const Bins& all, double angle_rad) const {
  const auto bins = static_cast<double>(all.size());
  const double half = kWindow * bins / holes_.count;
  const double middle = angle_rad / kTurn * bins - 0.5;
  float seen = 0, through = 0;
  for (double at = std::ceil(middle - half); at <= middle + half; ++at) {
    const BoltLook::Bin& bin = all[wrapped(at, bins)];
    seen += bin.seen;
    through += bin.through;
  }
  if (seen < kFewest) return std::nullopt;
  return double{through} / double{seen};
}

bool BoltPhase::are_holes(const Bins& all, double phase_rad, double amplitude) const {
  const double pitch = kTurn / holes_.count;
  int seen = 0, shown = 0;
  for (int i = 0; i < holes_.count; ++i) {
    const double hole = phase_rad + i * pitch;
    const auto at = share_at(all, hole), before = share_at(all, hole - pitch / 2),
               behind = share_at(all, hole + pitch / 2);
    if (!at || !before || !behind) continue;
    ++seen;
    if (*at - std::max(*before, *behind) > kOfTwice * 2 * amplitude) ++shown;
  }
  return shown >= kLeastHoles && 4 * shown >= 3 * seen;
}

}  // namespace spool
