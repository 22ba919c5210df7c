// Lengths read as a fitter writes them.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/common/length_text.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace spool {
namespace {

constexpr double kInch = 0.0254;

TEST(LengthText, SpeaksMillimetresToATenth) {
  EXPECT_EQ(length_text(0.0046, LengthStyle::kMillimetre), "4.6 mm");
  EXPECT_EQ(length_text(-0.0046, LengthStyle::kMillimetre), "-4.6 mm");
  EXPECT_EQ(signed_length_text(0.0046, LengthStyle::kMillimetre), "+4.6 mm");
  EXPECT_EQ(length_text(2.5, LengthStyle::kMillimetre), "2500.0 mm");
  EXPECT_EQ(length_text(-0.00001, LengthStyle::kMillimetre), "0.0 mm");
  EXPECT_EQ(signed_length_text(0.00001, LengthStyle::kMillimetre), "0.0 mm");
}

TEST(LengthText, SpeaksFeetInchesAndSixteenthsInLowestTerms) {
  const struct {
    double inches;
    const char* text;
  } cases[] = {
      {0, "0\""},          {1, "1\""},           {0.5, "1/2\""},
      {0.0625, "1/16\""},  {5.0 / 16, "5/16\""}, {3 + 3.0 / 8, "3 3/8\""},
      {12, "1' 0\""},      {12.5, "1' 1/2\""},   {38 + 5.0 / 16, "3' 2 5/16\""},
      {-2.25, "-2 1/4\""}, {11.99, "1' 0\""},  // rounds up through the foot
      {0.01, "<1/16\""},
  };
  for (const auto& [inches, text] : cases)
    EXPECT_EQ(length_text(inches * kInch, LengthStyle::kFeetInch), text) << inches;
  EXPECT_EQ(signed_length_text(0.5 * kInch, LengthStyle::kFeetInch), "+1/2\"");
  EXPECT_EQ(signed_length_text(0, LengthStyle::kFeetInch), "0\"");
}

TEST(LengthText, IsWithinHalfASixteenthOfTheLength) {
  for (int i = 1; i < 2000; ++i) {
    const double metres = 0.00037 * i;
    int feet = 0;
    double whole = 0;
    int numerator = 0;
    int denominator = 1;
    const std::string text = length_text(metres, LengthStyle::kFeetInch);
    std::string rest = text.substr(0, text.size() - 1);
    if (rest[0] == '<') continue;
    if (const auto mark = rest.find('\''); mark != std::string::npos) {
      feet = std::stoi(rest);
      rest = rest.substr(mark + 2);
    }
    if (const auto slash = rest.find('/'); slash != std::string::npos) {
      const auto space = rest.find(' ');
      if (space != std::string::npos) whole = std::stoi(rest);
      numerator = std::stoi(rest.substr(space == std::string::npos ? 0 : space + 1));
      denominator = std::stoi(rest.substr(slash + 1));
    } else {
      whole = std::stoi(rest);
    }
    const double inches = 12 * feet + whole + static_cast<double>(numerator) / denominator;
    EXPECT_LE(std::abs(inches * kInch - metres), kInch / 32 + 1e-12) << text << " for " << metres;
  }
}

TEST(LengthText, ShowsWhatIsNoNumberAsADash) {
  EXPECT_EQ(length_text(std::numeric_limits<double>::quiet_NaN(), LengthStyle::kMillimetre), "-");
  EXPECT_EQ(signed_length_text(std::numeric_limits<double>::infinity(), LengthStyle::kFeetInch),
            "-");
}

TEST(QuantityText, SaysLengthsInTheStyleAndAnglesInDegrees) {
  const double half_degree = 0.5 * std::acos(-1.0) / 180;
  EXPECT_EQ(quantity_text(half_degree, true, LengthStyle::kFeetInch), "0.50°");
  EXPECT_EQ(quantity_text(half_degree, true, LengthStyle::kMillimetre, true), "+0.50°");
  EXPECT_EQ(quantity_text(-half_degree, true, LengthStyle::kMillimetre, true), "-0.50°");
  EXPECT_EQ(quantity_text(0.0046, false, LengthStyle::kMillimetre, true), "+4.6 mm");
  EXPECT_EQ(quantity_text(0.0048, false, LengthStyle::kFeetInch), "3/16\"");
}

TEST(PercentText, NeverRoundsToAllOrNothing) {
  EXPECT_EQ(percent_text(0), "0 %");
  EXPECT_EQ(percent_text(0.001), "<1 %");
  EXPECT_EQ(percent_text(0.724), "72 %");
  EXPECT_EQ(percent_text(0.999), ">99 %");
  EXPECT_EQ(percent_text(1), "100 %");
}

}  // namespace
}  // namespace spool
