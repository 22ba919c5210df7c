// What the stated doubt of dimensions is made of, as a table.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/campaign/dimension_budget.h"

#include <cstdio>
#include <numbers>

#include "tools/campaign/quantile.h"

namespace spool::campaign {

void BudgetTable::print_each(const TriedSpool& tried, int seed) {
  for (const TriedDimension& each : tried.dimensions) {
    const Dimension& d = each.stated;
    if (!d.is_measured) continue;
    const double unit = d.is_angle ? 180 / std::numbers::pi : 1000;
    const UncertaintyBudget& u = d.u;
    std::printf("  %d %-16s %-45s u %.3f %s: features %.3f, warp %.3f, scale %.3f\n", seed,
                d.kind.c_str(), d.name.c_str(), unit * u.total(), d.is_angle ? "deg" : "mm",
                unit * u.fit, unit * u.warp, unit * u.scale);
    const bool is_length = !d.is_angle && d.kind != "offset";
    const std::string kind = !is_length      ? d.kind
                             : d.nominal > 1 ? "length over 1 m"
                                             : "length to 1 m";
    Shares& shares = kinds_[kind + (d.is_angle ? ", deg" : ", mm")];
    shares.total.push_back(unit * u.total());
    shares.features.push_back(unit * u.fit);
    shares.warp.push_back(unit * u.warp);
    shares.scale.push_back(unit * u.scale);
  }
}

void BudgetTable::print_usual(const std::string& row) const {
  std::printf("| %s: medians of u (k = 1) | dimensions | all | features | warp | scale |\n",
              row.c_str());
  for (const auto& [kind, shares] : kinds_) {
    const auto median = [](const std::vector<double>& of) { return quantile(of, 0.5); };
    std::printf("| %s | %zu | %.3f | %.3f | %.3f | %.3f |\n", kind.c_str(), shares.total.size(),
                median(shares.total), median(shares.features), median(shares.warp),
                median(shares.scale));
  }
}

}  // namespace spool::campaign
