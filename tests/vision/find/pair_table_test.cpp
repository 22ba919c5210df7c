// Pairs of elements: what stays when they move, what tells them from their mirror image, and the
// pose that lays one on another.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/find/pair_table.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <gtest/gtest.h>

#include "tests/vision/align/synthetic_spool.h"

namespace spool {
namespace {

using Eigen::Vector3f;

constexpr float kDegree = std::numbers::pi_v<float> / 180;

Vector3f random_vector(std::mt19937& random) {
  std::normal_distribution<float> gauss(0, 1);
  const float x = gauss(random), y = gauss(random), z = gauss(random);
  return {x, y, z};
}

// Elements all over a unit box.
std::vector<Element> random_elements(std::size_t count, std::mt19937& random) {
  std::uniform_real_distribution<float> unit(0, 1);
  std::vector<Element> elements;
  for (std::size_t i = 0; i < count; ++i) {
    const float x = unit(random), y = unit(random), z = unit(random);
    elements.push_back({Vector3f(x, y, z), random_vector(random).normalized()});
  }
  return elements;
}

// Moved, and the directions' signs as they come.
Element moved(const Element& element, const Eigen::Isometry3f& T, std::mt19937& random) {
  return {T * element.point, (random() % 2 == 0 ? 1.0F : -1.0F) * (T.linear() * element.direction)};
}

Eigen::Isometry3f any_motion(std::mt19937& random) {
  return test::random_motion(5, 3, random).cast<float>();
}

float turn_between(float a, float b) {
  return std::abs(std::remainder(a - b, 2 * std::numbers::pi_v<float>));
}

TEST(PairFrame, InvariantsStayUnderMotionAndSign) {
  std::mt19937 random{1};
  const auto elements = random_elements(60, random);
  int compared = 0;
  for (std::size_t i = 0; i + 1 < elements.size(); ++i) {
    const auto before = pair_frame(elements[i], elements[i + 1]);
    if (!before) continue;
    // Across the line the sign of a direction is a matter of rounding.
    if (before->angle_a > 89 * kDegree || before->angle_b > 89 * kDegree) continue;
    const Eigen::Isometry3f T = any_motion(random);
    const auto after = pair_frame(moved(elements[i], T, random), moved(elements[i + 1], T, random));
    ASSERT_TRUE(after);
    ++compared;
    // 5 m away a float counts in steps of half a micrometre.
    EXPECT_NEAR(before->distance, after->distance, 1e-5F);
    EXPECT_NEAR(before->angle_a, after->angle_a, 1e-4F);
    EXPECT_NEAR(before->angle_b, after->angle_b, 1e-4F);
    EXPECT_LT(turn_between(before->dihedral, after->dihedral), 1e-3F);
    EXPECT_LT((T * before->middle - after->middle).norm(), 1e-5F);
    EXPECT_LT((T.linear() * before->axes - after->axes).norm(), 1e-3F);
    EXPECT_NEAR(after->axes.determinant(), 1, 1e-4F);
  }
  EXPECT_GT(compared, 30);
}

TEST(PairFrame, MirrorImageHasTheOppositeDihedralAngle) {
  std::mt19937 random{2};
  const auto elements = random_elements(60, random);
  for (std::size_t i = 0; i + 1 < elements.size(); ++i) {
    const auto before = pair_frame(elements[i], elements[i + 1]);
    if (!before) continue;
    const auto mirrored = [](Element element) {
      element.point.x() *= -1;
      element.direction.x() *= -1;
      return element;
    };
    const auto after = pair_frame(mirrored(elements[i]), mirrored(elements[i + 1]));
    ASSERT_TRUE(after);
    EXPECT_NEAR(before->angle_a, after->angle_a, 1e-4F);
    EXPECT_LT(turn_between(before->dihedral, -after->dihedral), 1e-3F);
  }
}

TEST(PairFrame, IsNoneWhereADirectionLiesAlongTheLineOrThereIsNoLine) {
  const Element a{{0, 0, 0}, {0, 0, 1}};
  const auto at = [](float degrees) {
    return Element{{1, 0, 0}, {std::cos(degrees * kDegree), std::sin(degrees * kDegree), 0}};
  };
  EXPECT_FALSE(pair_frame(a, a));
  EXPECT_FALSE(pair_frame(a, at(0)));
  EXPECT_FALSE(pair_frame(a, at(14)));
  EXPECT_FALSE(pair_frame(at(166), a));
  EXPECT_TRUE(pair_frame(a, at(16)));
  EXPECT_TRUE(pair_frame(at(164), a));
  EXPECT_FALSE(pair_frame(a, {{std::nanf(""), 0, 0}, {0, 1, 0}}));
}

// The pose among those that a pair is laid on by that is nearest to the truth: how far it puts the
// unit box's corners off (m), or nothing where the pair is unknown.
std::optional<float> nearest_pose(const PairTable& table, const PairFrame& frame,
                                  const Eigen::Isometry3f& T_true) {
  std::optional<float> least;
  for (std::size_t n = 0; n < table.count(frame); ++n) {
    const Eigen::Isometry3f T = table.pose(frame, n);
    EXPECT_NEAR(T.linear().determinant(), 1, 1e-4F) << "no mirror";
    float worst = 0;
    for (const Vector3f& p :
         {Vector3f(0, 0, 0), Vector3f(1, 1, 0), Vector3f(1, 0, 1), Vector3f(0, 1, 1)})
      worst = std::max(worst, (T * T_true.inverse() * p - p).norm());
    least = std::min(least.value_or(worst), worst);
  }
  return least;
}

TEST(PairTable, FindsEveryPairUnderAnyMotion) {
  std::mt19937 random{3};
  const auto elements = random_elements(40, random);
  const PairTable table(elements, std::sqrt(3.0));
  int pairs = 0, found = 0;
  for (std::size_t i = 0; i < elements.size(); ++i)
    for (std::size_t j = 0; j < elements.size(); ++j) {
      const Eigen::Isometry3f T_true = any_motion(random);
      const Eigen::Isometry3f T_scan_design = T_true.inverse();
      const Element a = moved(elements[i], T_scan_design, random);
      const Element b = moved(elements[j], T_scan_design, random);
      const auto frame = pair_frame(a, b);
      if (i == j || !frame || frame->distance < table.least_distance()) continue;
      ++pairs;
      const auto off = nearest_pose(table, *frame, T_true);
      found += off && *off < 1e-3F ? 1 : 0;
    }
  EXPECT_GT(pairs, 500);
  // One in some thousands falls into the next bin by rounding.
  EXPECT_GE(found, pairs - 2);
}

TEST(PairTable, TellsAPairFromItsMirrorImage) {
  const Element a{{0, 0, 0}, Vector3f(0.2F, 1, 0).normalized()};
  const Element b{{0.6F, 0, 0}, Vector3f(0.2F, 0.5F, 0.85F).normalized()};
  const auto mirrored = [](Element element) {
    element.point.z() *= -1;
    element.direction.z() *= -1;
    return element;
  };
  const PairTable table({a, b}, 1.0);
  const auto own = pair_frame(a, b);
  const auto other = pair_frame(mirrored(a), mirrored(b));
  ASSERT_TRUE(own && other);
  EXPECT_GE(table.count(*own), 1U);  // also as the pair from the other end
  EXPECT_EQ(table.count(*other), 0U);
}

TEST(PairTable, KnowsPairsTurnedEitherWayNearSquareToTheLine) {
  // A direction 88 degrees to the line, and by noise 92: either sign may be met.
  std::mt19937 random{4};
  for (const float degrees : {86.0F, 88.0F, 92.0F, 94.0F}) {
    const Element a{{0, 0, 0}, Vector3f(std::cos(88 * kDegree), std::sin(88 * kDegree), 0)};
    const Element b{{0.6F, 0, 0}, Vector3f(0.3F, 0.5F, 0.8F).normalized()};
    const PairTable table({a, b}, 1.0);
    Element seen = a;
    seen.direction = Vector3f(std::cos(degrees * kDegree), std::sin(degrees * kDegree), 0);
    const auto frame = pair_frame(seen, b);
    ASSERT_TRUE(frame);
    const auto off = nearest_pose(table, *frame, Eigen::Isometry3f::Identity());
    ASSERT_TRUE(off) << degrees;
    EXPECT_LT(*off, 0.05F) << degrees;  // half of the dihedral's error of some degrees
  }
}

TEST(PairTable, OfALatticeKeepsAFewOfManyLikePairs) {
  std::vector<Element> elements;
  for (int i = 0; i < 30; ++i)
    for (int j = 0; j < 30; ++j)
      elements.push_back({Vector3f(0.03F * static_cast<float>(i), 0.03F * static_cast<float>(j), 0),
                          Vector3f::UnitZ()});
  const PairTable table(elements, 1.3);
  const auto frame = pair_frame(elements[0], elements[25]);
  ASSERT_TRUE(frame);
  EXPECT_GT(table.count(*frame), 100U);
  EXPECT_LE(table.count(*frame), 300U);
  for (std::size_t n = 0; n < table.count(*frame); ++n)
    EXPECT_TRUE(table.pose(*frame, n).matrix().allFinite());
}

TEST(PairTable, OfNothingOrOfPairsTooShortIsEmpty) {
  EXPECT_TRUE(PairTable().empty());
  EXPECT_TRUE(PairTable({}, 1.0).empty());
  const Element a{{0, 0, 0}, {0, 1, 0}};
  EXPECT_TRUE(PairTable({a}, 1.0).empty());
  EXPECT_TRUE(PairTable({a, {{0.1F, 0, 0}, {0, 1, 0}}}, 1.0).empty());  // under a fifth of the size
  const PairTable table({a, {{0.5F, 0, 0}, {0, 1, 0}}}, 1.0);
  EXPECT_FALSE(table.empty());
  const auto long_one = pair_frame(a, {{2, 0, 0}, {0, 1, 0}});
  ASSERT_TRUE(long_one);
  EXPECT_EQ(table.count(*long_one), 0U);
  EXPECT_EQ(PairTable().count(*long_one), 0U);
}

}  // namespace
}  // namespace spool
