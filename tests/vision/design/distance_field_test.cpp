// Volumes of distances against exact distances: by formula, and by the surface that they were made
// of.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/design/distance_field.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "tests/support/cancelling.h"
#include "tests/support/shared_data.h"
#include "tests/vision/design/shapes.h"
#include "vision/design/design_reader.h"
#include "vision/design/distance_brick.h"
#include "vision/design/exterior.h"

namespace spool::test {
namespace {

constexpr double kNear = 0.020;    // m from the surface: what colours are asked to be right in
constexpr double kRight = 0.0003;  // m; what they may be off by

struct Field {
  DesignModel design;
  std::unique_ptr<DesignSurface> surface;
  DistanceVolume volume;
};

Field field_of(DesignModel design, const DistanceFieldOptions& options = {}) {
  Field field;
  field.design = std::move(design);
  auto surface = DesignSurface::build(field.design);
  EXPECT_TRUE(surface.has_value());
  field.surface = std::make_unique<DesignSurface>(std::move(*surface));
  auto volume = make_distance_field(*field.surface, field.design.bounds(), options);
  EXPECT_TRUE(volume.has_value());
  field.volume = std::move(*volume);
  return field;
}

// How a volume does at random places within kNear of the surface, which `exact` gives.
struct Score {
  int places = 0;
  double right = 0;  // share
  double worst_m = 0;
  int wrong_side = 0;  // of those further than kRight from the surface
};

Score score(const DistanceVolume& volume, const Eigen::AlignedBox3d& bounds, int places,
            const std::function<double(const Eigen::Vector3f&)>& exact) {
  Score score;
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(0, 1);
  int right = 0;
  while (score.places < places) {
    Eigen::Vector3d p;
    for (Eigen::Index axis = 0; axis < 3; ++axis)
      p[axis] = bounds.min()[axis] - kNear + (bounds.sizes()[axis] + 2 * kNear) * uniform(random);
    const Eigen::Vector3f place = p.cast<float>();
    const double truth = exact(place);
    if (!(std::abs(truth) < kNear)) continue;
    ++score.places;
    const auto found = volume.at(place);
    if (!found) continue;
    const double off = std::abs(double{found->distance_m} - truth);
    score.worst_m = std::max(score.worst_m, off);
    if (off <= kRight) ++right;
    if (std::abs(truth) > kRight && (truth > 0) != (found->distance_m > 0)) ++score.wrong_side;
  }
  score.right = static_cast<double>(right) / places;
  return score;
}

double exact_of(const DesignSurface& surface, const Eigen::Vector3f& place) {
  const auto found = surface.closest(place, static_cast<float>(kNear));
  return found ? double{found->distance} : 1.0;
}

TEST(DistanceField, AgreesWithTheBoxFormula) {
  // A plate: edges, corners, and a middle where both faces are equally near.
  const Eigen::Vector3d centre(0.31, -0.2, 0.1), half(0.15, 0.1, 0.012);
  const Field field = field_of(box_design(centre, half));
  const Score found =
      score(field.volume, field.design.bounds(), 100000,
            [&](const Eigen::Vector3f& p) { return box_distance(p.cast<double>(), centre, half); });
  EXPECT_GT(found.right, 0.9995) << found.worst_m;
  EXPECT_EQ(found.wrong_side, 0);
}

TEST(DistanceField, AgreesWithTheTorusFormulaWithinItsFacets) {
  const double R = 0.3, r = 0.06;
  const int around = 300, across = 80;  // facets leave the round by 0.07 mm at most
  const Field field = field_of(torus_design(R, r, around, across));
  const Score found =
      score(field.volume, field.design.bounds(), 100000,
            [&](const Eigen::Vector3f& p) { return torus_distance(p.cast<double>(), R, r); });
  EXPECT_GT(found.right, 0.9995) << found.worst_m;
  EXPECT_EQ(found.wrong_side, 0);
}

TEST(DistanceField, ReachesAlongAPipeOfThreeMetres) {
  const double radius = 0.0571, length = 3.0;
  const Field field = field_of(capped_cylinder_design(radius, length, 360));
  for (const auto& size :
       {field.volume.grid.size, field.volume.nodes.size, field.volume.bricks.size})
    EXPECT_LE(*std::max_element(size.begin(), size.end()), DistanceVolume::kLargestSide);
  const Eigen::AlignedBox3d bounds = field.design.bounds();
  const Score found = score(field.volume, bounds, 100000, [&](const Eigen::Vector3f& p) {
    // The cylinder stands on z: by formula, from its own bounds.
    const Eigen::Vector3d q = p.cast<double>() - bounds.center();
    const double aside = std::hypot(q.x(), q.y()) - radius;
    const double along = std::abs(q.z()) - 0.5 * length;
    return std::hypot(std::max(aside, 0.0), std::max(along, 0.0)) +
           std::min(std::max(aside, along), 0.0);
  });
  EXPECT_GT(found.right, 0.9995) << found.worst_m;
  EXPECT_EQ(found.wrong_side, 0);
}

TEST(DistanceField, AgreesWithTheSurfaceOfTheSampleSpool) {
  auto model = read_design(source_dir() / "assets/sample/spool.glb");
  ASSERT_TRUE(model);
  const auto whole = DesignSurface::build(*model);
  ASSERT_TRUE(whole);
  const Field field = field_of(exterior_of(*model, *whole));
  const Score found = score(field.volume, field.design.bounds(), 100000,
                            [&](const Eigen::Vector3f& p) { return exact_of(*field.surface, p); });
  EXPECT_GT(found.right, 0.9995) << found.worst_m;
}

TEST(DistanceField, GivesTheNormalWhereASurfaceIsNear) {
  const Field field = field_of(torus_design(0.15, 0.06, 120, 80));
  std::mt19937 random(13);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int i = 0; i < 5000; ++i) {
    const double around = std::numbers::pi * uniform(random);
    const double across = std::numbers::pi * uniform(random);
    const double height = kNear * uniform(random);
    const Eigen::Vector3d ring(std::cos(around), std::sin(around), 0);
    const Eigen::Vector3d out =
        std::cos(across) * ring + std::sin(across) * Eigen::Vector3d::UnitZ();
    const auto found = field.volume.at((0.15 * ring + (0.06 + height) * out).cast<float>());
    ASSERT_TRUE(found);
    // Facets turn by 4.5 degrees, and cells are up to a quarter of the tube wide.
    EXPECT_GT(found->outward.cast<double>().dot(out), std::cos(0.15));
  }
}

TEST(DistanceField, KnowsNothingBeyondItsBandAndAllWithin) {
  const Eigen::Vector3d half(0.06, 0.05, 0.04);
  const Field field = field_of(box_design({0, 0, 0}, half), {.band_m = 0.025F});
  std::mt19937 random(14);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int i = 0; i < 50000; ++i) {
    const Eigen::Vector3d p(0.2 * uniform(random), 0.2 * uniform(random), 0.2 * uniform(random));
    const double truth = box_distance(p, {0, 0, 0}, half);
    if (std::abs(std::abs(truth) - 0.025) < 5 * kRight) continue;  // less exact beyond kNear
    EXPECT_EQ(field.volume.at(p.cast<float>()).has_value(), std::abs(truth) < 0.025)
        << p.transpose();
  }
}

