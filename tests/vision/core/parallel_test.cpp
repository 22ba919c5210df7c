// Laws of the data-parallel loops: every index once, sums the same to the last bit.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/core/parallel.h"

#include <atomic>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace spool {
namespace {

TEST(ParallelChunks, VisitsEveryIndexOnceInChunksOfTheGrain) {
  for (const std::size_t count : {0UL, 1UL, 7UL, 64UL, 1000UL, 12345UL})
    for (const std::size_t grain : {1UL, 7UL, 64UL, 100000UL}) {
      std::vector<std::atomic<int>> visits(count);
      parallel_chunks(count, grain, [&](std::size_t begin, std::size_t end) {
        ASSERT_LT(begin, end);
        ASSERT_EQ(begin % grain, 0U);
        ASSERT_TRUE(end - begin == grain || end == count);
        for (std::size_t i = begin; i < end; ++i) ++visits[i];
      });
      for (const auto& visit : visits) ASSERT_EQ(visit, 1);
    }
}

TEST(ParallelSum, IsTheSameToTheLastBitEveryTime) {
  std::mt19937 random{1};
  std::uniform_real_distribution<double> exponent(-12, 12);
  std::vector<double> numbers(100000);
  for (double& number : numbers)
    number = std::pow(10.0, exponent(random)) * (random() % 2 == 0 ? 1 : -1);
  constexpr std::size_t kGrain = 512;
  const auto sum_of = [&](std::size_t begin, std::size_t end) {
    double sum = 0;
    for (std::size_t i = begin; i < end; ++i) sum += numbers[i];
    return sum;
  };
  double serial = 0;  // the same chunks in the same order, one after the other
  for (std::size_t begin = 0; begin < numbers.size(); begin += kGrain)
    serial += sum_of(begin, std::min(begin + kGrain, numbers.size()));
  for (int i = 0; i < 50; ++i) ASSERT_EQ(parallel_sum(numbers.size(), kGrain, 0.0, sum_of), serial);
}

TEST(ParallelSum, OfNothingIsTheZero) {
  EXPECT_EQ(parallel_sum(0, 16, 42, [](std::size_t, std::size_t) { return 1; }), 42);
}

TEST(ParallelSum, AddsTheZeroOnce) {
  EXPECT_EQ(parallel_sum(
                100, 7, 0,
                [](std::size_t begin, std::size_t end) { return static_cast<int>(end - begin); }),
            100);
}

}  // namespace
}  // namespace spool
