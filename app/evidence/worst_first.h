// The order in which people read what was found: the worst first.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "vision/inspect/inspection.h"

namespace spool::evidence {

// Whether one of status `a` is read before one of `b`: not_ok, suspicious, not_measured, ok; of one
// status the one that is further off (`a_off`, `b_off`: of one kind, 0 or more).
[[nodiscard]] bool is_worse(Verdict a, double a_off, Verdict b, double b_off);

// How far it is off against what is allowed: 1 at the limit. 0 where it was not measured or no rule
// gives it a tolerance.
[[nodiscard]] double against_limit(const Dimension& dimension);

// By status, then against_limit(); else the order stays.
void put_worst_first(std::vector<Dimension>& dimensions);
// By status, then how far 95 % of the part's points lie within; else the order stays.
void put_worst_first(std::vector<PartFinding>& parts);

}  // namespace spool::evidence
