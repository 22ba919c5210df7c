// Tests of the octree: what a tree must be, whichever way it splits, against brute force.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/scan/octree.h"

#include <cmath>
#include <random>
#include <string>

#include <gtest/gtest.h>

namespace spool {
namespace {

using Points = std::vector<Eigen::Vector3f>;

Points even_points(std::size_t count) {
  std::mt19937 random{1};
  std::uniform_real_distribution<float> unit(0, 1);
  Points points(count);
  for (auto& p : points) p = {unit(random), 2 * unit(random), unit(random)};
  return points;
}

// Most of them in one corner: each coordinate is a high power of an even one.
Points skewed_points(std::size_t count) {
  Points points = even_points(count);
  for (auto& p : points) p = p.array().pow(6).matrix();
  return points;
}

struct Case {
  std::string name;
  Points points;
  OctreeOptions options;
};

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const OctreeSplit split : {OctreeSplit::kEqual, OctreeSplit::kWeighted}) {
    const std::string style = split == OctreeSplit::kEqual ? "equal" : "weighted";
    all.push_back({style + ", defaults", even_points(500), {.split = split}});
    all.push_back({style + ", one a bin", skewed_points(700), {.split = split, .bin_capacity = 1}});
    all.push_back({style + ", by size",
                   even_points(300),
                   {.split = split, .bin_capacity = 1000, .max_size_m = 0.3}});
    all.push_back({style + ", two levels",
                   skewed_points(400),
                   {.split = split, .bin_capacity = 1, .max_depth = 2}});
    all.push_back({style + ", no small bins",
                   even_points(400),
                   {.split = split, .bin_capacity = 1, .min_size_m = 0.4}});
    all.push_back(
        {style + ", by size of points",
         even_points(300),
         {.split = split, .bin_capacity = 1000, .max_size_m = 0.3, .size_of_points = true}});
    Points holes = even_points(200);
    holes[7].x() = NAN;
    holes[60].z() = INFINITY;
    holes[100] = holes[101] = holes[102];
    all.push_back({style + ", holes and coincident", holes, {.split = split, .bin_capacity = 1}});
    Points flat = even_points(300);
    for (auto& p : flat) p.z() = 0.25F;
    all.push_back({style + ", flat", flat, {.split = split, .bin_capacity = 4}});
    all.push_back({style + ", one", {{1, 2, 3}}, {.split = split, .max_size_m = 1e-3}});
  }
  return all;
}

std::size_t finite(const Points& points) {
  std::size_t count = 0;
  for (const auto& p : points) count += p.allFinite() ? 1U : 0U;
  return count;
}

TEST(Octree, EveryPointIsInItsLeafAndNoneIsLostOrCountedTwice) {
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.name);
    Octree tree(c.points, c.options);
    std::size_t counted = 0;
    for (const OctreeBin& bin : tree.bins()) {
      if (bin.is_leaf()) {
        counted += bin.point_count;
        continue;
      }
      std::size_t of_children = 0;
      for (int k = 0; k < 8; ++k) {
        const OctreeBin& child = tree.bins()[static_cast<std::size_t>(bin.first_child + k)];
        of_children += child.point_count;
        EXPECT_EQ(child.depth, bin.depth + 1);
        EXPECT_EQ(&tree.bins()[static_cast<std::size_t>(child.parent)], &bin);
        EXPECT_TRUE(bin.bounds.contains(child.bounds));
      }
      EXPECT_EQ(of_children, bin.point_count);
    }
    EXPECT_EQ(counted, finite(c.points));
    EXPECT_EQ(tree.point_order().size(), finite(c.points));
    for (const bool shrunk : {false, true}) {
      if (shrunk) tree.shrink();
      for (std::size_t i = 0; i < c.points.size(); ++i) {
        const std::int32_t leaf = tree.point_bins()[i];
        ASSERT_EQ(leaf >= 0, c.points[i].allFinite());
        EXPECT_EQ(tree.query(c.points[i].cast<double>()), leaf);
        if (leaf < 0) continue;
        EXPECT_TRUE(tree.bins()[static_cast<std::size_t>(leaf)].is_leaf());
        EXPECT_TRUE(tree.bins()[static_cast<std::size_t>(leaf)].bounds.contains(
            c.points[i].cast<double>()));
      }
    }
  }
}

Eigen::AlignedBox3d box_of(const Octree& tree, const OctreeBin& bin, const Points& points) {
  Eigen::AlignedBox3d box;
  for (std::uint32_t i = 0; i < bin.point_count; ++i)
    box.extend(points[tree.point_order()[bin.first_point + i]].cast<double>());
  return box;
}

TEST(Octree, LeavesKeepToCapacityDepthAndSizes) {
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.name);
    const Octree tree(c.points, c.options);
    const std::size_t capacity =
        c.options.bin_capacity > 0 ? c.options.bin_capacity : (finite(c.points) + 9) / 10;
    for (const OctreeBin& bin : tree.bins()) {
      EXPECT_LE(bin.depth, c.options.max_depth);
      const Eigen::AlignedBox3d box = box_of(tree, bin, c.points);
      const double longest = (c.options.size_of_points ? box : bin.bounds).sizes().maxCoeff();
      if (!bin.is_leaf()) {
        EXPECT_GE(longest, c.options.min_size_m);
        EXPECT_TRUE(bin.point_count > capacity || longest > c.options.max_size_m);
      } else if (bin.depth < c.options.max_depth && longest >= c.options.min_size_m &&
                 bin.point_count > 0) {
        EXPECT_TRUE(bin.point_count <= capacity || box.sizes().isZero(0.0));
        EXPECT_LE(longest, c.options.max_size_m);
      }
    }
  }
}

