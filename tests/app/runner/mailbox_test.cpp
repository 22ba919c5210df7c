// Claims of the newest-wins mailbox.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/runner/mailbox.h"

#include <memory>
#include <thread>

#include <gtest/gtest.h>

namespace spool {
namespace {

using std::chrono::milliseconds;

TEST(Mailbox, KeepsOnlyTheNewest) {
  Mailbox<int> mailbox;
  mailbox.put(1);
  mailbox.put(2);
  EXPECT_EQ(mailbox.try_take(), 2);
  EXPECT_EQ(mailbox.try_take(), std::nullopt);
}

TEST(Mailbox, TimesOutWhenNothingComes) {
  Mailbox<int> mailbox;
  EXPECT_EQ(mailbox.take(milliseconds(5)), std::nullopt);
}

TEST(Mailbox, CarriesMoveOnlyValues) {
  Mailbox<std::unique_ptr<int>> mailbox;
  mailbox.put(std::make_unique<int>(7));
  const auto taken = mailbox.take(milliseconds(0));
  ASSERT_TRUE(taken.has_value());
  EXPECT_EQ(**taken, 7);
}

TEST(Mailbox, ClosingWakesAWaiterAndRefusesWhatComesLater) {
  Mailbox<int> mailbox;
  std::jthread closer([&] { mailbox.close(); });
  EXPECT_EQ(mailbox.take(milliseconds(10000)), std::nullopt);
  mailbox.put(3);
  EXPECT_EQ(mailbox.try_take(), std::nullopt);
  EXPECT_TRUE(mailbox.is_closed());
}

TEST(Mailbox, HandsOutWhatLayThereWhenItWasClosed) {
  Mailbox<int> mailbox;
  mailbox.put(4);
  mailbox.close();
  EXPECT_EQ(mailbox.take(milliseconds(0)), 4);
}

TEST(Mailbox, NeverGoesBackwardsBetweenTwoThreads) {
  Mailbox<int> mailbox;
  constexpr int kLast = 20000;
  std::jthread giver([&] {
    for (int i = 1; i <= kLast; ++i) mailbox.put(i);
  });
  int newest = 0;
  while (newest < kLast) {
    const auto taken = mailbox.take(milliseconds(10000));
    ASSERT_TRUE(taken.has_value()) << "the last value was lost";
    ASSERT_GT(*taken, newest);
    newest = *taken;
  }
}

}  // namespace
}  // namespace spool
