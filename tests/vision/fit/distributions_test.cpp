// Tests of the distributions against tables and closed forms.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/fit/distributions.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace spool {
namespace {

TEST(Distributions, BetaHasItsClosedForms) {
  for (const double x : {0.0, 0.01, 0.3, 0.5, 0.77, 0.999, 1.0}) {
    EXPECT_NEAR(regularised_beta(x, 1, 1), x, 1e-14);
    EXPECT_NEAR(regularised_beta(x, 3, 1), x * x * x, 1e-14);
    EXPECT_NEAR(regularised_beta(x, 1, 4), 1 - std::pow(1 - x, 4), 1e-14);
    EXPECT_NEAR(regularised_beta(x, 0.5, 0.5), 2 / std::numbers::pi * std::asin(std::sqrt(x)),
                1e-13);
    EXPECT_NEAR(regularised_beta(x, 2.5, 7), 1 - regularised_beta(1 - x, 7, 2.5), 1e-13);
  }
}

TEST(Distributions, StudentsLimitsAreThoseOfTheTables) {
  struct Row {
    double confidence, freedom, t;
  };
  // Two-sided limits as statistical tables print them.
  for (const Row& row : {Row{0.95, 1, 12.706}, Row{0.95, 4, 2.776}, Row{0.95, 10, 2.228},
                         Row{0.99, 4, 4.604}, Row{0.90, 30, 1.697}, Row{0.95, 1e7, 1.960}}) {
    EXPECT_NEAR(student_limit(row.confidence, row.freedom), row.t, 6e-4);
    EXPECT_NEAR(student_within(student_limit(row.confidence, row.freedom), row.freedom),
                row.confidence, 1e-12);
  }
  EXPECT_NEAR(student_within(1, 1), 0.5, 1e-14);  // Cauchy's quartile
}

TEST(Distributions, FishersTailHasAClosedFormOnTwoDegreesAndIsStudentsOnOne) {
  for (const double f : {0.0, 0.5, 2.2, 40.0}) {
    EXPECT_NEAR(fisher_beyond(f, 2, 4), std::pow(1 + 2 * f / 4, -2), 1e-13);
    EXPECT_NEAR(fisher_beyond(f, 1, 7), 1 - student_within(std::sqrt(f), 7), 1e-13);
  }
}

}  // namespace
}  // namespace spool
