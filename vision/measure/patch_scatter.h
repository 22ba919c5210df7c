// How much the means of a surface's patches scatter beyond what independent readings let them.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <map>

namespace spool {

// Residuals of one fitted surface, patch by patch.
class PatchScatter {
 public:
  // `residual_m`: of a reading that was used in the fit.
  void add(int patch, double residual_m);
  // `unknowns`: that the fit had; `correlated`: readings that are worth one.
  void finish(int unknowns, double correlated);

  // Patches of enough readings to have a mean.
  [[nodiscard]] std::size_t patches() const { return used_; }
  // By how much the fit's covariance is too small: chi-squared of the patches' means over its
  // degrees of freedom (Birge 1932), 1 at least.
  [[nodiscard]] double birge() const { return birge_; }
  [[nodiscard]] double chi2() const { return chi2_; }
  // Variance (m^2) that the means have beyond that of their readings, may be negative by chance,
  // and the degrees of freedom that it was told from.
  [[nodiscard]] double excess_m2() const { return excess_m2_; }
  [[nodiscard]] double freedom() const { return freedom_; }

 private:
  struct Patch {
    double sum = 0, squares = 0;
    std::size_t count = 0;
  };
  std::map<int, Patch> patches_;
  std::size_t used_ = 0;
  double birge_ = 1, chi2_ = 0, excess_m2_ = 0, freedom_ = 0;
};

// The same over all surfaces of a scan.
class ScatterPool {
 public:
  void add(const PatchScatter& scatter);
  // What a patch errs by as a whole (m), 0 where nothing shows.
  [[nodiscard]] double error_m() const;
  // Of one surface a ratio under that of all is chance.
  [[nodiscard]] double birge() const;

 private:
  double sum_m2_ = 0, chi2_ = 0, freedom_ = 0;
};

}  // namespace spool
