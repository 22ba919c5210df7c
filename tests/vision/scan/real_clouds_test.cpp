// Files of strangers: their points counted, a real depth frame against the cloud its maker made
// of it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>

#include "tests/support/shared_data.h"
#include "vision/core/file_io.h"
#include "vision/scan/back_projection.h"
#include "vision/scan/cloud_file.h"

namespace spool {
namespace {

// A big-endian 16-bit PGM: "P5", width, height, 65535 and the readings.
DepthFrame read_pgm(const std::filesystem::path& path) {
  const auto bytes = read_file(path);
  if (!bytes) return {};
  DepthFrame frame;
  int most = 0, used = 0;
  if (std::sscanf(bytes->c_str(), "P5 %d %d %d%n", &frame.width, &frame.height, &most, &used) != 3)
    return {};
  const auto* at = reinterpret_cast<const unsigned char*>(bytes->data()) + used + 1;
  frame.depth.resize(static_cast<std::size_t>(frame.width * frame.height));
  for (auto& depth : frame.depth) {
    depth = static_cast<std::uint16_t>(at[0] * 256 + at[1]);
    at += 2;
  }
  return frame;
}

TEST(RealClouds, ABackProjectedFrameIsTheMakersOwnCloud) {
  SPOOL_REQUIRE_SHARED(folder, "depth/pcl_grabber");
  const DepthFrame frame = read_pgm(folder / "frame_20121214T142255.814212_depth.pgm");
  ASSERT_TRUE(frame.is_consistent());
  const auto cloud = back_project(
      frame, {.width = 640, .height = 480, .fx = 525, .fy = 525, .cx = 320, .cy = 240});
  ASSERT_TRUE(cloud);
  const auto file = read_cloud(folder / "frame_20121214T142255.814212.pcd", LengthUnit::kMetre);
  ASSERT_TRUE(file) << file.error().message;
  ASSERT_EQ(file->cloud.size(), 307200U);
  EXPECT_EQ(file->finite, 271575U);
  EXPECT_EQ(file->cloud.width, 640);
  std::size_t finite = 0;
  for (std::size_t i = 0; i < frame.depth.size(); ++i) {
    const Eigen::Vector3f &ours = cloud->points[i], &theirs = file->cloud.points[i];
    ASSERT_EQ(ours.array().isNaN().all(), frame.depth[i] == 0);
    ASSERT_EQ(ours.array().isNaN().all(), theirs.array().isNaN().any());
    if (frame.depth[i] == 0) continue;
    ++finite;
    ASSERT_LE((ours - theirs).cwiseAbs().maxCoeff(), 1e-6F) << i;
  }
  EXPECT_EQ(finite, 271575U);
}

TEST(RealClouds, HaveThePointsThatTheirReadmeCounts) {
  SPOOL_REQUIRE_SHARED(folder, "clouds");
  struct Row {
    const char* path;
    std::size_t points, finite;
    int width;
    const char* unit;
    bool has_normals = false;
  };
  for (const Row& row :
       {Row{"pcl_milk/milk.pcd", 12575, 12575, 0, "m"},
        Row{"pcl_milk/milk_cartoon_all_small_clorox.pcd", 307200, 241407, 640, "m"},
        Row{"pcl_mug/table_scene_mug_stereo_textured.pcd", 307200, 209280, 640, "m"},
        Row{"pcl_pairwise/capture0001.pcd", 307200, 249647, 640, "m"},
        Row{"pcl_pairwise/capture0002.pcd", 307200, 249931, 640, "m"},
        Row{"pcl_room/room_scan1.pcd", 112586, 112586, 0, "m"},
        Row{"pcl_room/room_scan2.pcd", 112624, 112624, 0, "m"},
        Row{"pcl_ascii/object_template_0.pcd", 1397, 1397, 0, "m"},
        Row{"pcl_ascii/lamppost.pcd", 1771, 1771, 0, "m"},
        Row{"pcl_ascii/min_cut_segmentation_tutorial.pcd", 9311, 9311, 0, "m"},
        Row{"lidar_pair/source.ply", 69792, 69792, 0, "m"},
        Row{"lidar_pair/target.ply", 69088, 69088, 0, "m"},
        Row{"pipe_sampled/length_a1.txt", 26872, 26872, 0, "mm", true},
        Row{"pipe_sampled/length_a2.txt", 52717, 52717, 0, "mm", true}}) {
    const auto file = read_cloud(folder / row.path, std::nullopt);
    ASSERT_TRUE(file) << row.path << ": " << file.error().message;
    EXPECT_EQ(file->cloud.size(), row.points) << row.path;
    EXPECT_EQ(file->finite, row.finite) << row.path;
    EXPECT_EQ(file->cloud.width, row.width) << row.path;
    EXPECT_EQ(name(file->unit), row.unit) << row.path;
    EXPECT_EQ(file->cloud.has_normals(), row.has_normals) << row.path;
    EXPECT_TRUE(file->unit_inferred) << row.path;
  }
}

TEST(RealClouds, TheSampledPipeIsAsLongAndThickAsItsReadmeSays) {
  SPOOL_REQUIRE_SHARED(folder, "clouds/pipe_sampled");
  const Eigen::Vector3d axis = Eigen::Vector3d(0.411, 0.912, -0.004).normalized();
  struct Row {
    const char* path;
    double length_m;
  };
  for (const Row& row : {Row{"length_a1.txt", 1.5}, Row{"length_a2.txt", 3.0}}) {
    const auto file = read_cloud(folder / row.path, LengthUnit::kMillimetre);
    ASSERT_TRUE(file);
    double low = 1e9, high = -1e9;
    for (const Eigen::Vector3f& point : file->cloud.points) {
      low = std::min(low, axis.dot(point.cast<double>()));
      high = std::max(high, axis.dot(point.cast<double>()));
    }
    // The axis is printed to 1e-3: over 1.5 m of pipe of 55 mm radius that is under 0.2 mm of
    // length.
    EXPECT_NEAR(high - low, row.length_m, 0.0005) << row.path;
  }
}

TEST(RealClouds, MeshesOfEveryOddKindAreReadOrRefused) {
  SPOOL_REQUIRE_SHARED(folder, "robust/mesh");
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (!is_cloud_file(entry.path())) continue;
    const auto file = read_cloud(entry.path(), LengthUnit::kMetre);
    if (file) {
      EXPECT_TRUE(file->cloud.is_consistent()) << entry.path();
      EXPECT_GT(file->finite, 0U) << entry.path();
    } else {
      EXPECT_NE(file.error().message.find(entry.path().filename().string()), std::string::npos);
    }
  }
}

}  // namespace
}  // namespace spool
