// report.html: everything inside, nothing from outside, nothing run.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <string>

#include <gtest/gtest.h>

#include "app/evidence/html_parts.h"
#include "app/evidence/writer.h"
#include "tests/app/evidence/sample_record.h"

namespace spool::evidence {
namespace {

OverlayPicture picture() {
  OverlayPicture one{"overlay_1.png", "seen from +x", {}};
  one.image.width = 2;
  one.image.height = 2;
  one.image.rgba.assign(16, 200);
  return one;
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(ReportHtml, RefersToNothingOutsideAndRunsNothing) {
  const std::string html = report_html(test::sample_record(), {picture(), picture()});
  for (const char* word : {"http:", "https:", "<script", "<link", "<iframe", "url(", "@import",
                           "srcset", "onload", "file:"})
    EXPECT_FALSE(contains(html, word)) << word;
  std::size_t pictures = 0;
  for (auto at = html.find("src=\""); at != std::string::npos; at = html.find("src=\"", at + 1)) {
    EXPECT_EQ(html.compare(at, 26, "src=\"data:image/png;base64"), 0);
    ++pictures;
  }
  EXPECT_EQ(pictures, 2U);
}

TEST(ReportHtml, HoldsThePictureItself) {
  const auto png = render::encode_png(picture().image);
  ASSERT_TRUE(png);
  EXPECT_TRUE(contains(report_html(test::sample_record(), {picture()}), base64(*png)));
}

TEST(ReportHtml, SaysStatusReasonPartsAndInputs) {
  auto record = test::sample_record();
  record.warnings = {"The unit was inferred."};
  const std::string html = report_html(record, {picture()});
  for (const std::string& text :
       {std::string("Can&#39;t tell"), std::string("Not seen"),
        std::string("Seen, but no dimension is judged."), std::string("base"), std::string("post"),
        std::string("too little was seen"), std::string("The unit was inferred."),
        std::string(64, 'a'), std::string(64, 'b'), std::string("three-point"),
        std::string("2.0 mm"), std::string("40 %"), std::string("4.0 mm, 6.0 mm, 5.0 mm")})
    EXPECT_TRUE(contains(html, text)) << text;
}

TEST(ReportHtml, SaysEveryDimensionWithItsDoubtAndRule) {
  auto record = test::sample_record();
  record.inspection.dimensions = test::sample_dimensions();
  record.inspection.datum = "base/face and the axis of the pipe on it";
  const std::string html = report_html(record, {picture()});
  for (const std::string& text :
       {std::string("base/face to post/centre"), std::string("506.1 mm"), std::string("+6.1 mm"),
        std::string("1.0 mm"), std::string("PFI ES-3 2.2"), std::string("90.00°"),
        std::string("nobody looked"), std::string("base/face and the axis")})
    EXPECT_TRUE(contains(html, text)) << text;
  // The worst first.
  EXPECT_LT(html.find("centre_to_face"), html.find("<td>angle"));
  EXPECT_FALSE(contains(report_html(test::sample_record(), {picture()}), "<h2>Dimensions"));
}

TEST(ReportHtml, PutsTheWorstPartFirst) {
  // suspicious outranks not_measured (ARCHITECTURE, Command lines), so "base" comes first; made
  // worse, "post" does.
  auto record = test::sample_record();
  std::string html = report_html(record, {});
  EXPECT_LT(html.find("<b>base</b>"), html.find("<b>post</b>"));
  record.inspection.parts[1].status = Verdict::kNotOk;
  html = report_html(record, {});
  EXPECT_GT(html.find("<b>base</b>"), html.find("<b>post</b>"));
}

TEST(ReportHtml, SpeaksFeetAndInchesWhenAsked) {
  auto record = test::sample_record();
  record.feet_inches = true;
  const std::string html = report_html(record, {});
  EXPECT_TRUE(contains(html, "1/16&quot;"));
  EXPECT_FALSE(contains(html, " mm<"));
}

TEST(ReportHtml, EscapesWhatComesFromFiles) {
  auto record = test::sample_record();
  record.scan.file = "<img src=x>.ply";
  record.warnings = {"<b>bold</b>"};
  record.datum = {"\"><script>"};
  const std::string html = report_html(record, {});
  EXPECT_FALSE(contains(html, "<img src=x>"));
  EXPECT_FALSE(contains(html, "<b>bold"));
  EXPECT_FALSE(contains(html, "<script"));
}

TEST(ReportHtml, SaysThatPicturesAreMissing) {
  EXPECT_TRUE(contains(report_html(test::sample_record(), {}), "No pictures"));
}

TEST(ReportHtml, SaysThatNothingWasFound) {
  auto record = test::sample_record();
  record.inspection.alignment.found = false;
  record.inspection.alignment.reason = "the three picks lie on a line";
  EXPECT_TRUE(contains(report_html(record, {}), "not found: the three picks lie on a line"));
}

}  // namespace
}  // namespace spool::evidence
