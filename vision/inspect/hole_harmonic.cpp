// What goes round a ring as often as a flange has bolt holes: its size, its phase, its holes.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/inspect/hole_harmonic.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include <Eigen/Cholesky>

namespace spool {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kWindow = 0.125;  // of the pitch to either side of a hole, or between two
constexpr float kFewest = 6;       // readings in a window, of the weight they have
constexpr double kOfTwice = 0.4;   // of twice the amplitude: so far a hole's own share stands out
constexpr int kLeastHoles = 3;

std::size_t wrapped(double bin, double bins) {
  return static_cast<std::size_t>(std::fmod(std::fmod(bin, bins) + bins, bins));
}

// Of what was seen round an angle of the bins, the share that is as at a hole.
std::optional<double> share_at(std::span<const RingBin> all, int count, double angle_rad) {
  const auto bins = static_cast<double>(all.size());
  const double half = kWindow * bins / count;
  const double middle = angle_rad / kTurn * bins - 0.5;
  float seen = 0, through = 0;
  for (double at = std::ceil(middle - half); at <= middle + half; ++at) {
    const RingBin& bin = all[wrapped(at, bins)];
    seen += bin.seen;
    through += bin.through;
  }
  if (seen < kFewest) return std::nullopt;
  return double{through} / double{seen};
}

}  // namespace

std::optional<HoleHarmonic> hole_harmonic(std::span<const RingBin> bins, int count, int overtones) {
  const Eigen::Index size = 5 + 2 * overtones;
  Eigen::MatrixXd normal = 1e-6 * Eigen::MatrixXd::Identity(size, size);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(size);
  const auto row_at = [&](std::size_t i) {
    const double angle = (static_cast<double>(i) + 0.5) / static_cast<double>(bins.size()) * kTurn;
    Eigen::VectorXd row(size);
    row.head<5>() << 1, std::cos(angle), std::sin(angle), std::cos(2 * angle), std::sin(2 * angle);
    for (int k = 1; k <= overtones; ++k) {
      row[3 + 2 * k] = std::cos(k * count * angle);
      row[4 + 2 * k] = std::sin(k * count * angle);
    }
    return row;
  };
  double seen = 0, through = 0;
  for (std::size_t i = 0; i < bins.size(); ++i) {
    const Eigen::VectorXd row = row_at(i);
    normal += double{bins[i].seen} * row * row.transpose();
    right += double{bins[i].through} * row;
    seen += double{bins[i].seen};
    through += double{bins[i].through};
  }
  const Eigen::LDLT<Eigen::MatrixXd> solver = normal.ldlt();
  const Eigen::VectorXd fit = solver.solve(right);
  HoleHarmonic harmonic;
  const std::complex<double> wave(fit[5], fit[6]);
  harmonic.amplitude = std::abs(wave);
  if (!(seen > 0 && harmonic.amplitude > 0)) return std::nullopt;
  harmonic.phase_rad = std::arg(wave) / count;

  // A share's variance is p (1 - p) / seen by the mean share p, or how the bins scatter about the
  // fit, whichever is more.
  const double mean = through / seen;
  double chi2 = 0, filled = 0;
  for (std::size_t i = 0; i < bins.size(); ++i) {
    if (!(bins[i].seen > 0)) continue;
    const double off = double{bins[i].through} / double{bins[i].seen} - row_at(i).dot(fit);
    chi2 += double{bins[i].seen} * off * off;
    ++filled;
  }
  const auto unknowns = static_cast<double>(size);
  if (filled <= unknowns) return std::nullopt;
  const double variance = std::max(mean * (1 - mean), chi2 / (filled - unknowns));
  Eigen::VectorXd across = Eigen::VectorXd::Zero(size);  // d phase angle / d fit
  across[5] = -wave.imag() / std::norm(wave);
  across[6] = wave.real() / std::norm(wave);
  harmonic.sigma_rad = std::sqrt(variance * across.dot(solver.solve(across)));
  return harmonic;
}

bool are_holes(std::span<const RingBin> bins, int count, const HoleHarmonic& harmonic) {
  const double pitch = kTurn / count;
  int seen = 0, shown = 0;
  for (int i = 0; i < count; ++i) {
    const double hole = harmonic.phase_rad + i * pitch;
    const auto at = share_at(bins, count, hole), before = share_at(bins, count, hole - pitch / 2),
               behind = share_at(bins, count, hole + pitch / 2);
    if (!at || !before || !behind) continue;
    ++seen;
    if (*at - std::max(*before, *behind) > kOfTwice * 2 * harmonic.amplitude) ++shown;
  }
  return shown >= kLeastHoles && 4 * shown >= 3 * seen;
}

}  // namespace spool
