// The report as PDF, as Poppler reads it: every field is on paper, tables go on with their heads.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/ncr/ncr_pdf.h"

#include <algorithm>
#include <sstream>

#include <gtest/gtest.h>

#include "app/ncr/ncr_text.h"
#include "app/ncr/page_flow.h"
#include "tests/app/ncr/sample_ncr.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/write_file.h"

namespace spool::test {
namespace {

// Without what line breaks make of spaces.
std::string dense(const std::string& text) {
  std::string all;
  for (const char c : text)
    if (c != ' ' && c != '\n' && c != '\f') all += c;
  return all;
}

class NcrPdf : public ::testing::Test {
 protected:
  // Poppler's text, page by page, in the order of drawing.
  std::vector<std::string> pages_of(const ncr::NcrDocument& document) const {
    const auto bytes = ncr::ncr_pdf(document);
    EXPECT_TRUE(bytes);
    const auto pdf = write_file(folder_.path() / "report.pdf", *bytes);
    const std::string text = run("/usr/bin/pdftotext", {"-raw", pdf, "-"}).out;
    std::vector<std::string> pages;
    std::istringstream rest(text);
    for (std::string page; std::getline(rest, page, '\f');) pages.push_back(page);
    return pages;
  }
  TemporaryFolder folder_;
};

std::string joined(const std::vector<std::string>& pages) {
  std::string all;
  for (const std::string& each : pages) all += each;
  return dense(all);
}

int count_of(const std::string& text, const std::string& what) {
  int count = 0;
  for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++count;
  return count;
}

#define NEEDS_POPPLER()                               \
  if (!std::filesystem::exists("/usr/bin/pdftotext")) \
  GTEST_SKIP() << "pdftotext (poppler-utils) is not there"

TEST_F(NcrPdf, HoldsEveryFieldAndAllOfTheEvidence) {
  NEEDS_POPPLER();
  const ncr::NcrDocument document = sample_ncr();
  const std::string text = joined(pages_of(document));
  for (const ncr::FormField& each : document.form) {
    EXPECT_NE(text.find(dense(each.label)), std::string::npos) << each.label;
    const std::string value = (each.kind == ncr::FieldKind::kChoice ? "X" : "") + dense(each.value);
    EXPECT_NE(text.find(value), std::string::npos) << each.key << ": " << value << "\n" << text;
  }
  for (const ncr::Feature& each : document.evidence.features)
    for (const std::string& cell : {each.name, each.reason})
      EXPECT_NE(text.find(dense(cell)), std::string::npos) << cell;
  for (const char* each : {"506.1 mm", "+6.1 mm", "1.0 mm", "3.0 mm", "PFI ES-3 2.2", "0.001",
                           "90.00°", "overlay_1.png: seen from +x -y +z", "JCGM 106", "pfi-es3",
                           "flange-1: H42", "W1, W2", "Turn W1 by 90° & tack again.", "Out"})
    EXPECT_NE(text.find(dense(each)), std::string::npos) << each;
}

TEST_F(NcrPdf, MarksWhatIsToBeFilledIn) {
  NEEDS_POPPLER();
  ncr::NcrDocument document;
  document.form = ncr::empty_form();
  ncr::set_number("J-S-NCR-001", document);
  const auto pages = pages_of(document);
  const auto empty =
      std::count_if(document.form.begin(), document.form.end(), [](const auto& each) {
        return each.value.empty() && each.kind != ncr::FieldKind::kSignature;
      });
  EXPECT_EQ(count_of(pages.at(0), "to be filled in"), empty);
  EXPECT_NE(pages.at(0).find("Design engineer (if applicable)"), std::string::npos)
      << "the form takes one page";
}

TEST_F(NcrPdf, LongTablesRepeatTheirHeadOnEveryPageAndKeepRowsWhole) {
  NEEDS_POPPLER();
  const ncr::NcrDocument document = sample_ncr(60);
  const auto pages = pages_of(document);
  int with_rows = 0;
  for (const std::string& page : pages) {
    const int rows = count_of(page, "Off by 6.1 mm, feature ");
    if (rows == 0) continue;
    ++with_rows;
    EXPECT_EQ(count_of(page, "U (k = 2)"), 1) << page;
    EXPECT_EQ(count_of(dense(page), "(face_to_face)"), rows) << "a row is torn\n" << page;
  }
  EXPECT_GT(with_rows, 2);
  for (const ncr::Feature& each : document.evidence.features)
    EXPECT_NE(joined(pages).find(dense(each.name)), std::string::npos) << each.name;
  EXPECT_NE(pages.back().find("page " + std::to_string(pages.size()) + " of " +
                              std::to_string(pages.size())),
            std::string::npos);
}

TEST_F(NcrPdf, ALongDescriptionGoesOnOnTheNextPage) {
  NEEDS_POPPLER();
  ncr::NcrDocument document = sample_ncr();
  const auto word = [](int k) { return "word" + std::to_string(1000 + k); };
  std::string text;
  for (int k = 0; k < 900; ++k) text += word(k) + (k % 60 == 59 ? "\n" : " ");
  ncr::field(document.form, "description.text")->value = text;
  const auto pages = pages_of(document);
  const std::string all = joined(pages);
  for (int k = 0; k < 900; ++k)
    ASSERT_EQ(count_of(all, word(k)), 1) << "word " << k << " is lost or cut";
}

TEST_F(NcrPdf, NothingIsDrawnOffThePage) {
  // Ink in the margin of any page: wide words are broken, not run out of the paper.
  for (const auto& page : ncr::ncr_pages(sample_ncr(12))) {
    const auto image = isometric::draw_page(page, 50.8, ncr::kA4);  // 2 px a millimetre
    ASSERT_TRUE(image);
    for (int y = 0; y < image->height; ++y) {
      for (int x = 0; x < image->width; ++x) {
        if (image->pixel(x, y)[0] >= 128) continue;
        ASSERT_TRUE(x >= 2 * 11 && x <= 2 * 199 && y >= 2 * 10 && y <= 2 * 291) << x << " " << y;
      }
    }
  }
}

TEST_F(NcrPdf, IsTheSameFileEveryTime) {
  const auto one = ncr::ncr_pdf(sample_ncr()), other = ncr::ncr_pdf(sample_ncr());
  ASSERT_TRUE(one);
  EXPECT_EQ(*one, *other);
}

}  // namespace
}  // namespace spool::test
