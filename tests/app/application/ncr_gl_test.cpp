// The form of a non-conformance report filled in on the screen and written.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "app/common/json_file.h"
#include "tests/app/application/evidence_bench.h"
#include "tests/support/process.h"

namespace spool {
namespace {

namespace fs = std::filesystem;
using Kind = ui::KeyPress::Kind;
using test::FullDisk;

class NcrOnScreen : public test::EvidenceOnScreen {
 protected:
  // The form of the first capture, on its first page.
  void open_form(int width = 800, int height = 480) {
    ASSERT_NO_FATAL_FAILURE(open(2, "operator 1", width, height));
    ASSERT_NO_FATAL_FAILURE(align());
    check();
    ASSERT_NO_FATAL_FAILURE(reach_form());
  }
  void reach_form() {
    press("More");
    press("Evidence");
    press("Capture 1");
    press("NCR");
    step();
    ASSERT_EQ(screen_["screen"], "ncr") << screen_.dump();
  }
  void type_unicode(const std::u32string& text) {
    std::vector<ui::KeyPress> keys;
    for (const char32_t letter : text) keys.push_back({Kind::kLetter, letter});
    step({}, keys);
  }
  // By the glass alone.
  void say_shop() {
    press(kShop);
    type("S");
    press("Key digits");
    press("Key 1");
    press("Done");
  }
  // Turns pages until the target is on the screen.
  void turn_to(const std::string& name) {
    for (int i = 0; i < 20 && !offers(name) && offers("Next"); ++i) press("Next");
    ASSERT_TRUE(offers(name)) << name << " is on no page: " << screen_.dump();
  }
  void write() {
    press("Write");
    for (int i = 0; i < 3; ++i) step();
  }
  [[nodiscard]] std::string hint() const { return screen_["hint"]; }
  [[nodiscard]] std::string pdf_text(const std::string& number) const {
    const auto text = test::run("/usr/bin/pdftotext",
                                {"-layout", path_ / "ncr" / number / (number + ".pdf"), "-"});
    EXPECT_EQ(text.code, 0) << text.err;
    return text.out;
  }
  static constexpr const char* kShop = "Shop (part of the number)";
};

TEST_F(NcrOnScreen, IsFilledInByTapsWrittenAndNumbered) {
  ASSERT_NO_FATAL_FAILURE(open_form());
  expect_thumbs();
  write();
  EXPECT_NE(hint().find("shop"), std::string::npos) << "there is no number without: " << hint();
  say_shop();
  press("Shop / Field construction: Shop");
  ASSERT_NO_FATAL_FAILURE(turn_to("Issued to"));
  expect_thumbs();
  press("Issued to");
  expect_thumbs();
  type("Pipe");
  press("Key accents");
  press("Key ç");
  press("Key letters");
  press("Key space");
  press("Key shift");
  press("Key Q");
  press("Done");
  ASSERT_NO_FATAL_FAILURE(turn_to("Check one: Rework"));
  expect_thumbs();
  press("Check one: Rework");
  ASSERT_NO_FATAL_FAILURE(turn_to("What led to it"));
  press("What led to it");
  // A long one, with accents, from a real keyboard.
  std::u32string cause;
  for (int i = 0; i < 30; ++i) cause += U"mal interprété ñ ";
  type_unicode(cause);
  step({}, {{Kind::kEnter, 0}});
  type_unicode(U"second line");
  press("Done");
  write();
  EXPECT_NE(hint().find("bracket-S1-NCR-001 is written"), std::string::npos) << hint();
  for (const char* ending : {".pdf", ".html", ".json", ".bcfzip"})
    EXPECT_TRUE(
        fs::exists(path_ / "ncr/bracket-S1-NCR-001" / (std::string("bracket-S1-NCR-001") + ending)))
        << ending;
  const std::string text = pdf_text("bracket-S1-NCR-001");
  for (const char* word : {"Pipeç Q", "interprété ñ", "second line", "operator 1"})
    EXPECT_NE(text.find(word), std::string::npos) << word << " is not in:\n" << text;
  const auto json = read_json(path_ / "ncr/bracket-S1-NCR-001/bracket-S1-NCR-001.json");
  ASSERT_TRUE(json);
  EXPECT_NE(json->dump().find("\"Rework\""), std::string::npos);
  EXPECT_FALSE(offers("Write")) << "nobody writes one twice by a second tap";
  // Another on the same capture has the next number, and nothing of the first.
  press("Back");
  press("NCR");
  step();
  write();
  EXPECT_NE(hint().find("bracket-S1-NCR-002 is written"), std::string::npos) << hint();
  EXPECT_EQ(pdf_text("bracket-S1-NCR-002").find("Pipeç Q"), std::string::npos);
  expect_intact();
}

TEST_F(NcrOnScreen, KeepsWhatWasFilledInWhereTheDiskFails) {
  ASSERT_NO_FATAL_FAILURE(open_form());
  say_shop();
  ASSERT_NO_FATAL_FAILURE(turn_to("Issued to"));
  press("Issued to");
  type("Kept");
  press("Done");
  {
    const FullDisk full(3000);
    write();
    EXPECT_NE(hint().find("is kept"), std::string::npos) << hint();
    EXPECT_NE(hint().find("disk"), std::string::npos) << hint();
  }
  write();
  EXPECT_NE(hint().find("bracket-S1-NCR-001 is written"), std::string::npos)
      << "no number was used up: " << hint();
  EXPECT_NE(pdf_text("bracket-S1-NCR-001").find("Kept"), std::string::npos);
  expect_intact();
}

TEST_F(NcrOnScreen, ADraftOutlivesTheProgramAndIsNoAlteration) {
  ASSERT_NO_FATAL_FAILURE(open_form());
  press(kShop);
  type("S");
  press("Key accents");
  press("Key é");
  press("Done");
  EXPECT_NE(hint().find("A-Z"), std::string::npos) << "no such number: " << hint();
  say_shop();
  ASSERT_NO_FATAL_FAILURE(turn_to("Issued to"));
  press("Issued to");
  type("Later");
  press("Done");
  press("Back");
  press("Back");
  press("Back");
  EXPECT_EQ(screen_["screen"], "work");
  step();
  ASSERT_NO_FATAL_FAILURE(expect_intact());
  const auto verified = evidence::verify_job(path_, {});
  ASSERT_TRUE(verified);
  bool is_named = false;
  for (const std::string& note : verified->notes)
    is_named = is_named || note.find("ncr/draft-000001.json") != std::string::npos;
  EXPECT_TRUE(is_named);
  ASSERT_NO_FATAL_FAILURE(open(0));
  ASSERT_NO_FATAL_FAILURE(align());
  ASSERT_NO_FATAL_FAILURE(reach_form());
  write();
  EXPECT_NE(hint().find("bracket-S1-NCR-001 is written"), std::string::npos) << hint();
  EXPECT_NE(pdf_text("bracket-S1-NCR-001").find("Later"), std::string::npos);
  EXPECT_FALSE(fs::exists(path_ / "ncr/draft-000001.json")) << "it is written";
  expect_intact();
}

}  // namespace
}  // namespace spool
