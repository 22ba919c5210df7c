// Tests of density normalisation: means of leaves, and an even density from an uneven one.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/scan/octree_thinning.h"

#include <cmath>
#include <map>
#include <random>

#include <gtest/gtest.h>

namespace spool {
namespace {

// A plate 2 m by 1 m whose left half has twenty times the points of its right one.
PointCloud uneven_plate() {
  std::mt19937 random{1};
  std::uniform_real_distribution<float> unit(0, 1);
  PointCloud plate;
  for (int i = 0; i < 42000; ++i) {
    const float x = (i % 21 == 0 ? 1.0F : 0.0F) + unit(random);
    plate.points.emplace_back(x, unit(random), 0.1F * x);
    plate.normals.emplace_back(-0.0995037F, 0, 0.9950372F);
  }
  plate.points[5].x() = NAN;
  return plate;
}

TEST(OctreeThinning, EvensOutTheDensity) {
  const PointCloud plate = uneven_plate();
  for (const OctreeSplit split : {OctreeSplit::kEqual, OctreeSplit::kWeighted}) {
    const PointCloud thin = thin_by_octree(plate, even_leaves(0.15, split));
    double left = 0, right = 0;
    for (const auto& p : thin.points) (p.x() < 1 ? left : right) += 1;
    EXPECT_GT(left, 100);
    // 20 to 1 before. Equal leaves leave none of it; weighted ones, drawn to the dense side, differ
    // by less than a level, a factor of 8.
    const double allowed = split == OctreeSplit::kEqual ? 1.1 : 8.0;
    EXPECT_LT(left / right, allowed);
    EXPECT_LT(right / left, allowed);
  }
}

TEST(OctreeThinning, GivesTheMeanOfEveryLeafAndNamesThePointNearestToIt) {
  const PointCloud plate = uneven_plate();
  const OctreeOptions options = even_leaves(0.2);
  const Octree tree(plate.points, options);
  std::map<std::int32_t, std::pair<Eigen::Vector3d, double>> leaves;
  for (std::size_t i = 0; i < plate.size(); ++i) {
    if (tree.point_bins()[i] < 0) continue;
    auto& [sum, count] =
        leaves.try_emplace(tree.point_bins()[i], Eigen::Vector3d::Zero(), 0.0).first->second;
    sum += plate.points[i].cast<double>();
    count += 1;
  }
  const PointCloud thin = thin_by_octree(plate, options);
  ASSERT_EQ(thin.size(), leaves.size());
  ASSERT_TRUE(thin.is_consistent() && thin.has_normals());
  for (std::size_t i = 0; i < thin.size(); ++i) {
    const std::int32_t leaf = tree.point_bins()[thin.pixels[i]];
    const auto& [sum, count] = leaves.at(leaf);
    EXPECT_LT((thin.points[i].cast<double>() - sum / count).norm(), 1e-6);  // a float's rounding
    EXPECT_LT((thin.normals[i] - plate.normals[0]).norm(), 1e-5F);
    const float best = (plate.points[thin.pixels[i]] - thin.points[i]).norm();
    for (std::size_t k = 0; k < plate.size(); ++k)
      if (tree.point_bins()[k] == leaf) {
        ASSERT_GE((plate.points[k] - thin.points[i]).norm(), best);
      }
  }
}

TEST(OctreeThinning, NothingGivesNothingAndOneGivesItself) {
  EXPECT_TRUE(thin_by_octree({}, even_leaves(0.1)).empty());
  PointCloud cloud;
  cloud.points = {{NAN, 0, 0}};
  EXPECT_TRUE(thin_by_octree(cloud, even_leaves(0.1)).empty());
  cloud.points = {{1, 2, 3}};
  EXPECT_EQ(thin_by_octree(cloud, even_leaves(0.1)).points, cloud.points);
}

TEST(OctreeThinning, OppositeNormalsLeaveNone) {
  PointCloud cloud;
  cloud.points = {{0, 0, 0}, {0.01F, 0, 0}};
  cloud.normals = {{0, 0, 1}, {0, 0, -1}};
  const PointCloud thin = thin_by_octree(cloud, even_leaves(1.0));
  ASSERT_EQ(thin.size(), 1U);
  EXPECT_EQ(thin.normals[0], Eigen::Vector3f(0, 0, 0));
}

}  // namespace
}  // namespace spool
