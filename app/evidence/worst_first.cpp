// The order in which people read what was found: the worst first.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/evidence/worst_first.h"

#include <algorithm>
#include <cmath>

namespace spool::evidence {

bool is_worse(Verdict a, double a_off, Verdict b, double b_off) {
  return a != b ? worse(a, b) == a : a_off > b_off;
}

double against_limit(const Dimension& dimension) {
  if (!dimension.is_measured || !(dimension.tolerance > 0)) return 0;
  return std::abs(dimension.deviation) / dimension.tolerance;
}

void put_worst_first(std::vector<Dimension>& dimensions) {
  std::stable_sort(dimensions.begin(), dimensions.end(),
                   [](const Dimension& a, const Dimension& b) {
                     return is_worse(a.status, against_limit(a), b.status, against_limit(b));
                   });
}

void put_worst_first(std::vector<PartFinding>& parts) {
  std::stable_sort(parts.begin(), parts.end(), [](const PartFinding& a, const PartFinding& b) {
    return is_worse(a.status, a.deviation.p95_abs_m, b.status, b.deviation.p95_abs_m);
  });
}

}  // namespace spool::evidence
