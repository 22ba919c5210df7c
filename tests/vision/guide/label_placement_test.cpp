// Labels in crowds and corners: none on another, none off the paper.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/guide/label_placement.h"

#include <gtest/gtest.h>

namespace spool::test {
namespace {

using Eigen::Vector2d;
using guide::Box2;
using guide::LabelRequest;

const Box2 kArea{Vector2d(0, 0), Vector2d(100, 100)};

TEST(LabelPlacement, ThirtyLabelsOfOnePlaceLieBesideOneAnother) {
  const std::vector<LabelRequest> requests(30, {Vector2d(50, 50), Vector2d(6, 2)});
  const auto placed = guide::place_labels(requests, {}, {}, kArea);
  for (std::size_t a = 0; a < placed.size(); ++a) {
    ASSERT_TRUE(placed[a].is_placed);
    EXPECT_TRUE(kArea.contains(placed[a].box));
    for (std::size_t b = a + 1; b < placed.size(); ++b)
      EXPECT_TRUE(placed[a].box.intersection(placed[b].box).isEmpty());
  }
}

TEST(LabelPlacement, KeepsOffALineWhereItCan) {
  const guide::LineToAvoid line{{Vector2d(0, 50), Vector2d(100, 50)}, 3};
  const auto placed = guide::place_labels({{Vector2d(50, 50), Vector2d(6, 2)}}, {line}, {}, kArea);
  EXPECT_EQ(guide::length_within(line.line, placed[0].box), 0);
}

TEST(LabelPlacement, SaysWhatHasNoPlace) {
  const Box2 small{Vector2d(0, 0), Vector2d(14, 6)};
  const std::vector<LabelRequest> requests(3, {Vector2d(7, 3), Vector2d(6, 2)});
  int placed = 0;
  for (const auto& each : guide::place_labels(requests, {}, {}, small)) placed += each.is_placed;
  EXPECT_EQ(placed, 1);
}

TEST(LabelPlacement, FarLabelsHaveALeaderFromWhatTheyName) {
  const Box2 wall{Vector2d(30, 30), Vector2d(70, 70)};
  const auto placed = guide::place_labels({{Vector2d(50, 50), Vector2d(6, 2)}}, {}, {wall}, kArea);
  ASSERT_TRUE(placed[0].is_placed);
  EXPECT_TRUE(placed[0].needs_leader);
  EXPECT_EQ(placed[0].leader.a, Vector2d(50, 50));
  EXPECT_TRUE(wall.intersection(placed[0].box).isEmpty());
}

}  // namespace
}  // namespace spool::test
