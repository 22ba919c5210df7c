// Tests of the neighbour index against brute force.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/scan/point_index.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace spool {
namespace {

using Points = std::vector<Eigen::Vector3f>;

// Points on a pipe, in a cube, on a coarse grid (many equal distances), in a heap of duplicates.
struct Shape {
  const char* name;
  Points points;
};

std::vector<Shape> shapes() {
  std::mt19937 random{3};
  std::uniform_real_distribution<float> unit(-1, 1);
  std::vector<Shape> all = {
      {"pipe", {}}, {"cube", {}}, {"grid", {}}, {"duplicates", {}}, {"one", {}}};
  for (int i = 0; i < 3000; ++i) {
    const float angle = 3.14159F * unit(random);
    all[0].points.emplace_back(0.05F * std::cos(angle), 0.05F * std::sin(angle), unit(random));
    all[1].points.emplace_back(unit(random), unit(random), unit(random));
    all[2].points.emplace_back(std::round(5 * unit(random)), std::round(5 * unit(random)), 0.0F);
    all[3].points.emplace_back(0.25F, 0.5F, i < 2990 ? 0.125F : unit(random));
  }
  all[4].points.emplace_back(0.1F, 0.2F, 0.3F);
  // Points without a measurement must not disturb.
  for (Shape& shape : all) shape.points.insert(shape.points.begin(), {NAN, NAN, NAN});
  all[1].points[77].z() = std::numeric_limits<float>::infinity();
  return all;
}

Points queries() {
  std::mt19937 random{4};
  std::uniform_real_distribution<float> unit(-1.2F, 1.2F);
  Points all;
  for (int i = 0; i < 200; ++i) all.emplace_back(unit(random), unit(random), unit(random));
  all.emplace_back(0.25F, 0.5F, 0.125F);
  all.emplace_back(1e6F, 0.0F, 0.0F);
  return all;
}

// Sorted distances of all points nearer than `bound`.
std::vector<float> brute_force(const Points& points, const Eigen::Vector3f& query, float bound) {
  std::vector<float> distances;
  for (const Eigen::Vector3f& point : points)
    if (point.allFinite() && (point - query).norm() < bound)
      distances.push_back((point - query).norm());
  std::sort(distances.begin(), distances.end());
  return distances;
}

std::vector<float> sorted_distances(const std::vector<Neighbour>& neighbours) {
  std::vector<float> distances;
  for (const Neighbour& neighbour : neighbours) distances.push_back(neighbour.distance);
  std::sort(distances.begin(), distances.end());
  return distances;
}

// Two floats sums of three squares in another order: a few units in the last place.
void expect_same(const std::vector<float>& found, const std::vector<float>& expected,
                 const char* name) {
  ASSERT_EQ(found.size(), expected.size()) << name;
  for (std::size_t i = 0; i < found.size(); ++i)
    ASSERT_NEAR(found[i], expected[i], 1e-6F * (1 + expected[i])) << name;
}

TEST(PointIndex, AgreesWithBruteForce) {
  for (const Shape& shape : shapes()) {
    const PointIndex index(shape.points);
    std::vector<Neighbour> found;
    for (const Eigen::Vector3f& query : queries())
      for (const float bound : {0.0437F, 0.7113F, 10.013F}) {
        const std::vector<float> all = brute_force(shape.points, query, bound);
        const auto nearest = index.nearest(query, bound);
        ASSERT_EQ(nearest.has_value(), !all.empty()) << shape.name;
        if (nearest) {
          ASSERT_NEAR(nearest->distance, all[0], 1e-6F * (1 + all[0])) << shape.name;
          ASSERT_NEAR((shape.points[nearest->index] - query).norm(), all[0], 1e-6F * (1 + all[0]));
        }
        index.within(query, bound, found);
        expect_same(sorted_distances(found), all, shape.name);
        index.nearest_k(query, 7, bound, found);
        ASSERT_TRUE(std::is_sorted(found.begin(), found.end(), [](const auto& a, const auto& b) {
          return a.distance < b.distance;
        })) << shape.name;
        expect_same(sorted_distances(found),
                    {all.begin(), all.begin() + std::min<std::ptrdiff_t>(7, std::ssize(all))},
                    shape.name);
      }
  }
}

TEST(PointIndex, NamesEachNeighbourOnceByItsPlaceInTheInput) {
  const Points points = shapes()[0].points;
  const PointIndex index(points);
  EXPECT_EQ(index.size(), points.size() - 1);  // one is not finite
  std::vector<Neighbour> found;
  index.nearest_k({0, 0, 0}, 100, 10.0F, found);
  std::vector<std::uint32_t> places;
  for (const Neighbour& neighbour : found) {
    places.push_back(neighbour.index);
    EXPECT_NEAR(points[neighbour.index].norm(), neighbour.distance, 1e-6F);
  }
  std::sort(places.begin(), places.end());
  EXPECT_EQ(std::unique(places.begin(), places.end()), places.end());
}

TEST(PointIndex, FindsItsOwnPointsAfterAMove) {
  const Points points = shapes()[1].points;
  PointIndex index;
  EXPECT_FALSE(index.nearest({0, 0, 0}, 1.0F));
  index = PointIndex(points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!points[i].allFinite()) continue;
    const auto nearest = index.nearest(points[i], 0.1F);
    ASSERT_TRUE(nearest);
    ASSERT_EQ(nearest->distance, 0.0F);
  }
}

TEST(PointIndex, AnswersNothingWithoutPointsOrForAQueryThatIsNotFinite) {
  const Points none = {{NAN, 0, 0}};
  const PointIndex empty(none);
  std::vector<Neighbour> found(3);
  EXPECT_EQ(empty.size(), 0U);
  EXPECT_FALSE(empty.nearest({0, 0, 0}, 1.0F));
  empty.nearest_k({0, 0, 0}, 3, 1.0F, found);
  EXPECT_TRUE(found.empty());

  const Points one = {{0, 0, 0}};
  const PointIndex index(one);
  EXPECT_FALSE(index.nearest({NAN, 0, 0}, 1.0F));
  found.resize(3);
  index.within({0, 0, std::numeric_limits<float>::infinity()}, 1.0F, found);
  EXPECT_TRUE(found.empty());
  found.resize(3);
  index.nearest_k({0, 0, 0}, 0, 1.0F, found);
  EXPECT_TRUE(found.empty());
}

}  // namespace
}  // namespace spool
