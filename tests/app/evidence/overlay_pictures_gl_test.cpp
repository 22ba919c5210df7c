// The pictures of a report show the steel: numbers beside every picture.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdlib>
#include <limits>

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

// How far two pixels differ in the channel that differs most.
int pixel_difference(const render::Image& a, const render::Image& b, int x, int y) {
  int most = 0;
  for (int c = 0; c < 3; ++c) most = std::max(most, std::abs(a.pixel(x, y)[c] - b.pixel(x, y)[c]));
  return most;
}

TEST(DrawOverlays, LeavesOutTheClutterThatWouldHideTheSteel) {
  auto context = render::EglContext::surfaceless();
  if (!context && std::getenv("SPOOL_REQUIRE_GL") == nullptr)
    GTEST_SKIP() << context.error().message;
  ASSERT_TRUE(context) << context.error().message;
  auto record = test::sample_record();
  const auto open = draw_overlays(record, 640, 400);
  // A shell of clutter 3 cm round the boxes' bounds: whatever the view, some of it lies in front.
  auto& inspection = record.inspection;
  const Eigen::AlignedBox3d shell(Eigen::Vector3d(-0.03, -0.03, -0.03),
                                  Eigen::Vector3d(0.43, 0.53, 0.23));
  for (double a = 0; a <= 1; a += 0.01)
    for (double b = 0; b <= 1; b += 0.01)
      for (int axis = 0; axis < 3; ++axis)
        for (const double side : {0.0, 1.0}) {
          Eigen::Vector3d share;
          share(axis) = side;
          share((axis + 1) % 3) = a;
          share((axis + 2) % 3) = b;
          inspection.scan_design.points.push_back(
              (shell.min() + share.cwiseProduct(shell.sizes())).cast<float>());
          inspection.declutter.classes.push_back(PointClass::kClutter);
          inspection.deviations.distance_m.push_back(std::numeric_limits<float>::quiet_NaN());
          inspection.deviations.part.push_back(-1);
        }
  const auto shut = draw_overlays(record, 640, 400);
  ASSERT_TRUE(open && shut);
  ASSERT_EQ(open->size(), shut->size());
  for (std::size_t i = 0; i < open->size(); ++i) {
    const auto& before = (*open)[i].image;
    const auto& after = (*shut)[i].image;
    std::size_t steel = 0;
    std::size_t hidden = 0;
    for (int y = 0; y < before.height; ++y)
      for (int x = 100; x < before.width; ++x) {  // right of the legend
        int off_background = 0;
        for (int c = 0; c < 3; ++c)
          off_background = std::max(off_background, std::abs(before.pixel(x, y)[c] -
                                                             before.pixel(before.width / 2, 2)[c]));
        if (off_background <= 25) continue;
        ++steel;
        // The translucent design lets the shell behind it through a little; a point in front is
        // grey and opaque.
        if (pixel_difference(before, after, x, y) > 60) ++hidden;
      }
    ASSERT_GT(steel, 2000U);
    // Points half beside the outline still cover some of it.
    EXPECT_LT(static_cast<double>(hidden), 0.1 * static_cast<double>(steel)) << (*open)[i].text;
  }
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
