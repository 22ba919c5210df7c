// Depth folders: what is written is read bit for bit; what is wrong is refused by name.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/sensor/depth_folder.h"

#include <csignal>
#include <random>

#include <sys/resource.h>

#include <gtest/gtest.h>

#include "app/sensor/depth_png.h"
#include "app/sensor/depth_source.h"
#include "tests/support/depth_files.h"
#include "tests/support/refusal.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/write_file.h"
#include "vision/core/file_io.h"

namespace spool::sensor {
namespace {

namespace fs = std::filesystem;
using std::chrono::milliseconds;
using test::CameraText;
using test::write_file;

Camera small_camera() {
  Camera camera;
  camera.width = 37;  // odd, so that rows do not align
  camera.height = 23;
  camera.fx = 31.5;
  camera.fy = 32.25;
  camera.cx = 18;
  camera.cy = 11.125;
  camera.depth_unit_m = 0.0002;
  return camera;
}

DepthFrame random_frame(const Camera& camera, std::int64_t index) {
  std::mt19937 random(static_cast<unsigned>(index) + 1);
  std::uniform_int_distribution<int> count(0, 65535);
  DepthFrame frame;
  frame.index = index;
  frame.seconds = 0.25 + 0.033 * static_cast<double>(index);
  frame.width = camera.width;
  frame.height = camera.height;
  frame.depth.resize(static_cast<std::size_t>(camera.width * camera.height));
  for (auto& depth : frame.depth) depth = static_cast<std::uint16_t>(count(random));
  return frame;
}

// A folder of `count` frames.
void write_folder(const fs::path& folder, int count) {
  auto writer = DepthFolderWriter::create(folder, small_camera());
  ASSERT_TRUE(writer) << writer.error().message;
  for (int i = 0; i < count; ++i) {
    const Status written = writer->write(random_frame(small_camera(), i));
    ASSERT_TRUE(written) << written.error().message;
  }
}

std::vector<DepthFrame> read_all(DepthSource& source) {
  std::vector<DepthFrame> frames;
  for (;;) {
    auto output = source.next(milliseconds(0));
    EXPECT_TRUE(output) << output.error().message;
    if (!output || output->event != SourceEvent::kFrame) {
      if (output) {
        EXPECT_EQ(output->event, SourceEvent::kEnd);
      }
      return frames;
    }
    frames.push_back(*output->frame);
  }
}

// The error of opening `folder` and reading it through.
Error refusal(const fs::path& folder) {
  auto source = open_source(folder.string());
  if (!source) return source.error();
  for (;;) {
    auto output = (*source)->next(milliseconds(0));
    if (!output) return output.error();
    if (output->event == SourceEvent::kEnd) return {ErrorCode::kInternal, "nothing was refused"};
  }
}

TEST(DepthFolder, GivesBackBitForBitWhatWasWritten) {
  const test::TemporaryFolder temporary;
  write_folder(temporary.path() / "a", 3);
  const auto source = open_source((temporary.path() / "a").string());
  ASSERT_TRUE(source) << source.error().message;
  EXPECT_TRUE((*source)->is_recording());
  const Camera& camera = (*source)->camera();
  EXPECT_EQ(camera.fx, small_camera().fx);
  EXPECT_EQ(camera.cy, small_camera().cy);
  EXPECT_EQ(camera.depth_unit_m, small_camera().depth_unit_m);
  const auto frames = read_all(**source);
  ASSERT_EQ(frames.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    const DepthFrame expected = random_frame(small_camera(), static_cast<std::int64_t>(i));
    EXPECT_EQ(frames[i].index, expected.index);
    EXPECT_NEAR(frames[i].seconds, expected.seconds, 1e-6);  // the file holds microseconds
    EXPECT_EQ(frames[i].depth, expected.depth);
  }
}

TEST(DepthFolder, StartsAtTheFrameAskedFor) {
  const test::TemporaryFolder temporary;
  write_folder(temporary.path() / "a", 3);
  const auto source = open_source((temporary.path() / "a").string(), {.first_frame = 2});
  ASSERT_TRUE(source);
  const auto frames = read_all(**source);
  ASSERT_EQ(frames.size(), 1u);
  EXPECT_EQ(frames[0].index, 2);
  const auto beyond = open_source((temporary.path() / "a").string(), {.first_frame = 9});
  ASSERT_TRUE(beyond);
  EXPECT_TRUE(read_all(**beyond).empty());
}

TEST(DepthFolder, KeepsTheRecordedPaceWhenAskedTo) {
  const test::TemporaryFolder temporary;
  write_folder(temporary.path() / "a", 2);
  // A thousandth of real time: the second frame is due after 33 s and is not given before.
  const auto source = open_source((temporary.path() / "a").string(), {.speed = 0.001});
  ASSERT_TRUE(source);
  EXPECT_EQ((*source)->next(milliseconds(0))->event, SourceEvent::kFrame);
  EXPECT_EQ((*source)->next(milliseconds(5))->event, SourceEvent::kTimeout);
}

TEST(DepthFolder, WithoutTimesRunsAtThirtyFramesASecond) {
  const test::TemporaryFolder temporary;
  write_folder(temporary.path() / "a", 2);
  fs::remove(temporary.path() / "a" / "times.csv");
  const auto folder = read_depth_folder(temporary.path() / "a");
  ASSERT_TRUE(folder);
  EXPECT_NEAR(folder->files[1].seconds, 1.0 / 30, 1e-12);
}

TEST(DepthFolder, ReadsTheListOfTum) {
  const test::TemporaryFolder temporary;
  const fs::path folder = temporary.path() / "a";
  write_folder(folder, 3);
  fs::remove(folder / "times.csv");
  write_file(folder / "depth.txt", "# depth maps\n# file: a.bag\n10.5 depth/000002.png\r\n");
  const auto read = read_depth_folder(folder);
  ASSERT_TRUE(read) << read.error().message;
  ASSERT_EQ(read->files.size(), 1u);
  EXPECT_EQ(read->files[0].seconds, 10.5);
  write_file(folder / "depth.txt", "10.5 ../../etc/passwd\n");
  EXPECT_NE(refusal(folder).message.find("depth.txt: line 1"), std::string::npos);
}

TEST(DepthFolder, RefusesDamagedAndForeignFilesByName) {
  struct Case {
    const char* name;
    void (*damage)(const fs::path& folder);
    const char* says;
  };
  const Case cases[] = {
      {"no camera", [](const fs::path& f) { fs::remove(f / "camera.json"); }, "no camera.json"},
      {"no images", [](const fs::path& f) { fs::remove_all(f / "depth"); }, "cannot be listed"},
      {"empty folder",
       [](const fs::path& f) {
         fs::remove_all(f / "depth");
         fs::create_directory(f / "depth");
       },
       "holds no depth image"},
      {"truncated image",
       [](const fs::path& f) { fs::resize_file(f / "depth" / "000001.png", 900); },
       "000001.png: is not a depth image of 37 x 23 pixels"},
      {"empty image", [](const fs::path& f) { fs::resize_file(f / "depth" / "000001.png", 0); },
       "the file is cut short"},
      {"no image",
       [](const fs::path& f) { write_file(f / "depth" / "000001.png", std::string(5000, 'x')); },
       "000001.png"},
      {"wrong size",
       [](const fs::path& f) {
         const std::vector<std::uint16_t> depth(36 * 23, 7);
         write_file(f / "depth" / "000001.png", test::grey_png(depth, 36, 23));
       },
       "its size is not the camera's"},
      {"not a number in camera.json",
       [](const fs::path& f) {
         write_file(f / "camera.json",
                    CameraText{.width = "37", .height = "23", .fx = "NaN"}.json());
       },
       "camera.json"},
      {"infinite focal length",
       [](const fs::path& f) {
         write_file(f / "camera.json",
                    CameraText{.width = "37", .height = "23", .fx = "1e999"}.json());
       },
       "camera.json"},
      {"a huge image and a small file",
       [](const fs::path& f) {
         write_file(f / "camera.json", CameraText{.width = "16384", .height = "16384"}.json());
       },
       "the file is cut short"},
      {"time missing",
       [](const fs::path& f) { write_file(f / "times.csv", "frame,seconds\n0,0\n"); },
       "has no time for frame 1"},
      {"time not finite",
       [](const fs::path& f) { write_file(f / "times.csv", "frame,seconds\n0,nan\n1,1\n"); },
       "times.csv: line 2"},
      {"time runs back",
       [](const fs::path& f) { write_file(f / "times.csv", "frame,seconds\n0,5\n1,1\n"); },
       "is earlier than the frame before it"},
  };
  for (const Case& one : cases) {
    SCOPED_TRACE(one.name);
    const test::TemporaryFolder temporary;
    const fs::path folder = temporary.path() / "a";
    write_folder(folder, 2);
    one.damage(folder);
    test::expect_sentence(refusal(folder), ErrorCode::kBadInput, folder.string(), one.says);
  }
}

TEST(DepthFolder, RefusesImagesThatAreNotSixteenBitGrey) {
  const std::vector<std::uint16_t> depth(12, 0x1234);
  const auto sixteen = decode_depth_png(test::grey_png(depth, 4, 3), 4, 3, "a.png");
  ASSERT_TRUE(sixteen) << sixteen.error().message;
  EXPECT_EQ(*sixteen, depth);
  test::expect_refused(decode_depth_png(test::grey_png(depth, 4, 3, 8), 4, 3, "a.png"),
                       ErrorCode::kBadInput, "a.png: ", "it is not 16-bit grey");
}

TEST(DepthFolderWriter, NeverMixesIntoAFolderThatHoldsSomething) {
  const test::TemporaryFolder temporary;
  write_folder(temporary.path() / "a", 1);
  const auto writer = DepthFolderWriter::create(temporary.path() / "a", small_camera());
  ASSERT_FALSE(writer);
  EXPECT_EQ(writer.error().code, ErrorCode::kUsage);
}

TEST(DepthFolderWriter, RefusesAFrameOfAnotherSize) {
  const test::TemporaryFolder temporary;
  auto writer = DepthFolderWriter::create(temporary.path() / "a", small_camera());
  ASSERT_TRUE(writer);
  Camera other = small_camera();
  other.width = 36;
  const Status status = writer->write(random_frame(other, 0));
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, ErrorCode::kBadInput);
}

TEST(DepthFolderWriter, KeepsWhatItHasWhenTheDiskIsFull) {
  const test::TemporaryFolder temporary;
  const fs::path folder = temporary.path() / "a";
  auto writer = DepthFolderWriter::create(folder, small_camera());
  ASSERT_TRUE(writer);
  ASSERT_TRUE(writer->write(random_frame(small_camera(), 0)));
  // A limit on the size of files fails a write as a full disk does.
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit tight{1000, before.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &tight), 0);
  const Status status = writer->write(random_frame(small_camera(), 1));
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, ErrorCode::kIo);
  EXPECT_NE(status.error().message.find("000001.png"), std::string::npos) << status.error().message;
  const auto source = open_source(folder.string());
  ASSERT_TRUE(source) << source.error().message;
  EXPECT_EQ(read_all(**source).size(), 1u);
}

TEST(DepthFolder, OpensTheHandHeldScene) {
  SPOOL_REQUIRE_SHARED(folder, "scenes/spool1_handheld");
  const auto source = open_source(folder.string());
  ASSERT_TRUE(source) << source.error().message;
  EXPECT_EQ((*source)->camera().width, 640);
  EXPECT_EQ((*source)->camera().fx, 575.8);
  const auto frames = read_all(**source);
  ASSERT_EQ(frames.size(), 60u);
  EXPECT_NEAR(frames[1].seconds, 0.030293, 1e-9);
}

TEST(DepthFolder, ReadsARealSensorsImage) {
  SPOOL_REQUIRE_SHARED(path, "depth/pcl_grabber/frame_20121214T142255.814212_depth.png");
  const auto bytes = read_file(path);
  ASSERT_TRUE(bytes);
  const auto depth = decode_depth_png(*bytes, 640, 480, path.string());
  ASSERT_TRUE(depth) << depth.error().message;
  // The counts its README gives.
  EXPECT_EQ(std::count_if(depth->begin(), depth->end(), [](auto d) { return d > 0; }), 271575);
  EXPECT_EQ(*std::max_element(depth->begin(), depth->end()), 1713);
}

}  // namespace
}  // namespace spool::sensor
