// The report as HTML: every text is there, and none of it is markup.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/ncr/ncr_html.h"

#include <gtest/gtest.h>

#include "app/evidence/html_parts.h"
#include "tests/app/ncr/sample_ncr.h"

namespace spool::test {
namespace {

bool holds(const std::string& text, const std::string& what) {
  return text.find(what) != std::string::npos;
}

TEST(NcrHtml, HoldsEveryFieldMasked) {
  const ncr::NcrDocument document = sample_ncr();
  const std::string html = ncr::ncr_html(document);
  for (const ncr::FormField& each : document.form) {
    EXPECT_TRUE(holds(html, evidence::escaped(each.label))) << each.label;
    if (each.kind == ncr::FieldKind::kChoice) {
      EXPECT_TRUE(holds(html, "&#9746; " + evidence::escaped(each.value))) << each.key;
    } else {
      const std::string line = each.value.substr(0, each.value.find('\n'));
      EXPECT_TRUE(holds(html, evidence::escaped(line))) << each.key;
    }
  }
  EXPECT_TRUE(holds(html, "<br>second line"));
  EXPECT_FALSE(holds(html, "<b>\"A&B\""));
  EXPECT_FALSE(holds(html, "<w>"));
  EXPECT_FALSE(holds(html, "L<1>"));
  for (const ncr::Feature& each : document.evidence.features)
    EXPECT_TRUE(holds(html, evidence::escaped(each.name)));
  EXPECT_TRUE(holds(html, "U (k = 2)"));
  EXPECT_TRUE(holds(html, "1.0 mm")) << "U is k times u";
  EXPECT_TRUE(holds(html, "PFI ES-3 2.2"));
  EXPECT_TRUE(holds(html, "JCGM 106"));
}

TEST(NcrHtml, IsOneFile) {
  const std::string html = ncr::ncr_html(sample_ncr());
  EXPECT_FALSE(holds(html, "http"));
  EXPECT_FALSE(holds(html, "src=\"overlay"));
  EXPECT_TRUE(holds(html, "src=\"data:image/png;base64,iVBOR"));
}

TEST(NcrHtml, SaysWhatIsToBeFilledIn) {
  ncr::NcrDocument document = sample_ncr();
  EXPECT_TRUE(holds(ncr::ncr_html(document), "to be filled in")) << "signatures are";
  for (ncr::FormField& each : document.form) each.value = "said";
  EXPECT_FALSE(holds(ncr::ncr_html(document), "to be filled in"));
}

}  // namespace
}  // namespace spool::test
