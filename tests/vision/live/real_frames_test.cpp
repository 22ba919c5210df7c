// Three frames of a real hand-held sensor: followed, told what that is worth, and no design in
// them.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/sensor/depth_png.h"
#include "tests/support/shared_data.h"
#include "vision/align/tracker.h"
#include "vision/core/file_io.h"
#include "vision/design/design_reader.h"
#include "vision/live/find_in_picture.h"
#include "vision/live/frame_processor.h"
#include "vision/scan/back_projection.h"
#include "vision/scan/normals.h"

namespace spool {
namespace {

// As its README and the .xml beside each frame say.
Camera grabber_camera() {
  return {.width = 640, .height = 480, .fx = 525, .fy = 525, .cx = 320, .cy = 240};
}

// The seconds are those of the files' names. Empty where one cannot be read.
std::vector<std::shared_ptr<const DepthFrame>> grabber_frames(const std::filesystem::path& folder) {
  std::vector<std::shared_ptr<const DepthFrame>> frames;
  for (const double seconds : {55.814212, 56.068683, 56.332395}) {
    char name[64];
    std::snprintf(name, sizeof name, "frame_20121214T1422%09.6f_depth.png", seconds);
    const auto bytes = read_file(folder / name);
    if (!bytes) return {};
    auto depth = sensor::decode_depth_png(*bytes, 640, 480, name);
    if (!depth) return {};
    frames.push_back(std::make_shared<DepthFrame>(DepthFrame{
        static_cast<std::int64_t>(frames.size()), seconds, 640, 480, *std::move(depth)}));
  }
  return frames;
}

TrackedPose track(Tracker& tracker, const DepthFrame& frame) {
  const Camera camera = grabber_camera();
  auto cloud = back_project(frame, camera);
  EXPECT_TRUE(cloud);
  estimate_organised_normals(*cloud, camera, {});
  return tracker.track({*cloud, camera, {}, frame.seconds});
}

Pose pose_of(const Eigen::Vector3d& translation, const Eigen::Vector3d& turn) {
  Pose T(Eigen::AngleAxisd(turn.norm(), turn.normalized()));
  T.translation() = translation;
  return T;
}

// By Open3D 0.16.1: point-to-plane ICP with Tukey's kernel on 5 mm voxels, each frame onto the
// first, gates from 0.1 to 0.02 m, all three pairs closing to 0.2 mm and 0.007 degrees. Other
// kernels move it by up to 0.4 mm. No truth is known of these frames.
std::vector<Pose> by_open3d() {
  return {Pose::Identity(), pose_of({0.0024, 0.0067, -0.0026}, {0.0037, 0.0096, 0.0107}),
          pose_of({0.0034, 0.0107, -0.0052}, {-0.0059, 0.0142, 0.0142})};
}

TEST(RealFrames, AreFollowedAsAnotherProgramFollowsThem) {
  SPOOL_REQUIRE_SHARED(folder, "depth/pcl_grabber");
  const auto frames = grabber_frames(folder);
  ASSERT_EQ(frames.size(), 3U);
  const std::vector<Pose> theirs = by_open3d();
  Tracker tracker, straight;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    SCOPED_TRACE(i);
    const TrackedPose tracked = track(tracker, *frames[i]);
    EXPECT_EQ(name(tracked.quality), "good") << tracked.reason;
    EXPECT_GT(tracked.score, 0.9);
    EXPECT_TRUE(tracked.weak_directions.empty());
    // What `good` claims; the camera moved by 12 mm and 1.2 degrees in all.
    const PoseSize apart = pose_size(theirs[i].inverse() * tracked.T_map_camera);
    EXPECT_LT(apart.translation_m, 0.003);
    EXPECT_LT(apart.rotation_rad, 0.00524);
    if (i == 1) continue;
    // Over the middle frame or straight from the first to the last: the same place.
    const PoseSize loop =
        pose_size(track(straight, *frames[i]).T_map_camera.inverse() * tracked.T_map_camera);
    EXPECT_LT(loop.translation_m, 0.002);
    EXPECT_LT(loop.rotation_rad, 0.003);
    // Stated for the last frame: 0.7 mm and 0.04 degrees; the other program's pose is 1.4 mm and
    // 0.15 degrees away. Which of them is right is not known.
    const double u_m = 2 * largest_sigma(tracked.covariance.topLeftCorner<3, 3>());
    const double u_rad = 2 * largest_sigma(tracked.covariance.bottomRightCorner<3, 3>());
    EXPECT_LT(u_m, 0.003);
    EXPECT_LT(u_rad, 0.00524);
    if (i == 0) continue;
    EXPECT_GT(u_m, 0.0001) << "no frame of such a sensor is known to a tenth of a millimetre";
    EXPECT_GT(u_rad, 0.0001);
  }
}

// A laptop and a box on a floor: the sample spool is not among them, and nothing makes it be.
TEST(RealFrames, ShowNoSpool) {
  SPOOL_REQUIRE_SHARED(folder, "depth/pcl_grabber");
  const auto frames = grabber_frames(folder);
  ASSERT_EQ(frames.size(), 3U);
  auto model = read_design((test::source_dir() / "assets/sample/spool.glb").string());
  ASSERT_TRUE(model) << model.error().message;
  const auto design = PreparedDesign::prepare(*std::move(model), 1, true);
  ASSERT_TRUE(design) << design.error().message;
  FrameProcessor vision(*design, grabber_camera(), NoiseModel{});
  const auto held = vision.process(frames[0]);
  ASSERT_TRUE(held) << held.error().message;
  EXPECT_EQ((*held)->camera, PoseQuality::kGood);
  const FindAnswer answer =
      find_in_picture(*design, *(*design)->finder, **held, grabber_camera(), NoiseModel{});
  EXPECT_TRUE(answer.poses.empty());
  EXPECT_FALSE(answer.reason.empty());
  // Said to lie on the floor before the camera, it is not believed either.
  Pose T_camera_design = Pose::Identity();
  T_camera_design.translation() = Eigen::Vector3d(0, 0.1, 1.0) - (*design)->model.bounds().center();
  const auto aligned = vision.align(**held, T_camera_design.inverse());
  EXPECT_EQ(aligned->quality, TrackQuality::kUnaligned);
  EXPECT_FALSE(aligned->hint.empty());
  for (std::size_t i = 1; i < frames.size(); ++i) {
    const auto state = vision.process(frames[i]);
    ASSERT_TRUE(state) << state.error().message;
    EXPECT_EQ((*state)->quality, TrackQuality::kUnaligned);
    EXPECT_EQ((*state)->camera, PoseQuality::kGood) << "the scene is followed all the same";
    EXPECT_TRUE((*state)->scan_design.empty());
  }
}

}  // namespace
}  // namespace spool
