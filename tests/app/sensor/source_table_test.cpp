// What text opens what, and what is said of the rest.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <fstream>

#include <gtest/gtest.h>

#include "app/sensor/depth_source.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_folder.h"

namespace spool::sensor {
namespace {

TEST(OpenSource, RefusesWhatIsNoSource) {
  const test::TemporaryFolder temporary;
  const auto file = temporary.path() / "notes.txt";
  std::ofstream(file) << "hello";
  struct Case {
    std::string text;
    ErrorCode code;
    const char* says;
  };
  const Case cases[] = {
      {"", ErrorCode::kUsage, "is no source"},
      {"openniX", ErrorCode::kUsage, "is no source"},
      {(temporary.path() / "missing").string(), ErrorCode::kUsage, "is no source"},
      {file.string(), ErrorCode::kBadInput, "is neither"},
      {temporary.path().string(), ErrorCode::kBadInput, "camera.json"},
      {(temporary.path() / "missing.oni").string(), ErrorCode::kBadInput, "check the path"},
  };
  for (const Case& one : cases) {
    SCOPED_TRACE(one.text);
    test::expect_refused(open_source(one.text), one.code, one.text, one.says);
  }
}

TEST(OpenSource, RefusesAPaceThatIsNone) {
  for (const double speed :
       {-1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    const auto source = open_source("openni", {.speed = speed});
    ASSERT_FALSE(source);
    EXPECT_EQ(source.error().code, ErrorCode::kUsage);
  }
}

TEST(OpenSource, SaysWhatToDoWhereNoCameraIs) {
  for (const char* text : {"openni", "openni:1d27/0609@250/250"}) {
    const auto source = open_source(text);
    if (source) GTEST_SKIP() << "a depth camera is plugged in";
    EXPECT_EQ(source.error().code, ErrorCode::kNoDevice);
    EXPECT_EQ(source.error().message.rfind(text, 0), 0u) << source.error().message;
  }
}

TEST(IsRecordingPath, IsTrueForDepthFoldersAndOniFilesOnly) {
  const test::TemporaryFolder temporary;
  EXPECT_FALSE(is_recording_path(temporary.path().string()));
  EXPECT_FALSE(is_recording_path((temporary.path() / "a.oni").string()));
  std::ofstream(temporary.path() / "camera.json") << "{}";
  std::ofstream(temporary.path() / "a.ONI") << "x";
  EXPECT_TRUE(is_recording_path(temporary.path().string()));
  EXPECT_TRUE(is_recording_path((temporary.path() / "a.ONI").string()));
}

}  // namespace
}  // namespace spool::sensor
