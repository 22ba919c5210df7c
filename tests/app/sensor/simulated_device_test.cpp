// The whole device path, OpenNI2 and driver plug-in included, on the simulated camera.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <atomic>
#include <fstream>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "app/sensor/depth_source.h"
#include "app/sensor/recorder.h"
#include "tests/support/temporary_folder.h"
#include "tools/simulator/simulator.h"

namespace spool::sensor {
namespace {

namespace fs = std::filesystem;
using std::chrono::milliseconds;

// A slanted plate before a wall, seen by a fixed camera of 160 x 120 pixels.
constexpr char kScene[] = R"(
  "table": null, "floor": false,
  "clutter": [
    {"kind": "box", "size_m": [4, 0.1, 4], "position_m": [0, 1.55, 0]},
    {"kind": "box", "size_m": [0.3, 0.02, 0.3], "position_m": [0.1, 0.9, 0.05], "rotation_rad": [0, 0, 0.5]}],
  "trajectory": {"kind": "fixed", "T_map_camera": [1,0,0,0, 0,0,1,0, 0,-1,0,0, 0,0,0,1]})";

std::string write_scene(const fs::path& path, const std::string& more) {
  std::ofstream(path) << "{" << kScene << "," << more << "}";
  return "simulated:" + path.string();
}

constexpr char kSmall[] = R"("sensor": {"width": 160, "height": 120, "seed": 3})";

// The next frame, however long a busy machine takes; null where something else comes first.
std::shared_ptr<const DepthFrame> next_frame(DepthSource& source) {
  for (int i = 0; i < 100; ++i) {
    const auto output = source.next(milliseconds(100));
    EXPECT_TRUE(output) << output.error().message;
    if (!output) return nullptr;
    if (output->event == SourceEvent::kFrame) return output->frame;
    EXPECT_EQ(output->event, SourceEvent::kTimeout);
  }
  return nullptr;
}

TEST(SimulatedDevice, GivesTheSimulatorsFramesThroughOpenni) {
  const test::TemporaryFolder temporary;
  const fs::path path = temporary.path() / "scene.json";
  const auto source = open_source(write_scene(path, kSmall));
  ASSERT_TRUE(source) << source.error().message;
  EXPECT_FALSE((*source)->is_recording());
  const Camera& camera = (*source)->camera();
  const auto simulator = simulator::Simulator::open(path);
  ASSERT_TRUE(simulator) << simulator.error().message;
  EXPECT_EQ(camera.width, 160);
  EXPECT_EQ(camera.height, 120);
  EXPECT_NEAR(camera.fx, simulator->scene().sensor.camera.fx, 1e-4);  // fields of view are float
  EXPECT_EQ(camera.cx, 80);
  std::int64_t last = -1;
  for (int i = 0; i < 5; ++i) {
    const auto frame = next_frame(**source);
    ASSERT_TRUE(frame);
    EXPECT_GT(frame->index, last);
    last = frame->index;
    EXPECT_NEAR(frame->seconds, static_cast<double>(frame->index) / 30, 1e-5);
    EXPECT_EQ(frame->depth, simulator->frame(frame->index).depth);
  }
}

TEST(SimulatedDevice, IsNotMirroredEvenWhereTheDriverMirrorsByItself) {
  const test::TemporaryFolder temporary;
  const fs::path path = temporary.path() / "scene.json";
  const auto source = open_source(
      write_scene(path, R"("sensor": {"width": 160, "height": 120, "mirrored": true})"));
  ASSERT_TRUE(source) << source.error().message;
  const auto simulator = simulator::Simulator::open(path);
  ASSERT_TRUE(simulator);
  const auto frame = next_frame(**source);
  ASSERT_TRUE(frame);
  EXPECT_EQ(frame->depth, simulator->frame(frame->index).depth);
  EXPECT_EQ((*source)->camera().cx, 80);
}

TEST(SimulatedDevice, BackProjectsAPlaneToItsPlace) {
  const test::TemporaryFolder temporary;
  const auto source = open_source(write_scene(
      temporary.path() / "scene.json",
      R"("sensor": {"width": 160, "height": 120, "noise": false, "depth_unit_m": 0.0001})"));
  ASSERT_TRUE(source) << source.error().message;
  const auto frame = next_frame(**source);
  ASSERT_TRUE(frame);
  const Camera& camera = (*source)->camera();
  // The plate: centre (0.1, -0.05, 0.9) in the camera frame, turned by 0.5 rad about the camera's
  // -y; its near face is half its thickness towards the camera.
  const Eigen::Vector3d normal(std::sin(0.5), 0, -std::cos(0.5));
  const Eigen::Vector3d centre(0.1, -0.05, 0.9);
  int on_plate = 0;
  for (int v = 0; v < camera.height; ++v)
    for (int u = 0; u < camera.width; ++u) {
      const auto count = frame->depth[static_cast<std::size_t>(v * camera.width + u)];
      const Eigen::Vector3d point = camera.back_project(u, v, count * camera.depth_unit_m);
      if (point.z() <= 0 || (point - centre).norm() > 0.12) continue;
      ++on_plate;
      // Half a count of 0.1 mm along the ray, and as much again for the float fields of view.
      EXPECT_NEAR(normal.dot(point - centre), 0.01, 1e-4) << u << " " << v;
    }
  EXPECT_GT(on_plate, 200);
}

TEST(SimulatedDevice, SaysWhenItIsUnpluggedAndWhenItIsBack) {
  const test::TemporaryFolder temporary;
  const auto source = open_source(
      write_scene(temporary.path() / "scene.json",
                  std::string(kSmall) +
                      R"(, "unplug": [{"at_s": 0.4, "for_s": 0.3}, {"at_s": 1.2, "for_s": 0.2}])"));
  ASSERT_TRUE(source) << source.error().message;
  std::vector<SourceEvent> changes;  // each event once, timeouts left out
  std::int64_t last = -1;
  double last_seconds = -1;
  for (int i = 0; i < 400 && changes.size() < 7; ++i) {
    const auto output = (*source)->next(milliseconds(50));
    ASSERT_TRUE(output) << output.error().message;
    if (output->event == SourceEvent::kTimeout) continue;
    if (changes.empty() || changes.back() != output->event) changes.push_back(output->event);
    if (output->event != SourceEvent::kFrame) continue;
    EXPECT_GT(output->frame->index, last) << "numbers go on over an unplugging";
    EXPECT_GT(output->frame->seconds, last_seconds) << "and so does the clock";
    last = output->frame->index;
    last_seconds = output->frame->seconds;
  }
  const std::vector<SourceEvent> expected = {SourceEvent::kFrame,     SourceEvent::kUnplugged,
                                             SourceEvent::kReplugged, SourceEvent::kFrame,
                                             SourceEvent::kUnplugged, SourceEvent::kReplugged,
                                             SourceEvent::kFrame};
  EXPECT_EQ(changes, expected);
}

TEST(SimulatedDevice, MayBeClosedWhileItIsUnplugged) {
  const test::TemporaryFolder temporary;
  const auto source =
      open_source(write_scene(temporary.path() / "scene.json",
                              std::string(kSmall) + R"(, "unplug": [{"at_s": 0.1, "for_s": 60}])"));
  ASSERT_TRUE(source) << source.error().message;
  for (int i = 0; i < 200; ++i) {
    const auto output = (*source)->next(milliseconds(50));
    ASSERT_TRUE(output);
    if (output->event == SourceEvent::kUnplugged) return;
  }
  FAIL() << "never unplugged";
}

TEST(SimulatedDevice, HandsFramesToOtherThreads) {
  const test::TemporaryFolder temporary;
  const auto source = open_source(write_scene(temporary.path() / "scene.json", kSmall));
  ASSERT_TRUE(source) << source.error().message;
  std::atomic<int> frames{0};
  std::shared_ptr<const DepthFrame> kept;
  std::thread reader([&] {
    for (int i = 0; i < 3; ++i)
      if (auto frame = next_frame(**source)) {
        kept = std::move(frame);
        ++frames;
      }
  });
  reader.join();
  EXPECT_EQ(frames, 3);
  ASSERT_TRUE(kept);
  EXPECT_TRUE(kept->is_consistent());
}

TEST(SimulatedDevice, OpensTwoScenesBesideEachOther) {
  const test::TemporaryFolder temporary;
  const auto a = open_source(write_scene(temporary.path() / "a.json", kSmall));
  const auto b = open_source(write_scene(temporary.path() / "b.json", kSmall));
  ASSERT_TRUE(a) << a.error().message;
  ASSERT_TRUE(b) << b.error().message;
  EXPECT_TRUE(next_frame(**a));
  EXPECT_TRUE(next_frame(**b));
}

TEST(SimulatedDevice, NeverPassesForACameraThatIsPluggedIn) {
  const test::TemporaryFolder temporary;
  const auto simulated = open_source(write_scene(temporary.path() / "a.json", kSmall));
  ASSERT_TRUE(simulated);
  const auto camera = open_source("openni");
  if (camera) GTEST_SKIP() << "a depth camera is plugged in";
  EXPECT_EQ(camera.error().code, ErrorCode::kNoDevice);
}

TEST(SimulatedDevice, SaysWhatIsWrongWithAScene) {
  const test::TemporaryFolder temporary;
  const auto missing = open_source("simulated:" + (temporary.path() / "none.json").string());
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, ErrorCode::kBadInput) << missing.error().message;
  const auto wrong =
      open_source(write_scene(temporary.path() / "a.json", R"("sensor": {"width": -1})"));
  ASSERT_FALSE(wrong);
  EXPECT_NE(wrong.error().message.find("width"), std::string::npos) << wrong.error().message;
}

TEST(SimulatedDevice, IsRecordedToOniAndToADepthFolder) {
  const test::TemporaryFolder temporary;
  setenv("XDG_CACHE_HOME", (temporary.path() / "cache").c_str(), 1);
  const fs::path scene = temporary.path() / "scene.json";
  const auto source = open_source(write_scene(scene, kSmall));
  ASSERT_TRUE(source) << source.error().message;
  for (const char* name : {"a.oni", "folder"}) {
    const auto recorded = record(**source, (temporary.path() / name).string(), {.frames = 4});
    ASSERT_TRUE(recorded) << recorded.error().message;
    EXPECT_EQ(recorded->frames, 4);
    const auto played = open_source((temporary.path() / name).string());
    ASSERT_TRUE(played) << played.error().message;
    const auto frame = next_frame(**played);
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->width, 160);
  }
}

}  // namespace
}  // namespace spool::sensor
