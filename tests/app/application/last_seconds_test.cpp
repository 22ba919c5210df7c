// The saved last seconds are a whole depth folder, or nothing at all.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/application/last_seconds.h"

#include <algorithm>
#include <csignal>
#include <vector>

#include <sys/resource.h>

#include <gtest/gtest.h>

#include "tests/app/runner/simulated_scene.h"
#include "tests/support/temporary_folder.h"

namespace spool {
namespace {

namespace fs = std::filesystem;

LastSeconds some_seconds() {
  LastSeconds last{test::small_camera(), {}, PoseTable(Eigen::Vector3d::Zero())};
  for (int i = 0; i < 4; ++i) {
    auto frame = *test::render_frame(*test::prepared_bracket(), test::T_design_camera(), 70 + i);
    frame.seconds = 9 + i / 30.0;
    last.frames.push_back(std::make_shared<sensor::PackedDepth>(sensor::pack(frame)));
  }
  PoseTable poses(Eigen::Vector3d::Zero());
  poses.add({{71, 9.0333, TrackQuality::kGood, Pose::Identity()},
             {73, 9.1, TrackQuality::kPaused, Pose::Identity()},
             {99, 12, TrackQuality::kGood, Pose::Identity()}});
  last.poses = poses.renumbered(std::vector<std::int64_t>{70, 71, 72, 73});
  return last;
}

TEST(LastSeconds, NumbersThePosesAsTheFramesBesideThem) {
  const std::string text = some_seconds().poses.text();
  EXPECT_NE(text.find("\n1,9.033300,good,"), std::string::npos) << text;
  EXPECT_NE(text.find("\n3,9.100000,poor,"), std::string::npos) << text;
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 3) << "none of another time";
}

TEST(LastSeconds, TakesTheNextFreeName) {
  const test::TemporaryFolder temporary;
  for (const char* name : {"last_001", "last_002"}) {
    const auto folder = save_last_seconds(temporary.path(), some_seconds());
    ASSERT_TRUE(folder.has_value()) << folder.error().message;
    EXPECT_EQ(*folder, temporary.path() / name);
    EXPECT_TRUE(fs::exists(*folder / "depth" / "000003.png"));
  }
}

TEST(LastSeconds, SaysThatThereIsNothingToSave) {
  const test::TemporaryFolder temporary;
  const auto folder = save_last_seconds(
      temporary.path(), {test::small_camera(), {}, PoseTable(Eigen::Vector3d::Zero())});
  ASSERT_FALSE(folder.has_value());
  EXPECT_TRUE(fs::is_empty(temporary.path()));
}

TEST(LastSeconds, LeavesNothingHalfOnAFullDisk) {
  const test::TemporaryFolder temporary;
  const LastSeconds last = some_seconds();
  // A limit on the size of files fails a write as a full disk does.
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit tight{2000, before.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &tight), 0);
  const auto folder = save_last_seconds(temporary.path(), last);
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  ASSERT_FALSE(folder.has_value());
  EXPECT_EQ(folder.error().code, ErrorCode::kIo);
  EXPECT_NE(folder.error().message.find("000000.png"), std::string::npos) << folder.error().message;
  EXPECT_TRUE(fs::is_empty(temporary.path())) << "no folder, no part of one";
}

}  // namespace
}  // namespace spool
