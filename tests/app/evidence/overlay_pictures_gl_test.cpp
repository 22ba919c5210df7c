// The pictures of a report show the steel: numbers beside every picture.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdlib>

#include <gtest/gtest.h>

#include "app/evidence/view_choice.h"
#include "app/evidence/writer.h"
#include "render/egl_context.h"
#include "render/view.h"
#include "tests/app/evidence/sample_record.h"

namespace spool::evidence {
namespace {

// Counts pixels that differ from the top left corner's by more than `limit` in some channel.
std::size_t drawn_pixels(const render::Image& image, int limit) {
  std::size_t count = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      int most = 0;
      for (int c = 0; c < 3; ++c)
        most = std::max(most, std::abs(image.pixel(x, y)[c] - image.pixel(image.width / 2, 2)[c]));
      if (most > limit) ++count;
    }
  return count;
}

TEST(DrawOverlays, ShowsTheDesignInEveryPicture) {
  auto context = render::EglContext::surfaceless();
  if (!context && std::getenv("SPOOL_REQUIRE_GL") == nullptr)
    GTEST_SKIP() << context.error().message;
  ASSERT_TRUE(context) << context.error().message;
  const auto record = test::sample_record();
  const auto pictures = draw_overlays(record, 640, 400);
  ASSERT_TRUE(pictures) << pictures.error().message;
  ASSERT_GE(pictures->size(), 2U);
  const auto views = choose_views(record, 1.6);
  ASSERT_EQ(views.size(), pictures->size());
  for (std::size_t i = 0; i < pictures->size(); ++i) {
    const auto& picture = (*pictures)[i];
    EXPECT_EQ(picture.file, "overlay_" + std::to_string(i + 1) + ".png");
    EXPECT_EQ(picture.text, views[i].text);
    ASSERT_EQ(picture.image.width, 640);
    ASSERT_EQ(picture.image.height, 400);
    // The boxes fill a good part of a picture that is fitted to them.
    EXPECT_GT(drawn_pixels(picture.image, 12), 640U * 400U / 20);
  }
}

TEST(DrawOverlays, DrawsNothingWhereTheDesignWasNotFound) {
  auto record = test::sample_record();
  record.inspection.alignment.found = false;
  const auto pictures = draw_overlays(record, 640, 400);  // needs no context
  ASSERT_TRUE(pictures) << pictures.error().message;
  EXPECT_TRUE(pictures->empty());
}

TEST(DrawOverlays, IsTheSameTwice) {
  auto context = render::EglContext::surfaceless();
  if (!context && std::getenv("SPOOL_REQUIRE_GL") == nullptr)
    GTEST_SKIP() << context.error().message;
  ASSERT_TRUE(context) << context.error().message;
  const auto record = test::sample_record();
  const auto first = draw_overlays(record, 320, 200);
  const auto second = draw_overlays(record, 320, 200);
  ASSERT_TRUE(first && second);
  ASSERT_EQ(first->size(), second->size());
  for (std::size_t i = 0; i < first->size(); ++i)
    EXPECT_EQ((*first)[i].image.rgba, (*second)[i].image.rgba);
}

}  // namespace
}  // namespace spool::evidence
