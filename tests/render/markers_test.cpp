// Marks as data: where they stand and what they carry.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "render/markers.h"

#include <gtest/gtest.h>

namespace spool::render {
namespace {

View view() {
  View v;
  v.camera.width = 640;
  v.camera.height = 480;
  v.camera.fx = v.camera.fy = 500;
  v.camera.cx = 319.5;
  v.camera.cy = 239.5;
  return v;
}

TEST(Markers, StandOnTheirPointWithTheirNumberBeside) {
  const std::vector<Marker> markers{{{0.1F, 0.05F, 1.0F}, Marker::Kind::kPicked, "2"}};
  const Canvas canvas = draw_markers(markers, view(), 1);
  ASSERT_FALSE(canvas.shapes.empty());
  EXPECT_NEAR(canvas.shapes.front().centre.x(), 319.5 + 50 + 0.5, 1e-3);
  EXPECT_NEAR(canvas.shapes.front().centre.y(), 239.5 + 25 + 0.5, 1e-3);
  ASSERT_EQ(canvas.texts.size(), 1U);
  EXPECT_EQ(canvas.texts[0].utf8, "2");
}

TEST(Markers, KindsDifferInShapeAndNotOnlyInColour) {
  const auto shapes = [](Marker::Kind kind) {
    const std::vector<Marker> markers{{{0, 0, 1}, kind, ""}};
    const Canvas canvas = draw_markers(markers, view(), 1);
    std::vector<float> form;
    for (const CanvasShape& s : canvas.shapes) {
      form.insert(form.end(), {s.half_size.x(), s.half_size.y(), s.corner_px, s.turn_rad});
    }
    return form;
  };
  EXPECT_NE(shapes(Marker::Kind::kProposed), shapes(Marker::Kind::kPicked));
  EXPECT_NE(shapes(Marker::Kind::kPicked), shapes(Marker::Kind::kScan));
  EXPECT_NE(shapes(Marker::Kind::kProposed), shapes(Marker::Kind::kScan));
}

TEST(Markers, BehindTheCameraFarOutsideOrNotFiniteAreNotDrawn) {
  const std::vector<Marker> markers{{{0, 0, -1}, Marker::Kind::kPicked, "1"},
                                    {{9, 0, 1}, Marker::Kind::kPicked, "2"},
                                    {{std::nanf(""), 0, 1}, Marker::Kind::kPicked, "3"},
                                    {{0, 0, 0}, Marker::Kind::kPicked, "4"}};
  const Canvas canvas = draw_markers(markers, view(), 1);
  EXPECT_TRUE(canvas.shapes.empty());
  EXPECT_TRUE(canvas.texts.empty());
}

TEST(Markers, GrowWithTheScale) {
  const std::vector<Marker> markers{{{0, 0, 1}, Marker::Kind::kProposed, ""}};
  const Canvas one = draw_markers(markers, view(), 1);
  const Canvas two = draw_markers(markers, view(), 2);
  ASSERT_EQ(one.shapes.size(), two.shapes.size());
  for (std::size_t i = 0; i < one.shapes.size(); ++i) {
    EXPECT_NEAR(two.shapes[i].half_size.x(), 2 * one.shapes[i].half_size.x(), 1e-4);
  }
}

}  // namespace
}  // namespace spool::render
