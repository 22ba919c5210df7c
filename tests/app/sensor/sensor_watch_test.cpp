// A camera's life as the watch sees it: what is said, from when to when, and what is handed on.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/sensor/sensor_watch.h"

#include <functional>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "app/sensor/camera_choice.h"

namespace spool::sensor {
namespace {

constexpr double kPeriod = 1.0 / 30;

Camera small() {
  Camera camera;
  camera.width = 32;
  camera.height = 24;
  camera.fx = camera.fy = 30;
  return camera;
}

// A camera that is asked thirty times a second, and what the watch made of it.
struct Watched {
  SensorWatch watch{small(), 0};
  std::mt19937 random{7};
  double now_s = 0;
  std::vector<SensorTrouble> told = {};  // each change
  int handed_on = 0;

  void give(const SourceOutput& output) {
    if (watch.see(output, now_s)) told.push_back(watch.trouble());
    handed_on += watch.is_news() ? 1 : 0;
    now_s += kPeriod;
  }
  void frame(const std::function<std::uint16_t(std::size_t)>& depth, int width = 32) {
    auto made = std::make_shared<DepthFrame>();
    made->width = width;
    made->height = 24;
    made->seconds = now_s;
    for (std::size_t i = 0; i < std::size_t{24} * static_cast<std::size_t>(width); ++i)
      made->depth.push_back(depth(i));
    give({SourceEvent::kFrame, made});
  }
  void noisy(double seconds) {
    for (double until = now_s + seconds; now_s < until;)
      frame([&](std::size_t) { return static_cast<std::uint16_t>(1000 + random() % 3); });
  }
  void same(double seconds) {
    for (double until = now_s + seconds; now_s < until;)
      frame([](std::size_t i) { return static_cast<std::uint16_t>(1000 + i); });
  }
  void nothing(double seconds) {
    for (double until = now_s + seconds; now_s < until;)
      frame([](std::size_t i) { return static_cast<std::uint16_t>(i == 5 ? 800 : 0); });
  }
  void silence(double seconds) {
    for (double until = now_s + seconds; now_s < until;) give({SourceEvent::kTimeout, nullptr});
  }
};

using Troubles = std::vector<SensorTrouble>;

TEST(SensorWatch, HasNothingToSayOfACameraThatWorks) {
  Watched camera;
  camera.silence(2);  // it starts
  camera.noisy(3);
  camera.silence(0.5);
  camera.noisy(1);
  EXPECT_EQ(camera.told, Troubles{});
  EXPECT_NEAR(camera.handed_on, 120, 2);
  EXPECT_TRUE(camera.watch.words().empty());
}

TEST(SensorWatch, SaysThatNoPictureComesAndThatItComesAgain) {
  Watched camera;
  camera.noisy(1);
  camera.silence(0.9);
  EXPECT_EQ(camera.told, Troubles{});
  camera.silence(0.3);
  EXPECT_EQ(camera.told, (Troubles{SensorTrouble::kSilent}));
  EXPECT_NE(camera.watch.words().find(": "), std::string::npos) << "and what to do";
  camera.noisy(0.1);
  EXPECT_EQ(camera.told, (Troubles{SensorTrouble::kSilent, SensorTrouble::kNone}));
}

TEST(SensorWatch, SaysThatACameraNeverBegan) {
  Watched camera;
  camera.silence(6);
  EXPECT_EQ(camera.told, (Troubles{SensorTrouble::kSilent}));
}

TEST(SensorWatch, SaysThatOnePictureRepeatsAndHandsItOnOnce) {
  Watched camera;
  camera.noisy(1);
  const int before = camera.handed_on;
  camera.same(0.9);
  EXPECT_EQ(camera.told, Troubles{}) << "a driver may give a picture twice";
  camera.same(0.5);
  EXPECT_EQ(camera.told, (Troubles{SensorTrouble::kStuck}));
  EXPECT_EQ(camera.handed_on, before + 1);
  camera.noisy(0.1);
  EXPECT_EQ(camera.told, (Troubles{SensorTrouble::kStuck, SensorTrouble::kNone}));
}

TEST(SensorWatch, TakesAnExactSceneBeforeAStillCameraForWhatItIs) {
  Watched camera;
  camera.same(5);
  EXPECT_EQ(camera.told, Troubles{});
  EXPECT_NEAR(camera.handed_on, 150, 1);
}

TEST(SensorWatch, SaysThatTheLensIsCoveredAndGoesOnHandingOnItsPictures) {
  Watched camera;
  camera.noisy(1);
  const int before = camera.handed_on;
  camera.nothing(0.9);
  EXPECT_EQ(camera.told, Troubles{}) << "an arc is no cover";
  camera.nothing(2);
  EXPECT_EQ(camera.told, (Troubles{SensorTrouble::kCovered})) << "not stuck";
  EXPECT_GT(camera.handed_on, before + 80) << "vision says itself that it sees nothing";
  camera.noisy(0.1);
  EXPECT_EQ(camera.told, (Troubles{SensorTrouble::kCovered, SensorTrouble::kNone}));
}

TEST(SensorWatch, KeepsPicturesOfAnotherSizeFromVisionAndSaysSo) {
  Watched camera;
  camera.noisy(1);
  const int before = camera.handed_on;
  camera.frame([](std::size_t) { return std::uint16_t{900}; }, 16);
  EXPECT_EQ(camera.told, (Troubles{SensorTrouble::kWrongMode}));
  EXPECT_EQ(camera.handed_on, before);
  const std::string words = camera.watch.words();
  EXPECT_NE(words.find("16x24 pictures and not 32x24"), std::string::npos) << words;
  camera.noisy(0.1);
  EXPECT_EQ(camera.told, (Troubles{SensorTrouble::kWrongMode, SensorTrouble::kNone}));
}

TEST(SensorWatch, PassesOnWhatTheSourceSaysOfAnotherMode) {
  Watched camera;
  camera.noisy(0.2);
  camera.give({SourceEvent::kUnplugged, nullptr});
  camera.give({SourceEvent::kWrongMode, nullptr, "640x480 px of 0.1 mm pictures"});
  EXPECT_EQ(camera.told, (Troubles{SensorTrouble::kWrongMode}));
  EXPECT_NE(camera.watch.words().find("of 0.1 mm"), std::string::npos);
  camera.give({SourceEvent::kReplugged, nullptr});
  EXPECT_EQ(camera.told.back(), SensorTrouble::kNone);
}

TEST(SensorWatch, AnUnpluggedCameraIsNotSilentAndGetsTimeToComeBack) {
  Watched camera;
  camera.noisy(1);
  camera.give({SourceEvent::kUnplugged, nullptr});
  camera.silence(20);
  camera.give({SourceEvent::kReplugged, nullptr});
  camera.silence(3);
  EXPECT_EQ(camera.told, Troubles{});
  camera.silence(3);
  EXPECT_EQ(camera.told, (Troubles{SensorTrouble::kSilent}));
}

TEST(CameraChoice, TakesTheFirstAndNamesTheOthers) {
  EXPECT_FALSE(choose_camera({}).has_value());
  EXPECT_EQ(choose_camera({{"1d27/0609@1/5", "Carmine"}})->remark, "");
  const auto choice = choose_camera({{"1d27/0609@1/5", "Carmine"}, {"1d27/0600@1/7", "Xtion"}});
  EXPECT_EQ(choice->uri, "1d27/0609@1/5");
  for (const char* said : {"2 cameras", "Carmine at 1d27/0609@1/5", "openni:URI", "1d27/0600@1/7"})
    EXPECT_NE(choice->remark.find(said), std::string::npos) << choice->remark;
}

}  // namespace
}  // namespace spool::sensor
