// What is kept of a sensor's last seconds: every bit, of so many seconds and bytes.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/sensor/frame_ring.h"

#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace spool::sensor {
namespace {

DepthFrame frame_of(std::vector<std::uint16_t> depth, int width, double seconds = 0) {
  DepthFrame frame{.index = 3, .seconds = seconds, .width = width};
  frame.height = static_cast<int>(depth.size()) / width;
  frame.depth = std::move(depth);
  return frame;
}

// A slanted plane with noise and holes, as sensors see one.
DepthFrame plane(int width, int height, double seconds) {
  std::mt19937 random{3};
  std::normal_distribution<double> noise(0, 1.5);
  std::bernoulli_distribution hole(0.002);
  std::vector<std::uint16_t> depth;
  int left = 0;  // of a hole
  for (int i = 0; i < width * height; ++i) {
    if (hole(random)) left = 20;
    const double z = 900 + 0.5 * (i % width) + noise(random);
    depth.push_back(left-- > 0 ? std::uint16_t{0} : static_cast<std::uint16_t>(z));
  }
  return frame_of(std::move(depth), width, seconds);
}

TEST(PackedDepth, GivesEveryPictureBackBitForBit) {
  std::mt19937 random{9};
  std::vector<std::uint16_t> noise, extremes;
  for (int i = 0; i < 64; ++i) {
    noise.push_back(static_cast<std::uint16_t>(random()));
    extremes.push_back(i % 3 == 0 ? std::uint16_t{65535} : static_cast<std::uint16_t>(i % 3 - 1));
  }
  struct Case {
    const char* name;
    DepthFrame frame;
  };
  for (const Case& each :
       {Case{"zeros", frame_of(std::vector<std::uint16_t>(64, 0), 8)},
        Case{"one value", frame_of(std::vector<std::uint16_t>(64, 1234), 8)},
        Case{"noise", frame_of(noise, 8)}, Case{"extremes", frame_of(extremes, 8)},
        Case{"one pixel", frame_of({65535}, 1)}, Case{"plane", plane(64, 48, 0.25)}}) {
    SCOPED_TRACE(each.name);
    const DepthFrame back = unpack(pack(each.frame));
    EXPECT_EQ(back.depth, each.frame.depth);
    EXPECT_EQ(back.width, each.frame.width);
    EXPECT_EQ(back.height, each.frame.height);
    EXPECT_EQ(back.index, each.frame.index);
    EXPECT_EQ(back.seconds, each.frame.seconds);
  }
}

TEST(PackedDepth, TakesLessThanHalf) {
  const DepthFrame frame = plane(640, 480, 0);
  EXPECT_LT(pack(frame).bytes.size(), frame.depth.size());  // of two bytes a pixel
}

TEST(FrameRing, KeepsTheLastSecondsInOrder) {
  FrameRing ring({.seconds = 2});
  for (int i = 0; i < 300; ++i) ring.add(plane(16, 12, i / 30.0));
  const auto kept = ring.frames();
  ASSERT_EQ(kept.size(), 61U);
  EXPECT_NEAR(kept.front()->seconds, 299 / 30.0 - 2, 1e-9);
  for (std::size_t i = 1; i < kept.size(); ++i) EXPECT_GT(kept[i]->seconds, kept[i - 1]->seconds);
}

TEST(FrameRing, KeepsToItsMemoryAndItsNumber) {
  const std::size_t one = pack(plane(16, 12, 0)).bytes.size();
  FrameRing tight({.seconds = 10, .bytes = 5 * one + one / 2});
  FrameRing few({.seconds = 10, .frames = 7});
  for (int i = 0; i < 100; ++i) {
    tight.add(plane(16, 12, i / 30.0));
    few.add(plane(16, 12, 1.0));  // a clock that stands
  }
  EXPECT_EQ(tight.frames().size(), 5U);
  EXPECT_EQ(few.frames().size(), 7U);
}

TEST(FrameRing, BeginsAnewWhereTheClockGoesBackAndTakesNoBrokenFrame) {
  FrameRing ring;
  for (int i = 0; i < 10; ++i) ring.add(plane(16, 12, 5 + i / 30.0));
  ring.add(plane(16, 12, 0.5));
  ring.add(plane(16, 12, std::numeric_limits<double>::quiet_NaN()));
  ring.add(DepthFrame{.width = 16, .height = 12});
  ASSERT_EQ(ring.frames().size(), 1U);
  EXPECT_EQ(ring.frames().front()->seconds, 0.5);
}

}  // namespace
}  // namespace spool::sensor
