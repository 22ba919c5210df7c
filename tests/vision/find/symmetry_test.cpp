// What lays a design on itself: half-turns, no mirrors, and what a bolt hole breaks.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/find/symmetry.h"

#include <cmath>
#include <numbers>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "tests/vision/design/shapes.h"
#include "tests/vision/find/room.h"

namespace spool {
namespace {

using Eigen::Vector3d;
using test::Rod;

constexpr double kPi = std::numbers::pi;

Pose turn(const Vector3d& axis, double angle, const Vector3d& through = Vector3d::Zero()) {
  Pose T = Pose::Identity();
  T.linear() = Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
  T.translation() = through - T.linear() * through;
  return T;
}

// Off (m) at the worst place of the design.
double nearest(const FinderModel& model, const std::vector<Pose>& motions, const Pose& truth) {
  double least = 1e9;
  for (const Pose& motion : motions)
    least = std::min(least, test::pose_distance(model, motion, truth));
  return least;
}

void expect_proper(const FinderModel& model) {
  for (const Pose& motion : model.symmetries) {
    EXPECT_NEAR(motion.linear().determinant(), 1, 1e-9);
    EXPECT_GT(test::pose_distance(model, motion, Pose::Identity()), model.same_m());
  }
}

TEST(Symmetries, OfABoxAreItsThreeHalfTurns) {
  const FinderModel model = test::finder_of(test::box_design({0.1, 0.2, 0.3}, {0.5, 0.3, 0.2}));
  expect_proper(model);
  EXPECT_EQ(model.symmetries.size(), 3U);
  for (const Vector3d& axis : {Vector3d(1, 0, 0), Vector3d(0, 1, 0), Vector3d(0, 0, 1)})
    EXPECT_LT(nearest(model, model.symmetries, turn(axis, kPi, {0.1, 0.2, 0.3})), 0.002);
  EXPECT_EQ(model.free_motions, 0);
  const Pose T = turn({1, 2, 3}, 1.0, {4, 5, 6});
  EXPECT_TRUE(model.are_symmetric(T, turn({0, 1, 0}, kPi, {0.1, 0.2, 0.3}) * T));
  EXPECT_FALSE(model.are_symmetric(T, turn({0, 1, 0}, 0.5 * kPi, {0.1, 0.2, 0.3}) * T));
}

TEST(Symmetries, OfAFlangedPipeAreTurnsAboutItAndEndForEnd) {
  const std::vector<Rod> pipe = {{{0, 0, 0}, Vector3d::UnitZ(), 0.05, 0.8},
                                 {{0, 0, -0.03}, Vector3d::UnitZ(), 0.1, 0.03},
                                 {{0, 0, 0.8}, Vector3d::UnitZ(), 0.1, 0.03}};
  const FinderModel model = test::finder_of(test::design_of(pipe));
  expect_proper(model);
  EXPECT_EQ(model.free_motions, 1);
  ASSERT_FALSE(model.symmetries.empty());
  bool is_turned_over = false;
  for (const Pose& motion : model.symmetries) {
    const double along = motion.linear()(2, 2);
    EXPECT_NEAR(std::abs(along), 1, 1e-4);  // keeps the axis
    is_turned_over = is_turned_over || along < 0;
    const Vector3d middle = motion * Vector3d(0, 0, 0.4);
    EXPECT_LT((middle - Vector3d(0, 0, 0.4)).norm(), 0.002);
  }
  EXPECT_TRUE(is_turned_over);
}

TEST(Symmetries, AreNoneOfATeeThatOnlyAMirrorLaysOnItself) {
  const FinderModel model = test::finder_of(test::design_of(test::tee_spool()));
  EXPECT_TRUE(model.symmetries.empty());
  // But it resembles itself, upside down or turned about the run, and that is known.
  EXPECT_FALSE(model.alike.empty());
  for (const SelfLikeness& alike : model.alike) {
    EXPECT_GE(alike.share, 0.5);
    EXPECT_LT(alike.share, 0.97);
  }
}

// A disc of 0.2 m with `holes` through it, 20 mm thick, on the end of a pipe of 0.15 m.
DesignModel holed_flange(int holes) {
  constexpr int kAround = 96;
  constexpr double kThick = 0.02;
  const std::vector<double> rings = {0, 0.05, 0.068, 0.082, 0.1};
  DesignModel design = test::design_of({{{0, 0, kThick}, Vector3d::UnitZ(), 0.03, 0.15}});
  const auto part = static_cast<std::int32_t>(design.parts.size());
  design.parts.emplace_back();
  design.parts[1].name = "flange";
  design.parts[1].first_triangle = static_cast<std::uint32_t>(design.mesh.triangles.size());
  const auto at = [&](std::size_t ring, int step, double z) {
    const double angle = 2 * kPi * step / kAround;
    return Vector3d(rings[ring] * std::cos(angle), rings[ring] * std::sin(angle), z);
  };
  const auto quad = [&](const Vector3d& a, const Vector3d& b, const Vector3d& c,
                        const Vector3d& d) {
    const auto first = static_cast<std::uint32_t>(design.mesh.vertices.size());
    for (const Vector3d& p : {a, b, c, d}) design.mesh.vertices.push_back(p.cast<float>());
    design.mesh.triangles.push_back({first, first + 1, first + 2});
    design.mesh.triangles.push_back({first, first + 2, first + 3});
    design.triangle_part.insert(design.triangle_part.end(), 2, part);
  };
  // A hole is four steps wide and lies between the third ring and the fourth.
  const auto is_hole = [&](std::size_t ring, int step) {
    if (holes == 0 || ring != 2) return false;
    return (step + kAround) % (kAround / holes) < 4;
  };
  for (std::size_t ring = 0; ring + 1 < rings.size(); ++ring)
    for (int step = 0; step < kAround; ++step) {
      if (is_hole(ring, step)) {
        quad(at(ring, step, 0), at(ring, step + 1, 0), at(ring, step + 1, kThick),
             at(ring, step, kThick));
        quad(at(ring + 1, step, 0), at(ring + 1, step, kThick), at(ring + 1, step + 1, kThick),
             at(ring + 1, step + 1, 0));
        for (const int side : {0, 1})
          if (!is_hole(ring, step + (side == 0 ? -1 : 1)))
            quad(at(ring, step + side, 0), at(ring, step + side, kThick),
                 at(ring + 1, step + side, kThick), at(ring + 1, step + side, 0));
        continue;
      }
      quad(at(ring, step, 0), at(ring, step + 1, 0), at(ring + 1, step + 1, 0),
           at(ring + 1, step, 0));
      quad(at(ring, step, kThick), at(ring + 1, step, kThick), at(ring + 1, step + 1, kThick),
           at(ring, step + 1, kThick));
    }
  for (int step = 0; step < kAround; ++step)
    quad(at(4, step, 0), at(4, step + 1, 0), at(4, step + 1, kThick), at(4, step, kThick));
  design.parts[1].triangle_count =
      static_cast<std::uint32_t>(design.mesh.triangles.size()) - design.parts[1].first_triangle;
  return design;
}

// Turning (rad, 0 to 2 pi) of a motion about z.
double turned_by(const Pose& motion) {
  return std::atan2(motion.linear()(1, 0), motion.linear()(0, 0));
}

TEST(Symmetries, AreBrokenByBoltHoles) {
  // Without holes any turn is one.
  const FinderModel plain = test::finder_of(holed_flange(0));
  EXPECT_EQ(plain.free_motions, 1);
  EXPECT_GT(plain.symmetries.size(), 2U);
  // With four, turns by a quarter alone: between them a hole lies on steel.
  const FinderModel holed = test::finder_of(holed_flange(4));
  expect_proper(holed);
  for (const Pose& motion : holed.symmetries) {
    const double off = std::remainder(turned_by(motion), 0.5 * kPi);
    EXPECT_NEAR(off, 0, 0.01) << "half a millimetre at the bolt circle";
    EXPECT_GT(motion.linear()(2, 2), 0.99);
  }
  EXPECT_FALSE(holed.are_symmetric(Pose::Identity(), turn({0, 0, 1}, 0.25 * kPi)));
  // Three holes and no more: one of four is missing.
  const FinderModel three = test::finder_of(holed_flange(3));
  EXPECT_FALSE(three.are_symmetric(Pose::Identity(), turn({0, 0, 1}, 0.5 * kPi)));
}

}  // namespace
}  // namespace spool
