// The offscreen target: its orientation, its limits, copying.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <GLES3/gl3.h>

#include "render/gl_state.h"
#include "render/offscreen.h"
#include "tests/render/gl_test.h"

namespace spool::render {
namespace {

using test::GlTest;
class OffscreenGl : public GlTest {};

void fill(const Offscreen& target, int x, int y, int width, int height, float red, float green) {
  target.bind();
  set_draw_state({});
  glEnable(GL_SCISSOR_TEST);
  glScissor(x, y, width, height);
  glClearColor(red, green, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  glDisable(GL_SCISSOR_TEST);
}

TEST_F(OffscreenGl, ReadsTheTopRowFirst) {
  auto target = Offscreen::create(6, 5);
  ASSERT_TRUE(target) << target.error().message;
  fill(*target, 0, 0, 6, 5, 0, 0);
  fill(*target, 1, 4, 1, 1, 1, 0);  // GL counts rows from the bottom: this is the top one
  const Image image = target->read();
  ASSERT_EQ(image.width, 6);
  ASSERT_EQ(image.height, 5);
  EXPECT_EQ(image.pixel(1, 0)[0], 255);
  EXPECT_EQ(image.pixel(1, 4)[0], 0);
  EXPECT_EQ(image.pixel(0, 0)[0], 0);
  EXPECT_EQ(image.pixel(0, 0)[3], 255);
}

TEST_F(OffscreenGl, RefusesSizesThatCannotBe) {
  for (const auto& [width, height] : {std::pair{0, 10}, {10, -1}, {100000, 10}}) {
    const auto target = Offscreen::create(width, height);
    ASSERT_FALSE(target);
    EXPECT_EQ(target.error().code, ErrorCode::kBadInput);
    EXPECT_NE(target.error().message.find("px a side"), std::string::npos)
        << target.error().message;
  }
}

TEST_F(OffscreenGl, CopiesIntoAPartOfAnotherAndLeavesOutWhatLiesOutside) {
  auto small = Offscreen::create(4, 3);
  auto large = Offscreen::create(10, 8);
  ASSERT_TRUE(small && large);
  fill(*large, 0, 0, 10, 8, 0, 0);
  fill(*small, 0, 0, 4, 3, 0, 1);
  fill(*small, 0, 2, 1, 1, 1, 0);  // its top left corner
  small->copy_to(*large, 2, 1);
  const Image image = large->read();
  EXPECT_EQ(image.pixel(2, 1)[0], 255);
  EXPECT_EQ(image.pixel(5, 3)[1], 255);
  EXPECT_EQ(image.pixel(6, 3)[1], 0);
  EXPECT_EQ(image.pixel(5, 4)[1], 0);
  small->copy_to(*large, 8, 6);
  EXPECT_EQ(large->read().pixel(8, 6)[0], 255);
}

TEST_F(OffscreenGl, AnEmptyOneCanBeMovedInto) {
  Offscreen target;
  EXPECT_EQ(target.width(), 0);
  auto made = Offscreen::create(3, 2);
  ASSERT_TRUE(made);
  target = std::move(*made);
  EXPECT_EQ(target.read().width, 3);
}

}  // namespace
}  // namespace spool::render
