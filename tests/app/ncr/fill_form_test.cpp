// The form is filled in from job and report, and nothing is made up.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/ncr/fill_form.h"

#include <gtest/gtest.h>

#include "tests/app/ncr/sample_ncr.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/write_file.h"
#include "tests/vision/piping/pcf_samples.h"

namespace spool::test {
namespace {

class FillForm : public ::testing::Test {
 protected:
  Result<ncr::NcrDocument> fill(const ncr::OperatorInput& input) const {
    const auto pcf = write_file(folder_.path() / "line.pcf", spool_pcf());
    if (Status made = job::create_job(path_, {.design = pcf, .spool = "SP1"}); !made)
      return made.error();
    const auto job = job::Job::open(path_, job::JobUse::kLook);
    if (!job) return job.error();
    write_report(folder_.path() / "out", job->file().design_sha256);
    auto evidence = ncr::read_evidence(folder_.path() / "out", job->file().design_sha256);
    if (!evidence) return evidence.error();
    return ncr::fill_form(*job, path_, *std::move(evidence), input);
  }
  TemporaryFolder folder_;
  std::filesystem::path path_ = folder_.path() / "3032.spooljob";
};

std::string value(const ncr::NcrDocument& document, const char* key) {
  return ncr::field(document.form, key)->value;
}

TEST_F(FillForm, KnowsTheJobTheClockAndTheOperatorAndNothingElse) {
  const auto document = fill({"operator é", {}, "2026-11-29T06:15:00.250Z"});
  ASSERT_TRUE(document) << document.error().message;
  EXPECT_EQ(value(*document, "head.job_no"), "3032");
  EXPECT_EQ(value(*document, "head.date"), "2026-11-29");
  EXPECT_EQ(value(*document, "head.tag_line_no"), document->line);
  EXPECT_FALSE(document->line.empty());
  EXPECT_EQ(document->spool, "SP1");
  EXPECT_FALSE(document->welds.empty());
  EXPECT_EQ(value(*document, "root_cause.inspector"), "operator é");
  for (const ncr::FormField& each : document->form)
    if (each.source == ncr::FieldSource::kPerson || each.source == ncr::FieldSource::kNumber) {
      EXPECT_EQ(each.value, "") << each.key << " was made up";
    }
}

TEST_F(FillForm, DescribesWhatIsInstalledAndWhatTheDrawingRequires) {
  const auto document = fill({"", {}, "2026-11-29T06:15:00.250Z"});
  ASSERT_TRUE(document) << document.error().message;
  const std::string text = value(*document, "description.text");
  for (const char* each :
       {"SP1", "flange-1: Turned & so.", "requires 0.00°", "installed is 90.00°", "PFI ES-3 3.1"})
    EXPECT_NE(text.find(each), std::string::npos) << each << " is not in " << text;
  EXPECT_EQ(text.find("pipe-1/b"), std::string::npos) << "what is ok is no non-conformance";
  EXPECT_EQ(value(*document, "root_cause.inspector"), "") << "nobody said who";
}

TEST(DescriptionOf, NamesTheWorstAndSaysHowManyMoreThereAre) {
  const std::string text = ncr::description_of(sample_ncr(60));  // every fourth is out
  EXPECT_NE(text.find("And 10 more, in the table of features."), std::string::npos) << text;
  const std::string few = ncr::description_of(sample_ncr(20));
  EXPECT_EQ(few.find("more, in the table"), std::string::npos) << few;
}

TEST_F(FillForm, WhatAPersonSaysStands) {
  const auto document =
      fill({"", {{"description.text", "by hand\x01"}, {"head.job_no", "J"}}, "2026-11-29"});
  ASSERT_TRUE(document);
  EXPECT_EQ(value(*document, "description.text"), "by hand ");
  EXPECT_EQ(value(*document, "head.job_no"), "J");
}

TEST(CleanText, IsUtf8WithoutControlCharacters) {
  EXPECT_EQ(ncr::clean_text("a\x02\xFF"
                            "b\nc\td\x7F"),
            "a \xEF\xBF\xBD"
            "b\nc d ");
  EXPECT_EQ(ncr::clean_text("\xEF\xBF\xBF é"), "\xEF\xBF\xBD é");
}

TEST(NumberText, IsMillimetresInchesOrDegrees) {
  ncr::Feature feature;
  EXPECT_EQ(ncr::number_text(feature, 0.0046, LengthStyle::kMillimetre, true), "+4.6 mm");
  EXPECT_EQ(ncr::number_text(feature, 0.9144, LengthStyle::kFeetInch), "3' 0\"");
  EXPECT_EQ(ncr::number_text(feature, std::nullopt, LengthStyle::kMillimetre), "–");
  feature.is_angle = true;
  EXPECT_EQ(ncr::number_text(feature, -M_PI_2, LengthStyle::kFeetInch, true), "-90.00°");
}

TEST(ReadFields, RefusesWhatIsNoTextByKey) {
  const TemporaryFolder folder;
  const auto path = write_file(folder.path() / "fields.json", R"({"head.date": 7})");
  expect_refused(ncr::read_fields(path), ErrorCode::kBadInput, "fields.json", "head.date");
}

}  // namespace
}  // namespace spool::test
