// Claims about the keyboard on the glass: large, whole, apart, on every screen.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/ui/keyboard.h"

#include <set>

#include <gtest/gtest.h>

namespace spool::ui {
namespace {

struct Window {
  const char* name;
  double width, height, dots_per_inch;
};

// The last is narrower than ten keys.
constexpr Window kWindows[] = {{"tablet", 1280, 800, 150},
                               {"7 inch panel", 800, 480, 133},
                               {"portrait", 800, 1280, 150},
                               {"phone", 2340, 1080, 400},
                               {"upright phone", 1080, 2340, 400}};
constexpr KeyPage kPages[] = {KeyPage::kLetters, KeyPage::kDigits, KeyPage::kAccents};

TEST(Keyboard, EveryKeyIsAThumbWideApartFromItsNeighboursAndOnTheScreen) {
  for (const Window& window : kWindows)
    for (const KeyPage page : kPages) {
      SCOPED_TRACE(window.name);
      const double dp = pixels_per_dp(window.dots_per_inch);
      const auto keys = lay_out_keys({0, 0, window.width, window.height}, dp, page, false);
      double top = window.height;
      for (std::size_t i = 0; i < keys.size(); ++i) {
        const Rect& a = keys[i].rect;
        EXPECT_GE(a.width, kTargetDp * dp - 0.01) << keys[i].name;
        EXPECT_GE(a.height, kTargetDp * dp - 0.01) << keys[i].name;
        EXPECT_GE(a.x, 0);
        EXPECT_LE(a.x + a.width, window.width + 0.01) << keys[i].name;
        EXPECT_LE(a.y + a.height, window.height + 0.01) << keys[i].name;
        top = std::min(top, a.y);
        for (std::size_t j = i + 1; j < keys.size(); ++j) {
          const Rect& b = keys[j].rect;
          EXPECT_FALSE(a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height &&
                       b.y < a.y + a.height)
              << keys[i].name << " and " << keys[j].name;
        }
      }
      EXPECT_GE(top, kTargetDp * dp) << "what is typed stands above";
    }
}

TEST(Keyboard, HasLettersDigitsAndAccentsSmallAndCapital) {
  std::set<char32_t> there;
  for (const KeyPage page : kPages)
    for (const bool is_shifted : {false, true})
      for (const Key& key : lay_out_keys({0, 0, 800, 480}, 1, page, is_shifted))
        if (key.role == KeyRole::kLetter) there.insert(key.letter);
  for (const char32_t letter : std::u32string(
           U"abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789 .,-_/'\"#éèàù"
           U"çñÉÈÀÙÇÑäöüßÄÖÜøåØÅœŒ"))
    EXPECT_TRUE(there.contains(letter)) << utf8(letter);
}

TEST(Keyboard, EveryPageLeadsToTheOthersAndOut) {
  for (const KeyPage page : kPages) {
    std::set<KeyRole> roles;
    for (const Key& key : lay_out_keys({0, 0, 800, 480}, 1, page, false)) roles.insert(key.role);
    for (const KeyRole role :
         {KeyRole::kShift, KeyRole::kBackspace, KeyRole::kCancel, KeyRole::kDone})
      EXPECT_TRUE(roles.contains(role));
    EXPECT_EQ(roles.contains(KeyRole::kLettersPage), page != KeyPage::kLetters);
    EXPECT_EQ(roles.contains(KeyRole::kDigitsPage), page != KeyPage::kDigits);
    EXPECT_EQ(roles.contains(KeyRole::kAccentsPage), page != KeyPage::kAccents);
  }
}

TEST(Keyboard, WritesAndTakesBackWholeLetters) {
  std::string text;
  for (const char32_t letter : {U'a', U'é', U'ł', U'–', U'😀'}) text += utf8(letter);
  EXPECT_EQ(text, "aéł–😀");
  for (const char* left : {"aéł–", "aéł", "aé", "a", "", ""}) {
    drop_last_letter(text);
    EXPECT_EQ(text, left);
  }
  EXPECT_EQ(utf8(0xD800), "") << "half a letter";
  EXPECT_EQ(utf8(0x110000), "");
}

}  // namespace
}  // namespace spool::ui
