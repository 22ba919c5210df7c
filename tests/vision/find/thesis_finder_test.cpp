// Tests of the thesis's finder on small scenes whose truth is known, and of what it refuses.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/find/thesis_finder.h"

#include <cmath>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

#include "tests/vision/align/synthetic_spool.h"
#include "vision/align/icp.h"
#include "vision/find/point_icp.h"

namespace spool {
namespace {

using test::design_of;
using test::displacement_at;
using test::random_motion;
using test::Rod;
using test::ScanOptions;
using test::tee_spool;

// No clock in what is compared: the iterations end the search.
constexpr ThesisFinderOptions kBySeed = {
    .time_limit_s = 1e6, .enough_support = 0.9, .max_iterations = 40};

std::vector<Rod> elbowed_spool() {
  return {{{0, 0, 0}, Eigen::Vector3d::UnitX(), 0.04, 0.7},
          {{0.7, 0, -0.04}, Eigen::Vector3d::UnitZ(), 0.04, 0.4},
          {{-0.03, 0, 0}, Eigen::Vector3d::UnitX(), 0.08, 0.03}};
}

const PairLibrary& tee_library() {
  static const PairLibrary library = [] {
    PairLibrary made;
    made.models.push_back(build_pair_model(design_of(tee_spool()), made.options).value());
    return made;
  }();
  return library;
}

void append(PointCloud& to, const PointCloud& from) {
  to.points.insert(to.points.end(), from.points.begin(), from.points.end());
  to.normals.insert(to.normals.end(), from.normals.begin(), from.normals.end());
}

// A rack of fat posts and a floor round the design's place, none of them touching it.
PointCloud clutter_at(const Pose& T_scan_design, std::size_t points, std::mt19937& random) {
  PointCloud clutter = test::scan_of({{{-0.6, -0.8, -0.4}, Eigen::Vector3d::UnitZ(), 0.15, 1.2},
                                      {{0.9, 0.7, -0.4}, Eigen::Vector3d::UnitZ(), 0.2, 0.9}},
                                     T_scan_design, {.points = points / 2}, random);
  std::uniform_real_distribution<double> side(-1, 1);
  for (std::size_t i = 0; i < points / 2; ++i) {
    clutter.points.push_back(
        (T_scan_design * Eigen::Vector3d(side(random), side(random), -0.4)).cast<float>());
    clutter.normals.push_back((T_scan_design.linear() * Eigen::Vector3d::UnitZ()).cast<float>());
  }
  return clutter;
}

PointCloud cluttered_tee(const Pose& T_scan_design, std::mt19937& random) {
  PointCloud scan =
      test::scan_of(tee_spool(), T_scan_design, {.points = 4000, .noise_m = 0.001}, random);
  append(scan, clutter_at(T_scan_design, 4000, random));
  return scan;
}

// Five rounds of a point-to-point ICP need not have ended: a pose that puts most of the model
// within 24 mm of the scene may leave a corner of the box off by several times that. What shows
// that it is the right pose is that the default ICP, started there, ends at the truth.
constexpr double kOff = 0.08;
// 1 mm of noise over thousands of points leaves far less; the ICP's own gate is 3 mm.
constexpr double kRefinedOff = 0.003;

TEST(ThesisFinder, FindsTheDesignInClutterWithAndWithoutSidesKnown) {
  const DesignModel tee = design_of(tee_spool());
  const DesignSurface surface = DesignSurface::build(tee).value();
  const Eigen::AlignedBox3d box = tee.bounds();
  for (const bool sides : {true, false}) {
    const unsigned seed = sides ? 1 : 2;
    std::mt19937 random{seed};
    const Pose T_scan_design = random_motion(2, seed, random);
    PointCloud scan = cluttered_tee(T_scan_design, random);
    if (!sides) scan.normals.clear();
    ThesisFinderOptions options = kBySeed;
    options.seed = seed;
    const auto searches = find_as_thesis(scan, tee_library(), options);
    ASSERT_EQ(searches.size(), 1U);
    const ThesisSearch& search = searches[0];
    EXPECT_TRUE(search.found);
    EXPECT_GT(search.support, 0.8);
    EXPECT_LT(displacement_at(box, search.T_design_scan, T_scan_design.inverse()), kOff)
        << "seed " << seed << (sides ? "" : " without sides") << ", support " << search.support;
    EXPECT_FALSE(search.out_of_time || search.cancelled);
  }
}

TEST(ThesisFinder, SameSeedSameResultAnotherSeedAnotherWay) {
  std::mt19937 random{1};
  const PointCloud scan = cluttered_tee(random_motion(1, 2, random), random);
  ThesisFinderOptions options = kBySeed;
  options.max_iterations = 5;
  options.enough_support = 1;
  const auto a = find_as_thesis(scan, tee_library(), options);
  const auto b = find_as_thesis(scan, tee_library(), options);
  EXPECT_EQ(a[0].T_design_scan.matrix(), b[0].T_design_scan.matrix());
  EXPECT_EQ(a[0].hypotheses, b[0].hypotheses);
  EXPECT_EQ(a[0].iterations, 5U);
  options.seed = 2;
  EXPECT_NE(find_as_thesis(scan, tee_library(), options)[0].hypotheses, a[0].hypotheses);
}

TEST(ThesisFinder, FindsEachDesignOfALibraryAtItsOwnPlace) {
  PairLibrary library;
  library.models.push_back(build_pair_model(design_of(elbowed_spool()), {}).value());
  library.models.push_back(tee_library().models[0]);
  std::mt19937 random{4};
  const Pose T_tee = random_motion(1, 1, random);
  Pose T_elbow = random_motion(1, 2, random);
  T_elbow.translation() = T_tee.translation() + Eigen::Vector3d(2, 0, 0);
  PointCloud scan = test::scan_of(tee_spool(), T_tee, {.points = 4000}, random);
  append(scan, test::scan_of(elbowed_spool(), T_elbow, {.points = 3000}, random));
  const auto searches = find_as_thesis(scan, library, kBySeed);
  ASSERT_EQ(searches.size(), 2U);
  EXPECT_LT(displacement_at(design_of(elbowed_spool()).bounds(), searches[0].T_design_scan,
                            T_elbow.inverse()),
            kOff);
  EXPECT_LT(
      displacement_at(design_of(tee_spool()).bounds(), searches[1].T_design_scan, T_tee.inverse()),
      kOff);
}

TEST(ThesisFinder, WhatIsSupportedTooLittleIsNotFound) {
  std::mt19937 random{1};
  const PointCloud clutter = clutter_at(Pose::Identity(), 4000, random);
  ThesisFinderOptions options = kBySeed;
  options.max_iterations = 10;
  options.min_support = 0.85;
  options.enough_support = 1;
  const auto searches = find_as_thesis(clutter, tee_library(), options);
  EXPECT_FALSE(searches[0].found);
  EXPECT_GT(searches[0].hypotheses, 0U);
}

TEST(ThesisFinder, NothingFiniteOrASinglePointFindsNothing) {
  for (const std::vector<Eigen::Vector3f>& points :
       {std::vector<Eigen::Vector3f>{}, {{NAN, 0, 0}}, {{1, 2, 3}}, {{0, 0, 0}, {0.66F, 0, 0}}}) {
    const auto searches = find_as_thesis(CloudView(points), tee_library(), kBySeed);
    ASSERT_EQ(searches.size(), 1U);
    EXPECT_FALSE(searches[0].found);
    EXPECT_TRUE(searches[0].T_design_scan.matrix().allFinite());
  }
  EXPECT_TRUE(find_as_thesis({}, PairLibrary{}, kBySeed).empty());
}

TEST(ThesisFinder, PointsThatAreNotFiniteChangeNothing) {
  std::mt19937 random{1};
  PointCloud scan = cluttered_tee(random_motion(1, 2, random), random);
  ThesisFinderOptions options = kBySeed;
  options.max_iterations = 3;
  const auto clean = find_as_thesis(scan, tee_library(), options);
  scan.points.insert(scan.points.begin(), {NAN, 0, INFINITY});
  scan.normals.insert(scan.normals.begin(), {0, 0, 1});
  const auto holed = find_as_thesis(scan, tee_library(), options);
  EXPECT_EQ(clean[0].T_design_scan.matrix(), holed[0].T_design_scan.matrix());
}

TEST(ThesisFinder, EndsAtTheTimeLimitAndWhenCancelled) {
  std::mt19937 random{1};
  const PointCloud scan = cluttered_tee(random_motion(1, 2, random), random);
  const auto late = find_as_thesis(scan, tee_library(), {.time_limit_s = 1e-9});
  EXPECT_TRUE(late[0].out_of_time);
  EXPECT_LE(late[0].iterations, 1U);

  std::stop_source stop;
  const Watch watch{stop.get_token(), [&](std::string_view, double) { stop.request_stop(); }};
  const auto cancelled = find_as_thesis(scan, tee_library(), kBySeed, watch);
  EXPECT_TRUE(cancelled[0].cancelled);
  EXPECT_FALSE(cancelled[0].found);
  EXPECT_EQ(cancelled[0].iterations, 1U);
  const auto at_once = find_as_thesis(scan, tee_library(), kBySeed, watch);
  EXPECT_TRUE(at_once[0].cancelled);
  EXPECT_EQ(at_once[0].hypotheses, 0U);
}

TEST(ThesisFinder, RefusesOptionsThatMakeNoSense) {
  EXPECT_FALSE(validate(ThesisFinderOptions{}));
  for (const ThesisFinderOptions& options :
       {ThesisFinderOptions{.min_support = 0}, ThesisFinderOptions{.min_support = 1.5},
        ThesisFinderOptions{.time_limit_s = 0}, ThesisFinderOptions{.time_limit_s = NAN},
        ThesisFinderOptions{.icp_iterations = -1}, ThesisFinderOptions{.enough_support = 0.1},
        ThesisFinderOptions{.near_over_leaf = 0}}) {
    const auto error = validate(options);
    ASSERT_TRUE(error);
    EXPECT_EQ(error->code, ErrorCode::kUsage);
    EXPECT_TRUE(error->message.starts_with("finder: "));
  }
}

TEST(Isolate, KeepsThePointsThatBruteForceKeeps) {
  std::mt19937 random{1};
  std::uniform_real_distribution<float> unit(0, 1);
  std::vector<Eigen::Vector3f> scan(500), model(80);
  for (auto& p : scan) p = {unit(random), unit(random), unit(random)};
  for (auto& p : model) p = {unit(random), unit(random), unit(random)};
  scan[10].x() = NAN;
  const Pose T_design_scan = random_motion(0.1, 0.2, random);
  std::vector<std::uint32_t> expected;
  for (std::uint32_t i = 0; i < scan.size(); ++i) {
    const Eigen::Vector3f p = T_design_scan.cast<float>() * scan[i];
    bool near = false;
    for (const auto& m : model) near = near || (m - p).norm() < 0.1F;
    if (near) expected.push_back(i);
  }
  EXPECT_EQ(isolate(CloudView(scan), CloudView(model), T_design_scan, 0.1), expected);
  EXPECT_GT(expected.size(), 50U);
}

TEST(PointIcp, ConvergesOnTheSamePointsAndDoesNothingInNoRounds) {
  std::mt19937 random{2};
  const PointCloud model = test::scan_of(tee_spool(), Pose::Identity(), {.points = 1500}, random);
  const Pose T_scan_design = random_motion(0.5, 1, random);
  PointCloud scan = model;
  for (auto& p : scan.points) p = T_scan_design.cast<float>() * p;
  const PointIndex index(scan.points);
  const Pose guess = random_motion(0.004, 0.004, random) * T_scan_design.inverse();
  const Eigen::AlignedBox3d box = design_of(tee_spool()).bounds();
  const Pose still = refine_point_to_point(model, index, scan, guess, {.iterations = 0});
  EXPECT_LT(displacement_at(box, still, guess), 1e-9);
  // The same points on both sides: the nearest is soon the right one, to a float's rounding.
  const Pose refined = refine_point_to_point(model, index, scan, guess, {.iterations = 30});
  EXPECT_LT(displacement_at(box, refined, T_scan_design.inverse()), 1e-5);
  const Pose five = refine_point_to_point(model, index, scan, guess);
  EXPECT_LT(displacement_at(box, five, T_scan_design.inverse()),
            displacement_at(box, guess, T_scan_design.inverse()));
  // Out of reach nothing corresponds.
  const Pose far = refine_point_to_point(model, index, scan, guess, {.reach_m = 1e-9});
  EXPECT_LT(displacement_at(box, far, guess), 1e-9);
}

}  // namespace
}  // namespace spool