TEST(Octree, SplitsAtTheCentreOrAtTheMeanAndGreaterGoesUp) {
  const Points points = {{0, 0, 0}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {4, 4, 4}};
  // The centre is 2; the mean 1.4. Neither moves (1,1,1) up; a point on the split stays down.
  const Octree equal(points, {.split = OctreeSplit::kEqual, .bin_capacity = 4});
  EXPECT_EQ(equal.bins()[0].split, Eigen::Vector3d::Constant(2));
  const Octree weighted(points, {.split = OctreeSplit::kWeighted, .bin_capacity = 4});
  EXPECT_LT((weighted.bins()[0].split - Eigen::Vector3d::Constant(1.4)).norm(), 1e-12);
  for (const Octree* tree : {&equal, &weighted}) {
    EXPECT_EQ(tree->bins().size(), 9U);
    EXPECT_EQ(tree->point_bins(), (std::vector<std::int32_t>{1, 1, 1, 1, 8}));
  }
  const Points on_the_split = {{0, 0, 0}, {2, 2, 2}, {4, 4, 4}};
  EXPECT_EQ(Octree(on_the_split, {.bin_capacity = 2}).point_bins(),
            (std::vector<std::int32_t>{1, 1, 8}));
}

TEST(Octree, WeightedNeedsFewerBinsOnSkewedPoints) {
  const Points points = skewed_points(2000);
  for (const std::size_t capacity : {1U, 5U, 50U}) {
    const Octree equal(points, {.split = OctreeSplit::kEqual, .bin_capacity = capacity});
    const Octree weighted(points, {.split = OctreeSplit::kWeighted, .bin_capacity = capacity});
    EXPECT_LE(weighted.bins().size(), equal.bins().size()) << capacity;
  }
}

TEST(Octree, QueryFindsWhatSearchingAllBinsFinds) {
  const Points points = skewed_points(600);
  Octree tree(points, {.bin_capacity = 10});
  std::mt19937 random{3};
  std::uniform_real_distribution<double> place(-0.2, 2.2);
  for (const bool shrunk : {false, true}) {
    if (shrunk) tree.shrink();
    for (int i = 0; i < 3000; ++i) {
      const Eigen::Vector3d p = {place(random) * 0.5, place(random) * 30, place(random) * 0.5};
      for (const int depth : {0, 1, 3, 100}) {
        // The deepest bin that holds it; no two of a level do but on a shared face.
        std::int32_t expected = -1;
        for (std::size_t b = 0; b < tree.bins().size(); ++b)
          if (tree.bins()[b].depth <= depth && tree.bins()[b].bounds.contains(p) &&
              (expected < 0 ||
               tree.bins()[b].depth > tree.bins()[static_cast<std::size_t>(expected)].depth))
            expected = static_cast<std::int32_t>(b);
        EXPECT_EQ(tree.query(p, depth), expected);
      }
    }
  }
  EXPECT_EQ(tree.query({NAN, 0, 0}), -1);
}

TEST(Octree, ShrunkBinsAreTheBoxesOfTheirPoints) {
  const Points points = skewed_points(500);
  Octree tree(points, {.bin_capacity = 7});
  tree.shrink();
  std::vector<Eigen::AlignedBox3d> boxes(tree.bins().size());
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::int32_t b = tree.point_bins()[i]; b >= 0;
         b = tree.bins()[static_cast<std::size_t>(b)].parent)
      boxes[static_cast<std::size_t>(b)].extend(points[i].cast<double>());
  for (std::size_t b = 0; b < boxes.size(); ++b) {
    if (tree.bins()[b].point_count > 0) {
      EXPECT_TRUE(tree.bins()[b].bounds.isApprox(boxes[b], 0.0)) << b;
    } else {
      EXPECT_TRUE(tree.bins()[b].bounds.sizes().isZero(0.0)) << b;
    }
  }
}

TEST(Octree, NothingFiniteIsNoTreeAndCoincidentPointsAreOneBin) {
  EXPECT_TRUE(Octree().bins().empty());
  EXPECT_EQ(Octree().query({0, 0, 0}), -1);
  const Points nothing = {{NAN, 0, 0}, {0, INFINITY, 0}};
  const Octree none(nothing);
  EXPECT_TRUE(none.bins().empty());
  EXPECT_EQ(none.point_bins(), (std::vector<std::int32_t>{-1, -1}));
  const Points heap(1000, {1, 2, 3});
  EXPECT_EQ(Octree(heap, {.bin_capacity = 1}).bins().size(), 1U);
  Points two_heaps(20, {1, 2, 3});
  two_heaps.resize(40, {2, 3, 4});
  EXPECT_EQ(Octree(two_heaps, {.bin_capacity = 1}).bins().size(), 9U);
}

TEST(Octree, DividesDownToNeighbouringNumbersAndEnds) {
  const Points far = {{1e8F, 0, 0}, {std::nextafter(1e8F, 2e8F), 0, 0}, {-1e8F, 3e38F, 1e-40F}};
  for (const OctreeSplit split : {OctreeSplit::kEqual, OctreeSplit::kWeighted}) {
    const Octree tree(far, {.split = split, .bin_capacity = 1, .max_size_m = 0});
    EXPECT_NE(tree.point_bins()[0], tree.point_bins()[1]);
    EXPECT_NE(tree.point_bins()[0], tree.point_bins()[2]);
  }
}

TEST(Octree, CancelledIsWholeAsFarAsItWasDivided) {
  std::stop_source stop;
  stop.request_stop();
  const Points points = even_points(100);
  const Octree tree(points, {.bin_capacity = 1}, {.stop = stop.get_token()});
  ASSERT_EQ(tree.bins().size(), 1U);
  EXPECT_EQ(tree.point_bins(), std::vector<std::int32_t>(100, 0));
}

}  // namespace
}  // namespace spool
