// Claims of the queue that loses nothing.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/runner/command_queue.h"

#include <array>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace spool {
namespace {

using std::chrono::milliseconds;

TEST(CommandQueue, KeepsOrder) {
  CommandQueue<int> queue;
  EXPECT_TRUE(queue.push(1));
  EXPECT_TRUE(queue.push(2));
  EXPECT_EQ(queue.try_pop(), 1);
  EXPECT_EQ(queue.pop(milliseconds(0)), 2);
  EXPECT_EQ(queue.pop(milliseconds(1)), std::nullopt);
}

TEST(CommandQueue, HandsOutEverythingAfterClosingAndTakesNothingMore) {
  CommandQueue<int> queue;
  EXPECT_TRUE(queue.push(1));
  queue.close();
  EXPECT_FALSE(queue.push(2));
  EXPECT_FALSE(queue.is_finished());
  EXPECT_EQ(queue.pop(milliseconds(0)), 1);
  EXPECT_TRUE(queue.is_finished());
  EXPECT_EQ(queue.pop(milliseconds(10000)), std::nullopt);  // at once: nothing can come
}

TEST(CommandQueue, LosesNothingBetweenThreeGiversAndOneTaker) {
  CommandQueue<std::pair<int, int>> queue;
  constexpr int kEach = 3000;
  constexpr int kGivers = 3;
  std::array<int, kGivers> next{};
  {
    std::vector<std::jthread> givers;
    for (int giver = 0; giver < kGivers; ++giver) {
      givers.emplace_back([&queue, giver] {
        for (int i = 0; i < kEach; ++i) ASSERT_TRUE(queue.push({giver, i}));
      });
    }
    for (int taken = 0; taken < kGivers * kEach; ++taken) {
      const auto value = queue.pop(milliseconds(10000));
      ASSERT_TRUE(value.has_value());
      EXPECT_EQ(value->second, next[static_cast<std::size_t>(value->first)]++);
    }
  }
  EXPECT_EQ(queue.try_pop(), std::nullopt);
}

}  // namespace
}  // namespace spool
