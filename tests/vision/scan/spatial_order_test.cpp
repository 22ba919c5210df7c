// Laws of the spatial order: every place once, near ones next to each other, a good order left.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/scan/spatial_order.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

namespace spool {
namespace {

std::vector<std::uint32_t> all_places(std::size_t count) {
  std::vector<std::uint32_t> places(count);
  std::iota(places.begin(), places.end(), 0U);
  return places;
}

// Metres travelled from point to point.
double path_m(const std::vector<Eigen::Vector3f>& points,
              const std::vector<std::uint32_t>& places) {
  double sum = 0;
  for (std::size_t i = 1; i < places.size(); ++i)
    sum += static_cast<double>((points[places[i]] - points[places[i - 1]]).norm());
  return sum;
}

// A plane of 1 m x 1 m seen by an image, row by row.
std::vector<Eigen::Vector3f> image_rows() {
  std::vector<Eigen::Vector3f> points;
  for (int v = 0; v < 120; ++v)
    for (int u = 0; u < 160; ++u)
      points.emplace_back(static_cast<float>(u) / 160, static_cast<float>(v) / 120, 2.0F);
  return points;
}

TEST(SpatialOrder, OfPointsInNoOrderIsShortAndVisitsEachOnce) {
  std::vector<Eigen::Vector3f> points = image_rows();
  std::mt19937 random{1};
  std::shuffle(points.begin(), points.end(), random);
  auto places = all_places(points.size());
  const double before_m = path_m(points, places);
  put_in_spatial_order(points, places);
  // At random two points of a unit square are 0.52 m apart; inside a cell of 1/64 m 0.008 m, and
  // every fifth step leads into the next cell.
  EXPECT_LT(path_m(points, places), 0.05 * before_m);
  std::sort(places.begin(), places.end());
  EXPECT_EQ(places, all_places(points.size()));
}

TEST(SpatialOrder, LeavesAnImageAsItIs) {
  const std::vector<Eigen::Vector3f> points = image_rows();
  auto places = all_places(points.size());
  put_in_spatial_order(points, places);
  EXPECT_EQ(places, all_places(points.size()));
}

TEST(SpatialOrder, TakesTheNamedPlacesOnly) {
  std::vector<Eigen::Vector3f> points = image_rows();
  std::mt19937 random{2};
  std::shuffle(points.begin(), points.end(), random);
  points[0].setConstant(std::numeric_limits<float>::quiet_NaN());  // not named: not looked at
  std::vector<std::uint32_t> odd;
  for (std::uint32_t i = 1; i < points.size(); i += 2) odd.push_back(i);
  auto places = odd;
  put_in_spatial_order(points, places);
  EXPECT_NE(places, odd);
  std::sort(places.begin(), places.end());
  EXPECT_EQ(places, odd);
}

TEST(SpatialOrder, OfNoneOfOneAndOfEqualPointsIsTheGivenOne) {
  for (const std::size_t count : {0U, 1U, 5U}) {
    const std::vector<Eigen::Vector3f> points(count, Eigen::Vector3f(1, 2, 3));
    auto places = all_places(count);
    put_in_spatial_order(points, places);
    EXPECT_EQ(places, all_places(count));
  }
}

TEST(SpatialOrder, CancelledItLeavesThePlacesAsTheyAre) {
  std::vector<Eigen::Vector3f> points = image_rows();
  std::mt19937 random{3};
  std::shuffle(points.begin(), points.end(), random);
  std::stop_source stop;
  stop.request_stop();
  auto places = all_places(points.size());
  put_in_spatial_order(points, places, {stop.get_token(), {}});
  EXPECT_EQ(places, all_places(points.size()));
}

}  // namespace
}  // namespace spool