TEST(DistanceField, KeepsToItsBricksAndSpendsThemWhereItIsOffMost) {
  const Eigen::Vector3d centre(0, 0, 0), half(0.2, 0.15, 0.012);
  const DesignModel design = box_design(centre, half);
  const auto exact = [&](const Eigen::Vector3f& p) {
    return box_distance(p.cast<double>(), centre, half);
  };
  const Field all = field_of(design);
  const std::size_t needed = all.volume.brick_count();
  double before = score(all.volume, design.bounds(), 20000, exact).right;
  for (const std::size_t most : {needed / 2, needed / 8, needed / 32}) {
    const Field field = field_of(design, {.most_bricks = most});
    // The last layer of bricks in their texture may be begun and not full.
    const auto side = static_cast<std::size_t>(field.volume.bricks.size[0] / 5);
    EXPECT_LE(field.volume.brick_count(), most + side * side);
    const double right = score(field.volume, design.bounds(), 20000, exact).right;
    EXPECT_LE(right, before);
    EXPECT_GT(right, 0.3) << most;  // a plate is plane for the most part
    before = right;
  }
  EXPECT_LT(before, 0.999);
}

TEST(DistanceField, FitsTexturesHoweverLongTheDesign) {
  DesignModel design = capped_cylinder_design(0.3, 60, 24);
  append_design(design, box_design({40, 30, 20}, {0.5, 0.5, 0.5}));
  const Field field = field_of(std::move(design), {.most_bricks = 4000});
  for (const auto& size :
       {field.volume.grid.size, field.volume.nodes.size, field.volume.bricks.size})
    EXPECT_LE(*std::max_element(size.begin(), size.end()), DistanceVolume::kLargestSide);
  EXPECT_LE(field.volume.brick_count(), 4000U + 17 * 17);
  EXPECT_TRUE(field.volume.at({40, 30, 20.505F}));
}

