// Claims about the order in which results are read.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/evidence/worst_first.h"

#include <string>

#include <gtest/gtest.h>

namespace spool::evidence {
namespace {

Dimension dimension(const std::string& name, Verdict status, double deviation, double tolerance,
                    bool is_measured = true) {
  Dimension out;
  out.name = name;
  out.status = status;
  out.is_measured = is_measured;
  out.deviation = deviation;
  out.tolerance = tolerance;
  return out;
}

TEST(WorstFirst, ReadsByStatusThenAgainstTheLimitWhateverTheUnit) {
  std::vector<Dimension> all{
      dimension("ok, near its limit", Verdict::kOk, 0.0029, 0.003),
      dimension("not seen", Verdict::kNotMeasured, 9, 0.003, false),
      dimension("open, negative", Verdict::kSuspicious, -0.0027, 0.003),
      dimension("open, no rule", Verdict::kSuspicious, 0.5, 0),
      dimension("out by a length", Verdict::kNotOk, 0.006, 0.003),
      dimension("open, an angle", Verdict::kSuspicious, 0.004, 0.005),
      dimension("out by an angle", Verdict::kNotOk, -0.015, 0.005),
      dimension("ok, far within", Verdict::kOk, 0.0001, 0.003),
  };
  put_worst_first(all);
  std::vector<std::string> names;
  for (const Dimension& each : all) names.push_back(each.name);
  EXPECT_EQ(names, (std::vector<std::string>{"out by an angle", "out by a length", "open, negative",
                                             "open, an angle", "open, no rule", "not seen",
                                             "ok, near its limit", "ok, far within"}));
}

TEST(WorstFirst, KeepsTheDesignsOrderAmongEquals) {
  std::vector<PartFinding> parts(3);
  for (int i = 0; i < 3; ++i) parts[static_cast<std::size_t>(i)].part = i;
  parts[2].status = Verdict::kSuspicious;
  put_worst_first(parts);
  EXPECT_EQ(parts[0].part, 2);
  EXPECT_EQ(parts[1].part, 0);
  EXPECT_EQ(parts[2].part, 1);
}

}  // namespace
}  // namespace spool::evidence
