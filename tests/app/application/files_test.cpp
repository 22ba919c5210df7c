// Claims about TAPS.json, poses.csv and the thread that loses no job.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <atomic>
#include <chrono>
#include <fstream>
#include <thread>

#include <gtest/gtest.h>

#include "app/application/job_thread.h"
#include "app/application/pose_table.h"
#include "app/application/tap_script.h"
#include "tests/support/temporary_folder.h"

namespace spool {
namespace {

TEST(TapScript, HandsOutEventsInTimeAsPixelsOfTheWindow) {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "taps.json";
  std::ofstream(path) << R"({"events": [
    {"t_s": 1.0, "id": 0, "phase": "up", "x": 0.5, "y": 0.25},
    {"t_s": 0.5, "id": 0, "phase": "down", "x": 0.5, "y": 0.25}]})";
  auto script = TapScript::read(path);
  ASSERT_TRUE(script.has_value());
  EXPECT_TRUE(script->until(0.4, 800, 400).empty());
  const auto first = script->until(0.6, 800, 400);
  ASSERT_EQ(first.size(), 1U);
  EXPECT_EQ(first[0].phase, ui::TouchPhase::kDown);
  EXPECT_EQ(first[0].x, 400);
  EXPECT_EQ(first[0].y, 100);
  EXPECT_FALSE(script->is_finished());
  EXPECT_EQ(script->until(9, 800, 400).size(), 1U);
  EXPECT_TRUE(script->is_finished());
}

struct Bad {
  std::string name, text, words;
};

TEST(TapScript, RefusesWhatItCannotUseAndSaysHowToWriteIt) {
  const test::TemporaryFolder folder;
  const std::vector<Bad> table{
      {"no list", R"({"taps": []})", "no list of events"},
      {"another phase", R"({"events": [{"t_s":0,"id":0,"phase":"hop","x":0,"y":0}]})", "event 0"},
      {"outside the window", R"({"events": [{"t_s":0,"id":0,"phase":"up","x":1.5,"y":0}]})",
       "event 0"},
      {"no time", R"({"events": [{"id":0,"phase":"up","x":0.5,"y":0}]})", "event 0"},
      {"text for a number", R"({"events": [{"t_s":"0","id":0,"phase":"up","x":0.5,"y":0}]})",
       "event 0"},
      {"not json", "taps", "taps.json"},
  };
  for (const Bad& row : table) {
    SCOPED_TRACE(row.name);
    const auto path = folder.path() / "taps.json";
    std::ofstream(path) << row.text;
    const auto script = TapScript::read(path);
    ASSERT_FALSE(script.has_value());
    EXPECT_EQ(script.error().code, ErrorCode::kBadInput);
    EXPECT_NE(script.error().message.find(row.words), std::string::npos) << script.error().message;
  }
}

TEST(PoseTable, KeepsTheNewestRows) {
  PoseTable table(Eigen::Vector3d::Zero());
  for (std::int64_t frame = 0; frame < 5; ++frame) table.add({{frame, 0.1, TrackQuality::kGood}});
  table.keep_newest(2);
  const std::string text = table.text();
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 3) << text;
  EXPECT_NE(text.find("\n3,"), std::string::npos) << text;
  EXPECT_NE(text.find("\n4,"), std::string::npos) << text;
}

TEST(PoseTable, WritesOneRowAFrameInTheDesignFilesCoordinates) {
  PoseTable table(Eigen::Vector3d(100, 0, 0));
  Pose T = Pose::Identity();
  T.translation() = Eigen::Vector3d(1, 2, 3);
  table.add({{1, 0.5, TrackQuality::kLost, Pose::Identity()},
             {0, 0.25, TrackQuality::kUnaligned, Pose::Identity()}});
  table.add({{1, 0.5, TrackQuality::kGood, T}});  // an alignment made on frame 1 later
  const std::string text = table.text();
  EXPECT_EQ(text.rfind("frame,seconds,quality,t00,", 0), 0U);
  EXPECT_NE(text.find("\n0,0.250000,lost,1,0,0,100,0,1,0,0,0,0,1,0,0,0,0,1\n"), std::string::npos)
      << text;
  EXPECT_NE(text.find("\n1,0.500000,good,1,0,0,101,0,1,0,2,0,0,1,3,0,0,0,1\n"), std::string::npos)
      << text;
}

TEST(JobThread, DoesEveryJobInOrderEvenWhenItIsEnded) {
  std::vector<int> done;
  {
    JobThread jobs;
    for (int i = 0; i < 100; ++i) {
      jobs.run([&done, i] {
        if (i == 0) std::this_thread::sleep_for(std::chrono::milliseconds(20));
        done.push_back(i);
      });
    }
  }
  ASSERT_EQ(done.size(), 100U);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(done[static_cast<std::size_t>(i)], i);
}

TEST(JobThread, WaitReturnsWhenAllJobsAreDone) {
  JobThread jobs;
  std::atomic<int> done{0};
  for (int i = 0; i < 5; ++i) {
    jobs.run([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
      ++done;
    });
  }
  jobs.wait();
  EXPECT_EQ(done.load(), 5);
}

}  // namespace
}  // namespace spool
