// The soak's arithmetic on memory of known growth, and a few seconds of it as a person runs it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include <unistd.h>

#include <gtest/gtest.h>

#include "app/sensor/depth_folder.h"
#include "tests/support/process.h"
#include "tests/support/shared_data.h"
#include "tools/soak/long_recording.h"
#include "tools/soak/memory.h"
#include "tools/soak/soak_log.h"

namespace spool::soak {
namespace {

namespace fs = std::filesystem;

std::string design() { return (test::source_dir() / "assets/sample/spool.glb").string(); }
std::string recording() { return (test::source_dir() / "assets/sample/recording").string(); }

// A sample a second for an hour.
std::vector<MemorySample> an_hour(const std::function<double(double)>& mib) {
  std::vector<MemorySample> samples;
  for (int i = 0; i <= 3600; ++i) samples.push_back({double(i), mib(i)});
  return samples;
}

TEST(MemoryTrend, IsTheSlopeOfWhatGrowsAndKnowsHowWell) {
  std::mt19937 random{3};
  std::normal_distribution<double> noise(0, 2);
  const auto trend = memory_trend(an_hour([&](double s) { return 300 + s / 60 + noise(random); }));
  ASSERT_TRUE(trend);
  EXPECT_NEAR(trend->per_hour, 60, 2);
  EXPECT_LT(trend->low, trend->per_hour);
  EXPECT_GT(trend->high, trend->per_hour);
  EXPECT_LT(trend->high - trend->low, 5);
}

TEST(MemoryTrend, TakesNeitherAStepNorASpikeForGrowth) {
  const auto step = memory_trend(an_hour([](double s) { return s < 3000 ? 300.0 : 340.0; }));
  ASSERT_TRUE(step);
  EXPECT_LE(step->low, 0);
  const auto spike =
      memory_trend(an_hour([](double s) { return std::abs(s - 1000) < 20 ? 900.0 : 300.0; }));
  ASSERT_TRUE(spike);
  EXPECT_EQ(spike->per_hour, 0);
  EXPECT_EQ(spike->high, 0);
}

TEST(MemoryTrend, OfTooLittleIsNothing) {
  EXPECT_FALSE(memory_trend({}));
  EXPECT_FALSE(memory_trend({{0, 1}, {1, 1}, {2, 1}}));
  EXPECT_FALSE(memory_trend({{0, 1}, {0, 2}, {0, 3}, {0, 4}}));
}

TEST(MemoryLog, JudgesGrowthAfterTheFirstMinutesAndThePeak) {
  const auto verdict_of = [](const std::function<double(double)>& mib) {
    MemoryLog log(3600);
    double peak = 0;
    for (const MemorySample& sample : an_hour(mib)) {
      peak = std::max(peak, sample.mib);
      log.add(sample.seconds, {sample.mib, peak});
    }
    EXPECT_EQ(log.settle_s(), 120);
    return *log.verdict();
  };
  // It fills for two minutes and stays.
  const auto filled = verdict_of([](double s) { return 100 + 200 * std::min(1.0, s / 120); });
  EXPECT_TRUE(filled.is_flat && filled.is_surely_flat && filled.is_in_budget);
  EXPECT_EQ(filled.start_mib, 100);
  EXPECT_EQ(filled.settled_mib, 300);
  // 6 % an hour where 5 are flat, and 4.
  EXPECT_FALSE(verdict_of([](double s) { return 300 + 18 * s / 3600; }).is_flat);
  EXPECT_TRUE(verdict_of([](double s) { return 300 + 12 * s / 3600; }).is_surely_flat);
  EXPECT_FALSE(verdict_of([](double s) { return s == 60 ? 1025.0 : 300.0; }).is_in_budget);
}

TEST(ResidentMemory, IsThisProcessesOwn) {
  const auto before = resident_memory(::getpid());
  ASSERT_TRUE(before);
  std::vector<char> more(std::size_t{64} << 20, 1);  // written to, so it is there
  const auto after = resident_memory(::getpid());
  ASSERT_TRUE(after);
  EXPECT_GT(after->now_mib - before->now_mib, 32) << more.back();
  EXPECT_GE(after->peak_mib, after->now_mib);
}

TEST(LongRecording, GoesThereAndBackWithAClockThatGoesOn) {
  fs::path folder;
  {
    const auto made = LongRecording::make(recording(), 10);
    ASSERT_TRUE(made) << made.error().message;
    folder = made->folder();
    const auto read = sensor::read_depth_folder(folder);
    ASSERT_TRUE(read) << read.error().message;
    ASSERT_EQ(read->files.size(), made->frames());
    EXPECT_NEAR(static_cast<double>(made->frames()), 10 * 30, 2);
    const auto shows = [&](std::size_t frame) {
      return fs::read_symlink(read->files[frame].path).filename().string();
    };
    EXPECT_EQ(shows(23), "000023.png");  // the last of them
    EXPECT_EQ(shows(24), "000022.png");
    EXPECT_EQ(shows(46), "000000.png");
    EXPECT_EQ(shows(47), "000001.png");
    for (std::size_t i = 1; i < read->files.size(); ++i)
      EXPECT_NEAR(read->files[i].seconds - read->files[i - 1].seconds, 1.0 / 30, 1e-4);
  }
  EXPECT_FALSE(fs::exists(folder));
  EXPECT_FALSE(LongRecording::make("/nowhere", 10));
}

// Too short to say anything of memory but by chance: what is asked for is what it tells.
TEST(Soak, PlaysSomeSecondsThroughVision) {
  const auto result =
      test::run(test::program("spoolsight-soak"), {design(), recording(), "--minutes", "0.04"});
  EXPECT_TRUE(result.code == 0 || result.code == 1) << result.err;
  for (const char* words : {"frames of 640x480", "frame ms p50 / p99 / most", "map cells", "lost 0",
                            "resident MiB", "MiB an hour", "the budget of 1024 MiB"})
    EXPECT_NE(result.out.find(words), std::string::npos) << words << result.out;
}

TEST(Soak, PlaysSomeSecondsThroughTheWholeProgram) {
  const auto taps = (test::source_dir() / "assets/sample/taps.json").string();
  const auto result =
      test::run(test::program("spoolsight-soak"),
                {design(), recording(), "--minutes", "0.02", "--program-script", taps});
  if (result.err.find("ended with 69") != std::string::npos &&
      std::getenv("SPOOL_REQUIRE_GL") == nullptr)
    GTEST_SKIP() << "no driver gives an OpenGL ES 3.0 context";
  EXPECT_TRUE(result.code == 0 || result.code == 1) << result.err;
  for (const char* words :
       {"| wall min | resident MiB |", "each with their screens", "MiB an hour"})
    EXPECT_NE(result.out.find(words), std::string::npos) << words << result.out;
}

TEST(Soak, RefusesInOneSentence) {
  struct Case {
    std::vector<std::string> arguments;
    int code;
    const char* says;
  };
  for (const Case& each :
       {Case{{"/nowhere/spool.glb", recording(), "--minutes", "1"}, 65, "/nowhere/spool.glb"},
        Case{{design(), "/nowhere"}, 64, "/nowhere"},
        Case{{design(), recording(), "--minutes", "0"}, 64, "--minutes"},
        Case{{design(), recording(), "--real-time", "--program-script", "x"}, 64, "excludes"}}) {
    const auto result = test::run(test::program("spoolsight-soak"), each.arguments);
    EXPECT_EQ(result.code, each.code) << result.err;
    EXPECT_NE(result.err.find(each.says), std::string::npos) << result.err;
  }
}

}  // namespace
}  // namespace spool::soak
