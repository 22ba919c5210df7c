// The helper of golden pictures: what it passes, refuses and leaves behind.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/render/golden.h"

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"
#include "vision/core/file_io.h"

namespace spool::test {
namespace {

class Golden : public ::testing::Test {
 protected:
  void SetUp() override { allow(R"({"a": {}})"); }
  void allow(const char* json) {
    ASSERT_TRUE(write_file_whole(folder_.path() / "goldens.json", json));
  }
  GoldenResult check(const render::Image& image, bool update = false) {
    return check_golden(folder_.path(), folder_.path() / "report", "a", image, update);
  }
  [[nodiscard]] bool left(const char* file) const {
    return std::filesystem::exists(folder_.path() / "report" / file);
  }
  static render::Image grey(int side, std::uint8_t level) {
    return {side, side,
            std::vector<std::uint8_t>(4 * static_cast<std::size_t>(side * side), level)};
  }
  TemporaryFolder folder_;
};

TEST_F(Golden, PassesWhatItWasUpdatedTo) {
  ASSERT_TRUE(check(grey(8, 100), true).passed);
  EXPECT_TRUE(check(grey(8, 100)).passed);
  EXPECT_FALSE(left("a-actual.png"));
}

TEST_F(Golden, LeavesThreePicturesAndTheNumbersWhenItFails) {
  ASSERT_TRUE(check(grey(8, 100), true).passed);
  const GoldenResult result = check(grey(8, 130));
  EXPECT_FALSE(result.passed);
  EXPECT_NE(result.text.find("worst 30 of 255"), std::string::npos) << result.text;
  EXPECT_TRUE(left("a-actual.png") && left("a-expected.png") && left("a-difference.png"));
}

TEST_F(Golden, RefusesAMissingPictureAndSaysWhichFile) {
  const GoldenResult result = check(grey(8, 100));
  EXPECT_FALSE(result.passed);
  EXPECT_NE(result.text.find("a.png"), std::string::npos) << result.text;
  EXPECT_TRUE(left("a-actual.png"));
}

TEST_F(Golden, RefusesAnotherSize) {
  ASSERT_TRUE(check(grey(8, 100), true).passed);
  const GoldenResult result = check(grey(9, 100));
  EXPECT_FALSE(result.passed);
  EXPECT_NE(result.text.find("differ in size"), std::string::npos);
}

TEST_F(Golden, RefusesLooserLimitsWithoutAReason) {
  ASSERT_TRUE(check(grey(8, 100), true).passed);
  allow(R"({"a": {"max_abs_diff": 50, "max_mean": 50}})");
  EXPECT_FALSE(check(grey(8, 100)).passed);
  allow(R"({"a": {"max_abs_diff": 50, "max_mean": 50, "reason": "the test of this"}})");
  EXPECT_TRUE(check(grey(8, 130)).passed);
}

TEST_F(Golden, RefusesANameThatIsNotListed) {
  allow("{}");
  EXPECT_FALSE(check(grey(8, 100), true).passed);
}

}  // namespace
}  // namespace spool::test
