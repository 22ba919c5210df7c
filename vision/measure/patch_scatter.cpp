// How much the means of a surface's patches scatter beyond what independent readings let them.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/measure/patch_scatter.h"

#include <algorithm>
#include <cmath>

namespace spool {

void PatchScatter::add(int patch, double residual_m) {
  Patch& at = patches_[patch];
  at.sum += residual_m;
  at.squares += residual_m * residual_m;
  ++at.count;
}

void PatchScatter::finish(int unknowns, double correlated) {
  constexpr std::size_t kLeast = 5;  // readings a patch
  // The noise of one reading, from the patches' insides.
  double inside = 0, freedom = 0;
  for (const auto& [place, patch] : patches_) {
    if (patch.count < kLeast) continue;
    const auto n = static_cast<double>(patch.count);
    inside += patch.squares - patch.sum * patch.sum / n;
    freedom += n - 1;
    ++used_;
  }
  freedom_ = static_cast<double>(used_) - unknowns;
  if (freedom_ < 1 || !(inside > 0)) {
    freedom_ = 0;
    return;
  }
  const double variance = correlated * inside / freedom;  // m^2, of readings worth one together
  double between = 0, expected = 0;
  for (const auto& [place, patch] : patches_) {
    if (patch.count < kLeast) continue;
    const auto n = static_cast<double>(patch.count);
    const double mean = patch.sum / n;
    chi2_ += mean * mean * n / variance;
    between += mean * mean;
    expected += variance / n;
  }
  birge_ = std::max(1.0, chi2_ / freedom_);
  excess_m2_ = between / freedom_ - expected / static_cast<double>(used_);
}

void ScatterPool::add(const PatchScatter& scatter) {
  sum_m2_ += scatter.freedom() * scatter.excess_m2();
  chi2_ += scatter.freedom() > 0 ? scatter.chi2() : 0;
  freedom_ += scatter.freedom();
}

double ScatterPool::birge() const { return freedom_ > 0 ? std::max(1.0, chi2_ / freedom_) : 1; }

double ScatterPool::error_m() const {
  return freedom_ > 0 ? std::sqrt(std::max(0.0, sum_m2_ / freedom_)) : 0;
}

}  // namespace spool
