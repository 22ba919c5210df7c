// Tests of thinning by a voxel grid.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/scan/thinning.h"

#include <cmath>
#include <map>
#include <random>
#include <set>

#include <gtest/gtest.h>

namespace spool {
namespace {

PointCloud pipe(int count) {
  std::mt19937 random{5};
  std::uniform_real_distribution<float> unit(-1, 1);
  PointCloud cloud;
  for (int i = 0; i < count; ++i) {
    const float angle = 3.14159265F * unit(random);
    cloud.points.emplace_back(0.2F * std::cos(angle), 0.2F * std::sin(angle), unit(random));
    cloud.normals.emplace_back(std::cos(angle), std::sin(angle), 0.0F);
  }
  cloud.points[10].x() = NAN;
  return cloud;
}

std::array<long, 3> cell_of(const Eigen::Vector3f& point, double cell_m) {
  std::array<long, 3> cell{};
  for (int axis = 0; axis < 3; ++axis)
    cell[static_cast<std::size_t>(axis)] = std::lround(std::floor(double{point[axis]} / cell_m));
  return cell;
}

TEST(Thinning, LeavesTheMeanOfEachOccupiedCell) {
  const PointCloud cloud = pipe(20000);
  constexpr double kCell = 0.03;
  struct Sum {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    int count = 0;
  };
  std::map<std::array<long, 3>, Sum> oracle;
  for (const Eigen::Vector3f& point : cloud.points) {
    if (!point.allFinite()) continue;
    Sum& sum = oracle[cell_of(point, kCell)];
    sum.sum += point.cast<double>();
    ++sum.count;
  }
  const PointCloud thin = thin_to_voxels(cloud, kCell);
  ASSERT_EQ(thin.size(), oracle.size());
  ASSERT_TRUE(thin.has_normals());
  std::set<std::array<long, 3>> seen;
  for (std::size_t i = 0; i < thin.size(); ++i) {
    // The cell is taken from the input point beside the mean: a mean can lie on a face by rounding.
    const auto cell = cell_of(cloud.points[thin.pixels[i]], kCell);
    ASSERT_TRUE(seen.insert(cell).second) << "two points of one cell";
    const Sum& sum = oracle.at(cell);
    ASSERT_LT((thin.points[i].cast<double>() - sum.sum / sum.count).norm(), 1e-7);
    ASSERT_NEAR(thin.normals[i].norm(), 1.0F, 1e-5F);
  }
}

TEST(Thinning, NamesTheInputPointNearestToTheMean) {
  const PointCloud cloud = pipe(3000);
  const PointCloud thin = thin_to_voxels(cloud, 0.05);
  for (std::size_t i = 0; i < thin.size(); ++i) {
    const auto cell = cell_of(cloud.points[thin.pixels[i]], 0.05);
    const float best = (cloud.points[thin.pixels[i]] - thin.points[i]).norm();
    for (const Eigen::Vector3f& point : cloud.points)
      if (point.allFinite() && cell_of(point, 0.05) == cell) {
        ASSERT_GE((point - thin.points[i]).norm(), best * 0.99999F);
      }
  }
}

TEST(Thinning, DoesNothingToWhatIsThinAlready) {
  const PointCloud once = thin_to_voxels(pipe(20000), 0.03);
  const PointCloud twice = thin_to_voxels(once, 0.03);
  // A mean that rounds onto a face may change its cell: none did in this cloud.
  ASSERT_EQ(twice.size(), once.size());
  for (std::size_t i = 0; i < once.size(); ++i) ASSERT_EQ(twice.points[i], once.points[i]);
}

TEST(Thinning, IsTheSameTwiceAndSurvivesNothingFinite) {
  const PointCloud cloud = pipe(5000);
  const PointCloud a = thin_to_voxels(cloud, 0.02), b = thin_to_voxels(cloud, 0.02);
  EXPECT_TRUE(a.points == b.points && a.pixels == b.pixels);
  PointCloud nothing;
  nothing.points = {{NAN, 0, 0}};
  EXPECT_TRUE(thin_to_voxels(nothing, 0.02).empty());
  EXPECT_TRUE(thin_to_voxels(PointCloud{}, 0.02).empty());
}

TEST(Thinning, TakesCoordinatesAsFarOffAsAFloatGoes) {
  PointCloud cloud;
  cloud.points = {{3e38F, -3e38F, 0}, {-0.0F, 0, 0}, {0.0F, 0, 0}, {1e-30F, 0, 0}};
  EXPECT_EQ(thin_to_voxels(cloud, 1e-3).size(), 2U);  // the two zeros are one place
}

TEST(Thinning, OppositeNormalsLeaveNone) {
  PointCloud cloud;
  cloud.points = {{0.1F, 0.1F, 0.1F}, {0.2F, 0.1F, 0.1F}};
  cloud.normals = {{0, 0, 1}, {0, 0, -1}};
  const PointCloud thin = thin_to_voxels(cloud, 1.0);
  ASSERT_EQ(thin.size(), 1U);
  EXPECT_EQ(thin.normals[0], Eigen::Vector3f(0, 0, 0));
}

TEST(VoxelSize, LeavesAboutAsManyAsAskedAndNeverFivePercentOver) {
  const PointCloud cloud = pipe(60000);
  for (const std::size_t target : {200UL, 700UL, 5000UL, 20000UL, 50000UL}) {
    const double cell = voxel_size_for(cloud, target);
    const std::size_t left = thin_to_voxels(cloud, cell).size();
    EXPECT_LE(left, target * 21 / 20) << target;
    EXPECT_GE(left, target * 17 / 20) << target;
  }
}

TEST(VoxelSize, IsZeroWhereThereAreFewEnoughAndPositiveForDuplicates) {
  const PointCloud cloud = pipe(1000);  // 999 are finite
  EXPECT_EQ(voxel_size_for(cloud, 999), 0.0);
  PointCloud heap;
  heap.points.assign(1000, {1, 2, 3});
  const double cell = voxel_size_for(heap, 10);
  EXPECT_GT(cell, 0.0);
  EXPECT_EQ(thin_to_voxels(heap, cell).size(), 1U);
}

}  // namespace
}  // namespace spool
