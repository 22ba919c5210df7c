// Declutter and deviation end within a tenth of a second when they are told to.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "tests/support/cancelling.h"
#include "tests/vision/align/synthetic_spool.h"
#include "vision/inspect/declutter.h"
#include "vision/inspect/deviation.h"

namespace spool {
namespace {

// `count` points evenly over a cube of 2 m, in no order: the sequence of the plastic number
// (Roberts 2018), which costs next to nothing to make.
std::vector<Eigen::Vector3f> strewn_points(std::size_t count) {
  std::vector<Eigen::Vector3f> points(count);
  Eigen::Array3d at(0.5, 0.5, 0.5);
  for (Eigen::Vector3f& point : points) {
    at += Eigen::Array3d(0.8191725134, 0.6710436067, 0.5497004779);
    at -= at.floor();
    point = (2 * at - 1).matrix().cast<float>();
  }
  return points;
}

TEST(Cancel, EndsDeclutterInTheMiddleAndNothingIsKept) {
  const auto scan = strewn_points(300000);
  const auto model = strewn_points(12000);
  const double whole_s = test::seconds_of(
      [&] { EXPECT_GT(declutter_knn(CloudView(scan), CloudView(model)).object, 0U); });
  for (const double share : {0.1, 0.6}) {  // while the index is built, and while it is searched
    DeclutterResult found;
    const auto obeyed_s = test::seconds_until_obeyed(share * whole_s, [&](const Watch& watch) {
      found = declutter_knn(CloudView(scan), CloudView(model), {}, watch);
    });
    ASSERT_TRUE(obeyed_s) << "it ended before it was told to";
    EXPECT_LT(*obeyed_s, test::kObeyed_s) << share;
    EXPECT_EQ(found.object, 0U);
    EXPECT_EQ(found.clutter, scan.size());
    EXPECT_EQ(found.classes.size(), scan.size());
  }
}

// The index alone takes seconds there.
TEST(Cancel, EndsDeclutterOfTwentyMillionPoints) {
  const auto scan = strewn_points(20000000);
  const auto model = strewn_points(12000);
  for (const double after_s : {0.0, 0.25, 1.0}) {
    DeclutterResult found;
    const auto obeyed_s = test::seconds_until_obeyed(after_s, [&](const Watch& watch) {
      found = declutter_knn(CloudView(scan), CloudView(model), {}, watch);
    });
    ASSERT_TRUE(obeyed_s) << "it ended before it was told to";
    EXPECT_LT(*obeyed_s, test::kObeyed_s) << after_s;
    EXPECT_EQ(found.object, 0U);
  }
}

// Points with noise on a meshed spool, in no order.
class CancelledDeviation : public testing::Test {
 protected:
  CancelledDeviation() {
    std::mt19937 random{1};
    some_ = test::scan_of(test::tee_spool(), Pose::Identity(), {.points = 20000, .noise_m = 0.002},
                          random);
  }

  // `count` points measured and told to stop after `after_s`: how many distances there are then.
  void measure(std::size_t count, double after_s) {
    scan_.resize(count);
    for (std::size_t i = 0; i < count; ++i) scan_[i] = some_.points[i % some_.size()];
    classes_.assign(count, PointClass::kObject);
    Deviations found;
    const auto obeyed_s = test::seconds_until_obeyed(after_s, [&](const Watch& watch) {
      found = measure_deviations(CloudView(scan_), classes_, *surface_, 0.05F, watch);
    });
    ASSERT_TRUE(obeyed_s) << "it ended before it was told to";
    EXPECT_LT(*obeyed_s, test::kObeyed_s);
    measured_ = std::count_if(found.part.begin(), found.part.end(),
                              [](std::int32_t part) { return part >= 0; });
    EXPECT_LT(measured_, static_cast<std::ptrdiff_t>(count));
    EXPECT_EQ(std::count(classes_.begin(), classes_.end(), PointClass::kObject), measured_);
    EXPECT_TRUE(found.distance_m.size() == count || found.distance_m.empty());
  }

  DesignModel design_ = test::design_of(test::tee_spool());
  Result<DesignSurface> surface_ = DesignSurface::build(design_);
  PointCloud some_;
  std::vector<Eigen::Vector3f> scan_;
  std::vector<PointClass> classes_;
  std::ptrdiff_t measured_ = 0;
};

TEST_F(CancelledDeviation, EndsInTheMiddleAndTheRestIsClutter) {
  constexpr std::size_t kCount = 300000;
  // Later and later, until the search had begun: how much of the time goes into ordering the points
  // first hangs on the machine.
  for (double after_s = 0.005; measured_ == 0; after_s *= 1.3)
    ASSERT_NO_FATAL_FAILURE(measure(kCount, after_s)) << after_s;
}

TEST_F(CancelledDeviation, EndsOnTwentyMillionPoints) {
  for (const double after_s : {0.0, 0.3, 0.9, 1.8})
    ASSERT_NO_FATAL_FAILURE(measure(20000000, after_s)) << after_s;
}

}  // namespace
}  // namespace spool
