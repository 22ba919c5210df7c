// .oni files through OpenNI2 itself: what is recorded plays back bit for bit, what is damaged
// hurts nobody.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <random>
#include <vector>

#include <sys/resource.h>

#include <gtest/gtest.h>

#include "app/sensor/depth_folder.h"
#include "app/sensor/depth_source.h"
#include "app/sensor/oni_check.h"
#include "app/sensor/recorder.h"
#include "tests/support/temporary_folder.h"
#include "vision/core/file_io.h"

namespace spool::sensor {
namespace {

namespace fs = std::filesystem;
using std::chrono::milliseconds;

Camera test_camera() {
  Camera camera;
  camera.width = 64;
  camera.height = 48;
  camera.fx = 57.58;
  camera.fy = 57.5;
  camera.cx = 32;
  camera.cy = 24;
  return camera;
}

// Frames made up on the spot: a slope with noise and holes, 0 to 9 m.
class MadeUpSource final : public DepthSource {
 public:
  explicit MadeUpSource(int count, Camera camera_in = test_camera(), std::uint16_t largest = 9000)
      : count_(count), camera_(std::move(camera_in)), largest_(largest) {}
  const Camera& camera() const override { return camera_; }
  std::string description() const override { return "made up"; }
  bool is_recording() const override { return true; }
  Result<SourceOutput> next(milliseconds) override {
    if (next_ == count_) return SourceOutput{SourceEvent::kEnd, nullptr};
    return SourceOutput{SourceEvent::kFrame, std::make_shared<DepthFrame>(frame(next_++))};
  }
  DepthFrame frame(int index) const {
    std::mt19937 random(static_cast<unsigned>(index + 1));
    DepthFrame frame;
    frame.index = index;
    frame.seconds = 2.5 + index / 30.0;
    frame.width = camera_.width;
    frame.height = camera_.height;
    for (int i = 0; i < frame.width * frame.height; ++i) {
      const unsigned noise = static_cast<unsigned>(random());
      const unsigned depth = static_cast<unsigned>(i) * 2 + noise % 7;
      frame.depth.push_back(
          static_cast<std::uint16_t>(noise % 16 == 0 ? 0 : std::min<unsigned>(depth, largest_)));
    }
    frame.depth[5] = largest_;
    return frame;
  }

 private:
  int count_, next_ = 0;
  Camera camera_;
  std::uint16_t largest_;
};

// A cache of the test's own, so that tests do not see each other's recordings.
class Oni : public ::testing::Test {
 protected:
  Oni() { setenv("XDG_CACHE_HOME", (folder() / "cache").c_str(), 1); }
  fs::path folder() const { return temporary_.path(); }
  // Records `count` made-up frames.
  std::string record_file(const std::string& name, int count) const {
    MadeUpSource source(count);
    const std::string path = (folder() / name).string();
    const auto recorded = record(source, path);
    EXPECT_TRUE(recorded) << recorded.error().message;
    if (recorded) {
      EXPECT_EQ(recorded->frames, count);
    }
    return path;
  }

