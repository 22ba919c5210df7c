// Claims about a text that is typed: shift, limits, lines, blanks.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/application/typing_session.h"

#include <gtest/gtest.h>

namespace spool {
namespace {

using End = TypingSession::End;
using Kind = ui::KeyPress::Kind;

TEST(TypingSession, BeginsACapitalAndGoesOnSmall) {
  TypingSession typing;
  typing.start({.label = "Name"});
  EXPECT_TRUE(typing.state().is_shifted);
  typing.type(U'É');
  EXPECT_FALSE(typing.state().is_shifted);
  EXPECT_EQ(typing.press(ui::KeyRole::kShift), End::kNone);
  EXPECT_TRUE(typing.state().is_shifted);
  typing.start({.label = "Name", .text = "there already"});
  EXPECT_FALSE(typing.state().is_shifted);
}

TEST(TypingSession, RefusesWhatHasNoRoomAndSaysSo) {
  TypingSession typing;
  typing.start({.label = "Name", .help = "help", .most_bytes = 3});
  typing.type(U'é');
  typing.type(U'é');  // two bytes, and one is left
  EXPECT_EQ(typing.text(), "é");
  EXPECT_EQ(typing.state().help, "no room for more");
  typing.type(U'a');
  EXPECT_EQ(typing.text(), "éa");
  EXPECT_EQ(typing.state().help, "help");
}

TEST(TypingSession, EndsALineOrBeginsOne) {
  TypingSession typing;
  typing.start({.label = "Name", .text = "  a "});
  typing.type(U'\t');
  EXPECT_EQ(typing.press({Kind::kEnter, 0}), End::kDone);
  EXPECT_EQ(typing.text(), "a") << "no blanks about it, no control letters";
  typing.start({.label = "Text", .text = "a", .many_lines = true});
  EXPECT_EQ(typing.press({Kind::kEnter, 0}), End::kNone);
  typing.type(U'b');
  EXPECT_EQ(typing.text(), "a\nb");
  EXPECT_EQ(typing.press({Kind::kEscape, 0}), End::kCancelled);
  EXPECT_EQ(typing.press(ui::KeyRole::kDone), End::kDone);
}

}  // namespace
}  // namespace spool
