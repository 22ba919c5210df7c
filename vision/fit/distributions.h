// Student's t and Fisher's F: what a regression's intervals and its test are read from.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace spool {

// I_x(a, b), the regularised incomplete beta function, by its continued fraction (DLMF 8.17.22);
// a, b over 0, x in 0 to 1.
[[nodiscard]] double regularised_beta(double x, double a, double b);

// P(|T| <= t) of Student's t with `freedom` degrees (over 0); t of 0 or more.
[[nodiscard]] double student_within(double t, double freedom);

// The t that |T| stays within with probability `confidence` (0 to 1, both excluded).
[[nodiscard]] double student_limit(double confidence, double freedom);

// P(F > f) of Fisher's F with these degrees (over 0); f of 0 or more.
[[nodiscard]] double fisher_beyond(double f, double freedom_above, double freedom_below);

}  // namespace spool
