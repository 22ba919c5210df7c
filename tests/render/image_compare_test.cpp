// The comparer itself, before anything relies on it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "render/image_compare.h"

#include <gtest/gtest.h>

namespace spool::render {
namespace {

Image grey(int width, int height, std::uint8_t level) {
  return {width, height,
          std::vector<std::uint8_t>(4 * static_cast<std::size_t>(width * height), level)};
}

std::uint8_t& channel(Image& image, int x, int y, int c) {
  return image
      .rgba[4 * static_cast<std::size_t>(y * image.width + x) + static_cast<std::size_t>(c)];
}

TEST(CompareImages, PassesEqualPicturesUnderZeroLimits) {
  const auto result = compare_images(grey(8, 6, 90), grey(8, 6, 90), {0, 0, 0});
  EXPECT_TRUE(result.passed);
  EXPECT_EQ(result.worst, 0);
  EXPECT_EQ(result.mean, 0);
  EXPECT_TRUE(result.worst_pixels.empty());
}

TEST(CompareImages, FindsOnePixelOffAndWhere) {
  Image actual = grey(10, 10, 90);
  channel(actual, 7, 3, 2) = 70;
  const auto result = compare_images(actual, grey(10, 10, 90), {5, 0.0, 1.0});
  EXPECT_FALSE(result.passed);
  EXPECT_EQ(result.worst, 20);
  EXPECT_DOUBLE_EQ(result.fraction_beyond, 0.01);
  EXPECT_DOUBLE_EQ(result.mean, 20.0 / 400);
  ASSERT_EQ(result.worst_pixels.size(), 1U);
  EXPECT_EQ(result.worst_pixels[0].x, 7);
  EXPECT_EQ(result.worst_pixels[0].y, 3);
  EXPECT_LT(result.difference.pixel(7, 3)[1], 255);
  EXPECT_EQ(result.difference.pixel(3, 7)[1], 255);
  EXPECT_NE(result.summary().find("(7, 3): 20"), std::string::npos);
}

TEST(CompareImages, PassesExactlyAtEachLimitAndFailsBeyond) {
  Image actual = grey(10, 10, 90);
  channel(actual, 0, 0, 0) = 95;
  const Image expected = grey(10, 10, 90);
  EXPECT_TRUE(compare_images(actual, expected, {5, 0.0, 1.0}).passed);
  EXPECT_FALSE(compare_images(actual, expected, {4, 0.0, 1.0}).passed);
  EXPECT_TRUE(compare_images(actual, expected, {4, 0.01, 1.0}).passed);
  EXPECT_FALSE(compare_images(actual, expected, {4, 0.0099, 1.0}).passed);
  EXPECT_TRUE(compare_images(actual, expected, {5, 0.0, 5.0 / 400}).passed);
  EXPECT_FALSE(compare_images(actual, expected, {5, 0.0, 4.99 / 400}).passed);
}

// What a single limit on stray pixels would let through.
TEST(CompareImages, MeanCatchesAFaintChangeEverywhere) {
  const auto result = compare_images(grey(10, 10, 92), grey(10, 10, 90), {5, 0.001, 0.1});
  EXPECT_EQ(result.fraction_beyond, 0);
  EXPECT_FALSE(result.passed);
}

TEST(CompareImages, OtherSizesAndEmptyPicturesNeverPass) {
  EXPECT_FALSE(compare_images(grey(10, 10, 0), grey(10, 11, 0), {255, 1, 255}).passed);
  EXPECT_FALSE(compare_images(grey(10, 10, 0), grey(20, 5, 0), {255, 1, 255}).passed);
  EXPECT_FALSE(compare_images({}, {}, {255, 1, 255}).passed);
  EXPECT_EQ(compare_images({}, grey(1, 1, 0), {}).summary(), "the pictures differ in size");
}

TEST(CompareImages, NamesTheTenWorstInOrder) {
  Image actual = grey(10, 10, 90);
  for (int x = 0; x < 10; ++x) {
    channel(actual, x, 0, 0) = static_cast<std::uint8_t>(91 + x);
    channel(actual, x, 1, 0) = static_cast<std::uint8_t>(101 + x);
  }
  const auto result = compare_images(actual, grey(10, 10, 90), {});
  ASSERT_EQ(result.worst_pixels.size(), 10U);
  for (int i = 0; i < 10; ++i) {
    EXPECT_EQ(result.worst_pixels[static_cast<std::size_t>(i)].difference, 20 - i);
  }
}

}  // namespace
}  // namespace spool::render
