// Checks of a job become captures, also where the disk fails or nobody said who checks.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "app/common/json_file.h"
#include "app/evidence/entry.h"
#include "tests/app/application/evidence_bench.h"
#include "tests/support/process.h"
#include "tests/support/shared_data.h"

namespace spool {
namespace {

namespace fs = std::filesystem;
using test::EvidenceOnScreen;
using test::FullDisk;

TEST_F(EvidenceOnScreen, ACheckIsACaptureThatIsVerifiedAndMadeAgain) {
  noise_ = {};  // the sensor's own, which a replay takes
  ASSERT_NO_FATAL_FAILURE(open(2));
  ASSERT_NO_FATAL_FAILURE(align());
  check();
  ASSERT_TRUE(offers("Accept")) << screen_.dump();
  press("Accept");
  EXPECT_EQ(screen_["step"], "all 3 steps accepted");
  const auto held = evidence::read_entry(entry("000001"));
  ASSERT_TRUE(held) << held.error().message;
  EXPECT_EQ(held->check.operator_name, "operator 1");
  EXPECT_EQ(held->check.step, 3);
  const auto json = read_json(entry("000001") / "entry.json");
  ASSERT_TRUE(json);
  for (const char* key : {"alignment", "datum", "standard", "sensor", "software", "state", "time"})
    EXPECT_TRUE(json->contains(key)) << key;
  for (const char* file : {"report.json", "report.html", "points.ply", "overlay_1.png", "plain.png",
                           "scan/camera.json", "scan/depth/000000.png", "inputs/pose.json"})
    EXPECT_TRUE(fs::exists(entry("000001") / file)) << file;
  expect_intact();
  const auto replayed = test::run(test::program("spoolsight-inspect"),
                                  {"--replay", path_.string(), "--out", folder_.path() / "again"});
  EXPECT_EQ(replayed.code, 0) << replayed.out << replayed.err;
  EXPECT_NE(replayed.out.find("the same, "), std::string::npos) << replayed.out;
  EXPECT_NE(replayed.out.find("over_frames"), std::string::npos) << replayed.out;
}

// What the disk does not take is said, kept, and captured at a touch when it does.
TEST_F(EvidenceOnScreen, WithoutADiskTheCheckWaitsAndIsCapturedAgain) {
  ASSERT_NO_FATAL_FAILURE(open(2));
  ASSERT_NO_FATAL_FAILURE(align());
  const auto expect_waiting = [&] {
    EXPECT_FALSE(offers("Accept")) << "nothing is accepted on what is not kept";
    EXPECT_TRUE(offers("Capture")) << screen_.dump();
    EXPECT_NE(std::string(screen_["hint"]).find("not captured"), std::string::npos)
        << screen_["hint"];
    EXPECT_NE(std::string(screen_["hint"]).find("disk"), std::string::npos) << screen_["hint"];
  };
  {
    const FullDisk full(3000);
    check();
    expect_waiting();
    press("Capture");
    expect_waiting();
  }
  EXPECT_EQ(journal().size(), 2U);
  press("Capture");
  EXPECT_TRUE(offers("Accept")) << screen_.dump();
  EXPECT_FALSE(offers("Capture"));
  // The report can be written and the evidence cannot.
  const fs::path aside = folder_.path() / "aside";
  fs::rename(path_ / "evidence", aside);
  test::write_file(path_ / "evidence", "in the way");
  check();
  expect_waiting();
  fs::remove(path_ / "evidence");
  fs::rename(aside, path_ / "evidence");
  press("Capture");
  EXPECT_TRUE(offers("Accept")) << screen_.dump();
  EXPECT_EQ(journal().size(), 4U);
  EXPECT_TRUE(fs::exists(entry("000002") / "scan/depth/000000.png"));
  EXPECT_TRUE(app_->finish()) << "all that failed was made good";
  expect_intact();
}

// What could not be captured until the end is the run's failure, not its secret.
TEST_F(EvidenceOnScreen, WhatIsNotCapturedAtTheEndIsSaid) {
  ASSERT_NO_FATAL_FAILURE(open(2));
  ASSERT_NO_FATAL_FAILURE(align());
  const fs::path aside = folder_.path() / "aside";
  fs::rename(path_ / "evidence", aside);
  test::write_file(path_ / "evidence", "in the way");
  check();
  const Status finished = app_->finish();
  ASSERT_FALSE(finished);
  EXPECT_EQ(finished.error().code, ErrorCode::kIo) << finished.error().message;
}

TEST_F(EvidenceOnScreen, AsksOnceForTheNameOfWhoChecks) {
  ASSERT_NO_FATAL_FAILURE(open(2, ""));
  ASSERT_NO_FATAL_FAILURE(align());
  press("Check");
  ASSERT_EQ(screen_["screen"], "typing") << screen_.dump();
  expect_thumbs();
  press("Cancel");
  EXPECT_TRUE(offers("Capture")) << "the check waits for a name";
  EXPECT_EQ(journal().size(), 2U);
  press("Capture");
  ASSERT_EQ(screen_["screen"], "typing");
  type("Ren");
  press("Key accents");
  expect_thumbs();
  press("Key é");
  press("Key ê");
  press("Key back");
  press("Key digits");
  press("Key space");
  press("Key 2");
  using Kind = ui::KeyPress::Kind;
  step({}, {{Kind::kLetter, U'ł'}, {Kind::kLetter, U'x'}, {Kind::kBackspace, 0}});
  press("Done");
  for (int i = 0; i < 4; ++i) step();
  EXPECT_EQ(screen_["screen"], "work");
  ASSERT_TRUE(offers("Accept")) << screen_.dump();
  EXPECT_EQ(journal().back().operator_name, "René 2ł");
  check();
  EXPECT_EQ(screen_["screen"], "work") << "asked once";
  EXPECT_EQ(journal().back().operator_name, "René 2ł");
  EXPECT_EQ(journal().size(), 4U);
  expect_intact();
}

TEST_F(EvidenceOnScreen, ShowsCapturesNewestFirstAndWhatEachHolds) {
  ASSERT_NO_FATAL_FAILURE(open(2, "operator 1", 800, 1280));
  ASSERT_NO_FATAL_FAILURE(align());
  press("More");
  expect_thumbs();
  press("Evidence");
  EXPECT_EQ(screen_["screen"], "evidence");
  EXPECT_NE(std::string(screen_["hint"]).find("No captures"), std::string::npos);
  press("Back");
  EXPECT_EQ(screen_["screen"], "work");
  check();
  check();
  press("More");
  press("Evidence");
  ASSERT_TRUE(offers("Capture 1") && offers("Capture 2")) << screen_.dump();
  expect_thumbs();
  EXPECT_LT(test::target(screen_, "Capture 2")->y, test::target(screen_, "Capture 1")->y);
  const render::Image list = app_->picture().target().read();
  press("Capture 1");
  step();
  expect_thumbs();
  EXPECT_TRUE(offers("NCR"));
  EXPECT_FALSE(offers("Capture 1"));
  // Its picture is there: brighter ground than any panel, which a list has little of.
  const auto bright = [](const render::Image& image) {
    int count = 0;
    for (std::size_t i = 0; i + 3 < image.rgba.size(); i += 4)
      count += image.rgba[i] + image.rgba[i + 1] + image.rgba[i + 2] > 200 ? 1 : 0;
    return count;
  };
  EXPECT_GT(bright(app_->picture().target().read()), bright(list) + 5000);
  press("Back");
  EXPECT_TRUE(offers("Capture 1"));
}

}  // namespace
}  // namespace spool
