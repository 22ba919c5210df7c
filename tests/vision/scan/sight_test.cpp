// Claims about what a camera saw: there, through, hidden, and nothing where it did not look.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/scan/sight.h"

#include <limits>

#include <gtest/gtest.h>

namespace spool {
namespace {

using Eigen::Vector3f;

constexpr float kGate = 0.02F;

// A wall 2 m off, seen by 160 x 120 pixels, with a box of 0.4 m a side before it at 1.5 m; one
// corner of the wall gave no reading.
std::vector<Vector3f> wall_with_box() {
  std::vector<Vector3f> scan;
  for (int y = 0; y < 120; ++y)
    for (int x = 0; x < 160; ++x) {
      const Vector3f ray((static_cast<float>(x) - 79.5F) / 144,
                         (static_cast<float>(y) - 59.5F) / 144, 1);
      const Vector3f on_box = 1.5F * ray;
      if (x > 120 && y > 90)
        scan.push_back(Vector3f::Constant(std::numeric_limits<float>::quiet_NaN()));
      else
        scan.push_back(on_box.head<2>().cwiseAbs().maxCoeff() < 0.2F ? on_box : 2 * ray);
    }
  return scan;
}

TEST(Sight, TellsWhereSomethingIsFromWhereNothingIs) {
  const Sight sight(wall_with_box());
  EXPECT_EQ(sight.at({0, 0, 1.5F}, kGate), Seen::kThere);
  EXPECT_EQ(sight.at({0, 0, 1.51F}, kGate), Seen::kThere);
  EXPECT_EQ(sight.at({0, 0, 1.4F}, kGate), Seen::kThrough);
  EXPECT_EQ(sight.at({0, 0, 1.8F}, kGate), Seen::kHidden);
  EXPECT_EQ(sight.at({0.6F, 0, 1.5F}, kGate), Seen::kThrough);
  EXPECT_EQ(sight.at({0.6F, 0, 2}, kGate), Seen::kThere);
  EXPECT_EQ(sight.at({0.6F, 0, 2.5F}, kGate), Seen::kHidden);
}

TEST(Sight, SaysNothingOfWhatItDidNotSee) {
  const Sight sight(wall_with_box());
  EXPECT_EQ(sight.at({0.9F, 0.7F, 2}, kGate), Seen::kNot) << "no reading";
  EXPECT_EQ(sight.at({5, 0, 2}, kGate), Seen::kNot) << "beside the picture";
  EXPECT_EQ(sight.at({0, 0, -1}, kGate), Seen::kNot) << "behind the camera";
  EXPECT_EQ(sight.at(Vector3f::Constant(std::numeric_limits<float>::quiet_NaN()), kGate),
            Seen::kNot);
  EXPECT_EQ(Sight({}).at({0, 0, 1}, kGate), Seen::kNot);
  EXPECT_EQ(Sight(std::vector<Vector3f>(5, Vector3f(0, 0, 1))).at({0, 0, 0.5F}, kGate), Seen::kNot)
      << "five readings of one place are no picture";
}

// Beside an edge a pixel may read either side of it: what lies there is not seen through.
TEST(Sight, IsCarefulBesideAnEdge) {
  const Sight sight(wall_with_box());
  for (const float beside : {-0.01F, 0.0F, 0.01F})
    EXPECT_EQ(sight.at({0.2F + beside, 0, 1.5F}, kGate), Seen::kThere) << beside;
}

TEST(Sighted, SharesOnlyWhatWasLookedAt) {
  Sighted sighted;
  EXPECT_EQ(sighted.share_there(), 1);
  for (const Seen seen : {Seen::kThere, Seen::kThere, Seen::kThere, Seen::kThrough, Seen::kNot,
                          Seen::kHidden, Seen::kHidden})
    sighted.add(seen);
  EXPECT_EQ(sighted.share_there(), 0.75);
  EXPECT_EQ(sighted.others, 3U);
}

}  // namespace
}  // namespace spool