 private:
  test::TemporaryFolder temporary_;
};

std::vector<DepthFrame> read_all(DepthSource& source) {
  std::vector<DepthFrame> frames;
  for (int silent = 0; silent < 50;) {
    auto output = source.next(milliseconds(100));
    EXPECT_TRUE(output) << output.error().message;
    if (!output || output->event == SourceEvent::kEnd) return frames;
    if (output->event == SourceEvent::kFrame)
      frames.push_back(*output->frame);
    else
      ++silent;
  }
  ADD_FAILURE() << "the recording never ended";
  return frames;
}

TEST_F(Oni, PlaysBackBitForBitWhatWasRecorded) {
  const std::string path = record_file("a.oni", 12);
  const auto source = open_source(path);
  ASSERT_TRUE(source) << source.error().message;
  EXPECT_TRUE((*source)->is_recording());
  // OpenNI2 keeps the fields of view as float: seven digits of the focal length.
  EXPECT_NEAR((*source)->camera().fx, test_camera().fx, 1e-4);
  EXPECT_NEAR((*source)->camera().fy, test_camera().fy, 1e-4);
  EXPECT_EQ((*source)->camera().cx, 32);
  EXPECT_EQ((*source)->camera().cy, 24);
  EXPECT_EQ((*source)->camera().depth_unit_m, 0.001);
  const auto frames = read_all(**source);
  ASSERT_EQ(frames.size(), 12u);
  const MadeUpSource made(12);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    EXPECT_EQ(frames[i].index, static_cast<std::int64_t>(i));
    // The format's clock starts at 0 and counts microseconds.
    EXPECT_NEAR(frames[i].seconds, static_cast<double>(i) / 30, 2e-6 * static_cast<double>(i + 1));
    EXPECT_EQ(frames[i].depth, made.frame(static_cast<int>(i)).depth) << "frame " << i;
  }
  EXPECT_EQ((*source)->next(milliseconds(1))->event, SourceEvent::kEnd) << "the end stays the end";
}

TEST_F(Oni, IsTheSameRecordingAsADepthFolder) {
  const std::string path = record_file("a.oni", 5);
  const auto source = open_source(path);
  ASSERT_TRUE(source) << source.error().message;
  const auto recorded = record(**source, (folder() / "b").string());
  ASSERT_TRUE(recorded) << recorded.error().message;
  const auto again = open_source((folder() / "b").string());
  ASSERT_TRUE(again) << again.error().message;
  const auto frames = read_all(**again);
  ASSERT_EQ(frames.size(), 5u);
  for (int i = 0; i < 5; ++i)
    EXPECT_EQ(frames[static_cast<std::size_t>(i)].depth, MadeUpSource(5).frame(i).depth);
}

TEST_F(Oni, KeepsTenthsOfMillimetresAndTheLargestCounts) {
  Camera fine = test_camera();
  fine.depth_unit_m = 0.0001;
  MadeUpSource source(2, fine, 65534);
  const std::string path = (folder() / "a.oni").string();
  const auto recorded = record(source, path);
  ASSERT_TRUE(recorded) << recorded.error().message;
  const auto played = open_source(path);
  ASSERT_TRUE(played) << played.error().message;
  EXPECT_EQ((*played)->camera().depth_unit_m, 0.0001);
  const auto frames = read_all(**played);
  ASSERT_EQ(frames.size(), 2u);
  EXPECT_EQ(frames[1].depth, source.frame(1).depth);
}

TEST_F(Oni, StartsAtTheFrameAskedForByReadingOn) {
  const std::string path = record_file("a.oni", 8);
  const auto source = open_source(path, {.first_frame = 6});
  ASSERT_TRUE(source) << source.error().message;
  const auto frames = read_all(**source);
  ASSERT_EQ(frames.size(), 2u);
  EXPECT_EQ(frames[0].index, 6);
  EXPECT_EQ(frames[0].depth, MadeUpSource(8).frame(6).depth);
}

TEST_F(Oni, KeepsTheRecordedPaceWhenAskedTo) {
  const std::string path = record_file("a.oni", 3);
  const auto source = open_source(path, {.speed = 0.001});
  ASSERT_TRUE(source) << source.error().message;
  EXPECT_EQ((*source)->next(milliseconds(2000))->event, SourceEvent::kFrame);
  EXPECT_EQ((*source)->next(milliseconds(100))->event, SourceEvent::kTimeout);  // due after 33 s
}

TEST_F(Oni, OpensAndClosesManyTimes) {
  // Closing a file that has played to its end crashed OpenNI2 about once in ten times.
  const std::string path = record_file("a.oni", 2);
  const auto other = open_source(record_file("b.oni", 1));  // OpenNI2 stays initialised meanwhile
  ASSERT_TRUE(other) << other.error().message;
  for (int i = 0; i < 60; ++i) {
    const auto source = open_source(path);
    ASSERT_TRUE(source) << source.error().message;
    if (i % 3 == 0) continue;  // closed unread
    EXPECT_EQ((*source)->next(milliseconds(2000))->event, SourceEvent::kFrame);
    if (i % 3 == 1) continue;  // closed half way
    EXPECT_EQ(read_all(**source).size(), 1u);
  }
}

TEST_F(Oni, IsOpenOnceOnly) {
  const std::string path = record_file("a.oni", 2);
  const auto source = open_source(path);
  ASSERT_TRUE(source);
  const auto second = open_source(path);  // OpenNI2 would let both share one position
  ASSERT_FALSE(second);
  EXPECT_NE(second.error().message.find("is open already"), std::string::npos);
}

TEST_F(Oni, RefusesWhatTheFormatCannotHold) {
  Camera off = test_camera();
  off.cx = 31.5;
  MadeUpSource off_centre(1, off);
  Camera odd = test_camera();
  odd.depth_unit_m = 0.0002;
  MadeUpSource odd_unit(1, odd);
  MadeUpSource too_far(1, test_camera(), 65535);
  for (MadeUpSource* source : {&off_centre, &odd_unit, &too_far}) {
    const auto recorded = record(*source, (folder() / "a.oni").string());
    ASSERT_FALSE(recorded);
    EXPECT_EQ(recorded.error().code, ErrorCode::kBadInput);
    EXPECT_NE(recorded.error().message.find("depth folder"), std::string::npos)
        << recorded.error().message;
    EXPECT_FALSE(fs::exists(folder() / "a.oni"));
  }
}

TEST_F(Oni, NeverOverwritesARecording) {
  const std::string path = record_file("a.oni", 1);
  MadeUpSource source(1);
  const auto recorded = record(source, path);
  ASSERT_FALSE(recorded);
  EXPECT_EQ(recorded.error().code, ErrorCode::kUsage);
}

TEST_F(Oni, IsWrittenWholeOrNotAtAllWhenTheDiskIsFull) {
  MadeUpSource source(20);
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit tight{20000, before.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &tight), 0);
  const auto recorded = record(source, (folder() / "a.oni").string());
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  ASSERT_FALSE(recorded);
  EXPECT_EQ(recorded.error().code, ErrorCode::kIo) << recorded.error().message;
  EXPECT_NE(recorded.error().message.find("a.oni"), std::string::npos);
  for (const auto& entry : fs::directory_iterator(folder()))
    EXPECT_NE(entry.path().extension(), ".oni") << entry.path() << " was left behind";
}

