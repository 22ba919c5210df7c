// Tests of Result: a value or the one sentence.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/core/result.h"

#include <memory>

#include <gtest/gtest.h>

namespace spool {
namespace {

Result<int> half(int x) {
  if (x % 2 != 0) return Error{ErrorCode::kBadInput, "3: is odd; give an even number"};
  return x / 2;
}

TEST(Result, HoldsAValueOrAnError) {
  EXPECT_TRUE(half(4));
  EXPECT_EQ(*half(4), 2);
  const auto odd = half(3);
  ASSERT_FALSE(odd);
  EXPECT_FALSE(odd.has_value());
  EXPECT_EQ(odd.error().code, ErrorCode::kBadInput);
  EXPECT_EQ(odd.error().message, "3: is odd; give an even number");
}

TEST(ErrorCode, IsTheExitCodeOfThePrograms) {
  EXPECT_EQ(exit_code(ErrorCode::kIo), 74);
  EXPECT_EQ(exit_code(ErrorCode::kUsage), 64);
  EXPECT_EQ(exit_code(ErrorCode::kBadInput), 65);
  EXPECT_EQ(exit_code(ErrorCode::kNoDevice), 69);
  EXPECT_EQ(exit_code(ErrorCode::kInternal), 70);
}

TEST(Result, GivesAwayWhatCanOnlyMove) {
  Result<std::unique_ptr<int>> made(std::make_unique<int>(7));
  ASSERT_TRUE(made);
  const std::unique_ptr<int> taken = *std::move(made);
  EXPECT_EQ(*taken, 7);
}

TEST(Status, IsSuccessUnlessAnErrorIsGiven) {
  EXPECT_TRUE(Status{});
  const Status failed = Error{ErrorCode::kIo, "x: disk full"};
  ASSERT_FALSE(failed);
  EXPECT_EQ(failed.error().message, "x: disk full");
}

}  // namespace
}  // namespace spool