TEST(DistanceField, IsTheSameEveryTime) {
  const DesignModel design = capped_cylinder_design(0.05, 0.1, 30);
  const DistanceVolume once = field_of(design).volume;
  const DistanceVolume again = field_of(design).volume;
  EXPECT_EQ(once.grid.data, again.grid.data);
  EXPECT_EQ(once.nodes.data, again.nodes.data);
  EXPECT_TRUE(once.bricks.data == again.bricks.data);
}

TEST(DistanceField, EndsWhenItIsTold) {
  const DesignModel design = torus_design(1.0, 0.05, 600, 80);
  const auto surface = DesignSurface::build(design);
  ASSERT_TRUE(surface);
  std::optional<DistanceVolume> made;
  const auto obeyed = seconds_until_obeyed(0.05, [&](const Watch& watch) {
    made = make_distance_field(*surface, design.bounds(), {.tolerance_m = 1e-6F}, watch);
  });
  ASSERT_TRUE(obeyed) << "it was done before it was told";
  EXPECT_LT(*obeyed, kObeyed_s);
  EXPECT_FALSE(made);
}

// A brick's texels and middles of any field.
DistanceBrick brick_of(const std::function<DistanceSample(const Eigen::Vector3f&)>& field,
                       float spacing_m) {
  BrickTexels texels;
  BrickMiddles middles;
  const auto fill = [&](auto& places, std::size_t side, float first) {
    std::size_t n = 0;
    for (DistanceSample& place : places) {
      const Eigen::Vector3f cell(static_cast<float>(n % side), static_cast<float>(n / side % side),
                                 static_cast<float>(n / (side * side)));
      place = field(spacing_m * (cell + Eigen::Vector3f::Constant(first)));
      ++n;
    }
  };
  fill(texels, kBrickSide, 0);
  fill(middles, kBrickCells, 0.5F);
  return make_brick(texels, middles, spacing_m, {1e-5F, 0.02F, 0.03F});
}

TEST(DistanceBrick, HoldsTheMiddleOfAPlateWithoutRoundingItOff) {
  const float middle = 0.0173F;  // within a cell of 8 mm
  const DistanceBrick brick = brick_of(
      [&](const Eigen::Vector3f& p) {
        const float below = middle - p.x();
        return DistanceSample{-0.012F + std::abs(below), {below < 0 ? 1.0F : -1.0F, 0, 0}};
      },
      0.008F);
  // One piece would be off by 4 mm there.
  EXPECT_LT(brick.error_m, 1e-5F);
}

TEST(DistanceBrick, HoldsAJumpFromInsideToOutside) {
  // As in the mouth of a bore whose wall no sensor sees: nearest to the rim on both sides.
  const DistanceBrick brick = brick_of(
      [](const Eigen::Vector3f& p) {
        const float x = p.x() - 0.0117F;
        return x < 0 ? DistanceSample{x - 0.01F, {1, 0, 0}}
                     : DistanceSample{0.01F + x, {0.6F, 0.8F, 0}};
      },
      0.004F);
  EXPECT_LT(brick.error_m, 2e-3F);  // one piece: 10 mm
}

TEST(DistanceBrick, HoldsOnePieceOfAPlane) {
  const Eigen::Vector3f normal = Eigen::Vector3f(1, 2, 3).normalized();
  const DistanceBrick brick = brick_of(
      [&](const Eigen::Vector3f& p) {
        return DistanceSample{normal.dot(p) - 0.02F, normal};
      },
      0.008F);
  EXPECT_LT(brick.error_m, 1e-6F);
  for (const auto& texel : brick.texels) EXPECT_TRUE(texel[0] == texel[1]);
}

}  // namespace
}  // namespace spool::test