// The error of opening a file and playing it through; nothing where that goes well.
std::optional<Error> refusal(const std::string& path) {
  auto source = open_source(path);
  if (!source) return source.error();
  for (int i = 0; i < 100; ++i) {
    auto output = (*source)->next(milliseconds(100));
    if (!output) return output.error();
    if (output->event == SourceEvent::kEnd) return std::nullopt;
  }
  return Error{ErrorCode::kInternal, "it hangs"};
}

TEST_F(Oni, RefusesDamagedFilesWithASentence) {
  const std::string good = *read_file(record_file("good.oni", 4));
  std::mt19937 random(1);
  std::string noise(20000, '\0');
  for (char& c : noise) c = static_cast<char>(random());
  struct Case {
    const char* name;
    std::string bytes;
  };
  const Case cases[] = {{"empty", ""},
                        {"random", noise},
                        {"text", "this is no recording"},
                        {"header only", good.substr(0, 12)},
                        {"cut in the header", good.substr(0, 300)},
                        {"cut in the frames", good.substr(0, good.size() / 2)}};
  for (const Case& one : cases) {
    SCOPED_TRACE(one.name);
    const std::string path = (folder() / "bad.oni").string();
    std::ofstream(path, std::ios::binary) << one.bytes;
    const auto error = refusal(path);
    ASSERT_TRUE(error);
    EXPECT_EQ(error->code, ErrorCode::kBadInput) << error->message;
    EXPECT_EQ(error->message.rfind(path, 0), 0u) << error->message;
  }
}

TEST_F(Oni, SurvivesDamagedHeaders) {
  const std::string good = *read_file(record_file("good.oni", 3));
  std::mt19937 random(7);
  int refused = 0;
  for (int i = 0; i < 25; ++i) {
    std::string bytes = good;
    for (int flip = 0; flip < 20; ++flip) bytes[random() % 700] = static_cast<char>(random());
    const std::string path = (folder() / ("bad" + std::to_string(i) + ".oni")).string();
    std::ofstream(path, std::ios::binary) << bytes;
    const auto error = refusal(path);
    if (!error) continue;  // the damage did not matter
    ++refused;
    EXPECT_EQ(error->code, ErrorCode::kBadInput) << error->message;
  }
  EXPECT_GT(refused, 5) << "the damage should matter most of the time";
}

TEST_F(Oni, IsPlayedForItsCheckOnceAFile) {
  const std::string path =
      record_file("a.oni", 9);  // no other test's bytes: this process remembers too
  EXPECT_TRUE(check_oni(path));
  const fs::path remembered = folder() / "cache" / "spoolsight" / "played-oni";
  ASSERT_TRUE(fs::is_directory(remembered));
  EXPECT_EQ(std::distance(fs::directory_iterator(remembered), fs::directory_iterator()), 1);
}

TEST_F(Oni, IsCheckedWithoutAWritableCacheToo) {
  const std::string path = record_file("a.oni", 2);
  setenv("XDG_CACHE_HOME", "/proc/no-such-place", 1);
  const Status checked = check_oni(path);
  EXPECT_TRUE(checked) << checked.error().message;
}

}  // namespace
}  // namespace spool::sensor
