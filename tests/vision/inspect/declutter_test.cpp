// The thesis's declutter against brute force and against the thesis's own arithmetic.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/inspect/declutter.h"

#include <algorithm>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace spool {
namespace {

std::vector<Eigen::Vector3f> random_points(std::size_t count, float size, std::mt19937& random) {
  std::uniform_real_distribution<float> unit(0, size);
  std::vector<Eigen::Vector3f> points(count);
  for (auto& p : points) p = {unit(random), unit(random), unit(random)};
  return points;
}

TEST(Declutter, ClosedFormGivesThePlaneOfTheThesisOnItsOwnTable) {
  // Sizes of Table 5-4. By hand 10.2 14.9 6.3 7.9 10.6 8.6 5.5, whose mean is a0 = 9.143 as it must
  // be. (The thesis prints 10 11 9 14 12 13 15, which are not its plane's.)
  struct Row {
    std::size_t scene, model;
    int k;
  };
  for (const Row& row :
       {Row{81272, 12061, 10}, Row{145265, 12061, 15}, Row{28009, 12061, 6}, Row{108007, 8864, 8},
        Row{108007, 10841, 11}, Row{108007, 9327, 9}, Row{74569, 8864, 5}})
    EXPECT_EQ(k_closed_form(row.scene, row.model), row.k) << row.scene << " " << row.model;
  EXPECT_EQ(k_closed_form(93305, 10583), 9);  // the means: a0 = 9.143
  EXPECT_EQ(k_closed_form(1000, 2000), 1);    // the plane is negative there; K is at least one
}

TEST(Declutter, RatioIsSceneOverModel) {
  EXPECT_EQ(k_ratio(81272, 12061), 7);  // Table 5-1's "M/S" row (it is S/M)
  EXPECT_EQ(k_ratio(100, 12061), 1);
  EXPECT_EQ(k_ratio(100, 0), 1);
}

TEST(Declutter, KeepsWhatBruteForceKeeps) {
  std::mt19937 random{1};
  const auto scan = random_points(700, 1.0F, random);
  const auto model = random_points(60, 0.5F, random);
  for (const int k : {1, 4, 9}) {
    const DeclutterResult found = declutter_knn(CloudView(scan), CloudView(model), {.k = k});
    std::vector<PointClass> expected(scan.size(), PointClass::kClutter);
    for (const auto& m : model) {
      std::vector<std::size_t> order(scan.size());
      for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
      std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return (scan[a] - m).squaredNorm() < (scan[b] - m).squaredNorm();
      });
      for (int i = 0; i < k; ++i)
        expected[order[static_cast<std::size_t>(i)]] = PointClass::kObject;
    }
    EXPECT_EQ(found.classes, expected) << "K = " << k;
    EXPECT_EQ(found.k, k);
    EXPECT_EQ(found.object + found.clutter, scan.size());
    EXPECT_EQ(found.object, static_cast<std::size_t>(
                                std::count(expected.begin(), expected.end(), PointClass::kObject)));
  }
}

TEST(Declutter, NeighboursAreFoundHoweverFarTheyAre) {
  const std::vector<Eigen::Vector3f> scan = {{100, 0, 0}, {101, 0, 0}};
  const std::vector<Eigen::Vector3f> model = {{0, 0, 0}};
  const DeclutterResult found = declutter_knn(CloudView(scan), CloudView(model), {.k = 1});
  EXPECT_EQ(found.classes[0], PointClass::kObject);
  EXPECT_EQ(found.classes[1], PointClass::kClutter);
}

TEST(Declutter, PointsThatAreNotFiniteAreClutterAndDoNotCount) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float inf = std::numeric_limits<float>::infinity();
  const std::vector<Eigen::Vector3f> scan = {{nan, 0, 0}, {0.1F, 0, 0}, {0, inf, 0}, {5, 0, 0}};
  const std::vector<Eigen::Vector3f> model = {{0, 0, 0}};
  const DeclutterResult found = declutter_knn(CloudView(scan), CloudView(model));
  EXPECT_EQ(found.k, 2);  // two finite points over one
  EXPECT_EQ(found.classes[0], PointClass::kClutter);
  EXPECT_EQ(found.classes[1], PointClass::kObject);
  EXPECT_EQ(found.classes[2], PointClass::kClutter);
  EXPECT_EQ(found.classes[3], PointClass::kObject);
}

TEST(Declutter, TheMethodChoosesK) {
  std::mt19937 random{2};
  const auto scan = random_points(900, 1.0F, random);
  const auto model = random_points(100, 1.0F, random);
  EXPECT_EQ(declutter_knn(CloudView(scan), CloudView(model)).k, 9);
  EXPECT_EQ(
      declutter_knn(CloudView(scan), CloudView(model), {.method = DeclutterMethod::kKnnClosedForm})
          .k,
      k_closed_form(900, 100));
}

TEST(Declutter, EmptyCloudsGiveEmptyAnswers) {
  EXPECT_EQ(declutter_knn({}, {}).classes.size(), 0U);
  const std::vector<Eigen::Vector3f> scan = {{0, 0, 0}};
  EXPECT_EQ(declutter_knn(CloudView(scan), {}).clutter, 1U);
  EXPECT_EQ(nothing_kept(3).clutter, 3U);
}

}  // namespace
}  // namespace spool
