// Tests of the model library: its pairs against brute force, its laws, what it refuses.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/find/pair_library.h"

#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "tests/vision/align/synthetic_spool.h"
#include "vision/find/rigid_fit.h"

namespace spool {
namespace {

using test::design_of;
using test::random_motion;
using test::tee_spool;

const PairModel& tee_model() {
  static const PairModel model = build_pair_model(design_of(tee_spool())).value();
  return model;
}

TEST(PairFeature, IsTheThreeAnglesAndDoesNotChangeWithThePose) {
  // By hand: d along x; normals up, and 45 degrees between x and up.
  const Eigen::Vector3f p1(1, 2, 3), p2(3, 2, 3), up(0, 0, 1);
  const Eigen::Vector3f tilted = Eigen::Vector3f(1, 0, 1).normalized();
  const Eigen::Array3f feature = pair_feature(p1, up, p2, tilted);
  const float quarter = static_cast<float>(std::numbers::pi) / 4;
  EXPECT_TRUE(feature.isApprox(Eigen::Array3f(2 * quarter, quarter, quarter), 1e-5F));
  std::mt19937 random{1};
  for (int i = 0; i < 20; ++i) {
    const Eigen::Isometry3f T = random_motion(2, 0.3 * i, random).cast<float>();
    // A float's rounding of coordinates of a few metres, over 2 m.
    EXPECT_TRUE(pair_feature(T * p1, T.linear() * up, T * p2, T.linear() * tilted)
                    .isApprox(feature, 1e-4F));
  }
  // The other way round d turns round: f1' = pi - f2, f2' = pi - f1.
  EXPECT_TRUE(pair_feature(p2, tilted, p1, up)
                  .isApprox(Eigen::Array3f(3 * quarter, 2 * quarter, quarter), 1e-5F));
}

TEST(PairFeature, SaysWhenThePairCanTurnAboutItsOwnLine) {
  const Eigen::Vector3f a(0, 0, 0), b(0, 0, 1), z(0, 0, 1), x(1, 0, 0);
  EXPECT_FALSE(fixes_a_pose(pair_feature(a, z, b, z), 0.1));
  EXPECT_FALSE(fixes_a_pose(pair_feature(a, z, b, -z), 0.1));
  EXPECT_TRUE(fixes_a_pose(pair_feature(a, x, b, z), 0.1));
  EXPECT_TRUE(fixes_a_pose(pair_feature(a, -z, b, x), 0.1));
}

TEST(FeatureCells, TwelveDegreesMakeFifteenCellsAnAxisAndEndInTheLast) {
  const FeatureCells cells(12.0 * std::numbers::pi / 180);
  EXPECT_EQ(cells.count(), 15U * 15U * 15U);
  const auto pi = static_cast<float>(std::numbers::pi);
  EXPECT_EQ(cells.cell_of({0, 0, 0}), 0U);
  EXPECT_EQ(cells.cell_of({pi, pi, pi}), cells.count() - 1);
  EXPECT_EQ(cells.cell_of({0.22F, 0.2F, 0.2F}), 225U);  // 12 degrees are 0.2094 rad
  EXPECT_EQ(cells.cell_of({0.2F, 0.22F, 0.2F}), 15U);
  EXPECT_EQ(cells.cell_of({0.2F, 0.2F, 0.22F}), 1U);
  EXPECT_EQ(FeatureCells(1.0).count(), 64U);  // three whole cells and a part
}

TEST(PairLibrary, HoldsEveryPairAtTheDistanceInItsCellAndNoOther) {
  const PairModel& model = tee_model();
  const FeatureCells cells(PairLibraryOptions{}.cell_rad);
  ASSERT_EQ(model.cell_first.size(), cells.count() + 1);
  using Key = std::tuple<std::size_t, std::uint32_t, std::uint32_t>;
  std::set<Key> expected, found;
  const auto& p = model.points.points;
  const auto& n = model.points.normals;
  for (std::uint32_t i = 0; i < p.size(); ++i)
    for (std::uint32_t k = 0; k < p.size(); ++k) {
      if (std::abs((p[i] - p[k]).norm() - model.distance_m) > model.tolerance_m) continue;
      const Eigen::Vector3f d = (p[k] - p[i]).normalized();
      if (n[i].cross(d).norm() <= std::sin(std::numbers::pi / 18) &&
          n[k].cross(d).norm() <= std::sin(std::numbers::pi / 18))
        continue;
      expected.emplace(cells.cell_of(pair_feature(p[i], n[i], p[k], n[k])), i, k);
    }
  for (std::size_t cell = 0; cell < cells.count(); ++cell)
    for (const OrientedPair& pair : model.in_cell(cell))
      found.emplace(cell, pair.first, pair.second);
  EXPECT_EQ(found.size(), model.pairs.size()) << "a pair is there twice";
  // A normal within a float's rounding of the 10 degrees may fall on either side.
  std::vector<Key> different;
  std::set_symmetric_difference(expected.begin(), expected.end(), found.begin(), found.end(),
                                std::back_inserter(different));
  EXPECT_LE(different.size(), 2U);
  EXPECT_GT(found.size(), 1000U);
}

TEST(PairLibrary, TakesDistanceAndDensityFromTheDesign) {
  const PairModel& model = tee_model();
  // The tee's farthest points: from the rim of the lower disc to the far rim of the branch's disc,
  // sqrt((0.425 + 0.09)^2 + (0.55 + 0.075 + 0.03)^2) = 0.833; the discs of the run: 0.879.
  EXPECT_NEAR(model.diameter_m, 0.879, 0.01);  // samples seldom lie on a rim
  EXPECT_DOUBLE_EQ(model.distance_m, 0.75 * model.diameter_m);
  for (std::size_t i = 0; i < model.points.size(); ++i)
    ASSERT_NEAR(model.points.normals[i].norm(), 1, 1e-4);
  EXPECT_GT(model.points.size(), 500U);
  EXPECT_LT(model.points.size(), 3500U);
}

TEST(PairLibrary, NormalsPointOutOfTheDesign) {
  const PairModel& model = tee_model();
  int checked = 0;
  for (std::size_t i = 0; i < model.points.size(); ++i) {
    const Eigen::Vector3d p = model.points.points[i].cast<double>();
    if (p.z() < 0.1 || p.z() > 0.4) continue;  // the bare run: away from its axis
    ++checked;
    const Eigen::Vector3d out = Eigen::Vector3d(p.x(), p.y(), 0).normalized();
    EXPECT_GT(model.points.normals[i].cast<double>().dot(out), 0.8) << p.transpose();
  }
  EXPECT_GT(checked, 50);
}

TEST(PairLibrary, IsTheSameTwiceAndItsKeyFollowsDesignAndOptions) {
  const DesignModel tee = design_of(tee_spool());
  const PairModel again = build_pair_model(tee).value();
  EXPECT_EQ(again.points.points, tee_model().points.points);
  EXPECT_EQ(again.cell_first, tee_model().cell_first);
  EXPECT_EQ(again.key, tee_model().key);
  std::set<std::string> keys = {pair_model_key(tee, {})};
  DesignModel longer = tee;
  longer.mesh.vertices[0].x() += 1e-3F;
  keys.insert(pair_model_key(longer, {}));
  for (const PairLibraryOptions& options :
       {PairLibraryOptions{.distance_over_diameter = 0.5}, PairLibraryOptions{.cell_rad = 0.1},
        PairLibraryOptions{.model_samples = 5000}, PairLibraryOptions{.leaf_over_spacing = 2},
        PairLibraryOptions{.tolerance_over_leaf = 1}, PairLibraryOptions{.normal_neighbours = 9},
        PairLibraryOptions{.seed = 2}})
    keys.insert(pair_model_key(tee, options));
  EXPECT_EQ(keys.size(), 9U);
}

TEST(PairLibrary, TakesADesignThatIsACloudOfFewPointsWithoutNormals) {
  std::mt19937 random{1};
  DesignModel cloud;
  cloud.cloud = test::scan_of(tee_spool(), Pose::Identity(), {.points = 4000}, random);
  cloud.cloud.normals.clear();
  const auto model = build_pair_model(cloud);
  ASSERT_TRUE(model) << model.error().message;
  EXPECT_NEAR(model->diameter_m, 0.879, 0.02);
  EXPECT_GT(model->pairs.size(), 1000U);
  // Random points on 0.45 m2, 94 per square decimetre: half have another within 4.8 mm
  // (sqrt(ln 2 / (pi 8900 / m2))), ten of them a leaf.
  EXPECT_NEAR(model->leaf_m, 0.048, 0.008);
}

TEST(PairLibrary, RefusesOptionsDesignsAndCancelledWork) {
  const DesignModel tee = design_of(tee_spool());
  for (const PairLibraryOptions& options :
       {PairLibraryOptions{.distance_over_diameter = 1}, PairLibraryOptions{.cell_rad = 0},
        PairLibraryOptions{.cell_rad = NAN}, PairLibraryOptions{.model_samples = 3},
        PairLibraryOptions{.leaf_over_spacing = 0}, PairLibraryOptions{.tolerance_over_leaf = -1},
        PairLibraryOptions{.normal_neighbours = 2}}) {
    const auto refused = build_pair_model(tee, options);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::kUsage);
    EXPECT_TRUE(refused.error().message.starts_with("model library: "));
  }
  DesignModel dot;
  dot.path = "dot.ply";
  dot.cloud.points = {{0, 0, 0}, {0, 0, 0}};
  const auto refused = build_pair_model(dot);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::kBadInput);
  EXPECT_TRUE(refused.error().message.starts_with("dot.ply: ")) << refused.error().message;
  std::stop_source stop;
  stop.request_stop();
  EXPECT_FALSE(build_pair_model(tee, {}, {.stop = stop.get_token()}));
}

TEST(RigidFit, FindsTheMotionOfFourPointsAndNeverMirrors) {
  std::mt19937 random{5};
  std::normal_distribution<double> gauss(0, 1);
  for (int i = 0; i < 50; ++i) {
    const Pose T = random_motion(3, 0.06 * i, random);
    std::vector<Eigen::Vector3d> from(4), to(4);
    for (int k = 0; k < 4; ++k) {
      from[static_cast<std::size_t>(k)] = {gauss(random), gauss(random), i % 2 ? 0 : gauss(random)};
      to[static_cast<std::size_t>(k)] = T * from[static_cast<std::size_t>(k)];
    }
    EXPECT_TRUE(fit_rigid_motion(from, to).isApprox(T, 1e-9)) << i;
    for (auto& p : to) p.x() = -p.x();
    EXPECT_NEAR(fit_rigid_motion(from, to).linear().determinant(), 1, 1e-9);
  }
}

}  // namespace
}  // namespace spool
