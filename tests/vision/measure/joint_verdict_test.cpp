// Claims about what may be said of a joint.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/measure/joint_verdict.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace spool {
namespace {

JointError joint(double against_tolerance, bool is_to_blame, bool is_measured = true) {
  JointError out;
  out.part_near = 1;
  out.part_far = 2;
  out.is_measured = is_measured;
  out.against_tolerance = against_tolerance;
  out.is_to_blame = is_to_blame;
  return out;
}

Dimension across(std::vector<int> parts, Verdict status) {
  Dimension out;
  out.parts = std::move(parts);
  out.status = status;
  return out;
}

TEST(JointVerdict, IsNoBetterThanTheDimensionsAcrossIt) {
  const Dimension ok = across({0, 1, 2}, Verdict::kOk), open = across({1, 2}, Verdict::kSuspicious),
                  unseen = across({1, 2, 3}, Verdict::kNotMeasured),
                  wrong = across({1, 2}, Verdict::kNotOk), beside = across({2, 3}, Verdict::kNotOk);
  struct Case {
    std::string name;
    JointError joint;
    std::vector<Dimension> dimensions;
    Verdict expected;
  };
  const std::vector<Case> cases{
      {"all ok across it", joint(0.3, false), {ok, beside}, Verdict::kOk},
      {"one open", joint(0.3, false), {ok, open}, Verdict::kSuspicious},
      {"one not seen", joint(0.3, false), {ok, unseen}, Verdict::kSuspicious},
      {"nothing across it", joint(0.3, false), {beside}, Verdict::kSuspicious},
      {"not measured itself", joint(0, false, false), {ok}, Verdict::kNotMeasured},
      {"beyond its own tolerance", joint(1.2, false), {ok}, Verdict::kSuspicious},
      {"to blame for what is out", joint(2.0, true), {ok, wrong}, Verdict::kNotOk},
      {"to blame, and nothing is out", joint(2.0, true), {open}, Verdict::kSuspicious},
      {"another joint's fault", joint(2.0, false), {wrong}, Verdict::kSuspicious},
      {"to blame within tolerance", joint(0.9, true), {wrong}, Verdict::kSuspicious},
  };
  for (const Case& each : cases) {
    SCOPED_TRACE(each.name);
    EXPECT_EQ(joint_verdict(each.joint, each.dimensions), each.expected);
  }
}

}  // namespace
}  // namespace spool
