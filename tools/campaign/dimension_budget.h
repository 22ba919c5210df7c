// What the stated doubt of dimensions is made of, as a table.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "tools/campaign/dimension_trial.h"

namespace spool::campaign {

// Lines for each measured dimension of a spool, and what is usual of each kind. All are standard
// uncertainties (k = 1), mm or degrees: what the features' fits leave (noise, what readings share,
// the catalogue's tolerances, the datum's features); the sensor's warp or how stations were merged;
// its scale.
class BudgetTable {
 public:
  void print_each(const TriedSpool& tried, int seed);
  // The medians of what was printed.
  void print_usual(const std::string& row) const;

 private:
  struct Shares {
    std::vector<double> total, features, warp, scale;
  };
  std::map<std::string, Shares> kinds_;
};

}  // namespace spool::campaign
