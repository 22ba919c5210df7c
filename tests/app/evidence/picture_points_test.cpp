// A picture shows the steel and what contradicts it; clutter never covers it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/evidence/picture_points.h"

#include <limits>

#include <gtest/gtest.h>

#include "tests/app/evidence/sample_record.h"

namespace spool::evidence {
namespace {

TEST(PicturePoints, KeepTheObjectAndNearClutterOnly) {
  auto record = test::sample_record();
  auto& inspection = record.inspection;
  const auto add = [&](const Eigen::Vector3f& point) {
    inspection.scan_design.points.push_back(point);
    inspection.declutter.classes.push_back(PointClass::kClutter);
    inspection.deviations.distance_m.push_back(std::numeric_limits<float>::quiet_NaN());
    inspection.deviations.part.push_back(-1);
  };
  add({0.2F, 0.2F, 0.15F});  // beside the post, within the bounds
  add({20.0F, 0.0F, 0.0F});  // a wall far off
  const auto points = points_near_design(inspection, record.design->model.bounds());
  // Two of the object, one contradicting, one of clutter; NaN and the two far ones are gone.
  ASSERT_EQ(points.positions.size(), 4U);
  EXPECT_EQ(points.classes, (std::vector<std::uint8_t>{1, 1, 2, 0}));
  EXPECT_FLOAT_EQ(points.deviation_m[2], 0.02F);
}

TEST(PicturePoints, AreNoneWhereNothingWasClassified) {
  auto record = test::sample_record();
  record.inspection.declutter.classes.clear();
  EXPECT_TRUE(
      points_near_design(record.inspection, record.design->model.bounds()).positions.empty());
}

TEST(PicturePoints, LeaveOutOnlyTheClutterInFrontOfTheSteel) {
  DesignModel model;
  test::add_box(model, "box", {-0.1, -0.1, -0.1}, {0.1, 0.1, 0.1});
  const auto design = test::prepared(std::move(model));
  const Eigen::Vector3d eye(0, 0, 2);
  PicturePoints all;
  const auto add = [&](float x, float z, std::uint8_t kind) {
    all.positions.emplace_back(x, 0.0F, z);
    all.deviation_m.push_back(0);
    all.classes.push_back(kind);
  };
  add(0.0F, 0.5F, 0);   // clutter between eye and box: out
  add(0.0F, 0.5F, 2);   // contradicting there: stays
  add(0.0F, 0.11F, 1);  // the object itself
  add(0.0F, -0.5F, 0);  // clutter behind the box
  add(0.3F, 0.5F, 0);   // clutter beside it
  const auto kept = without_hiding_clutter(all, *design->surface, eye, 5.0F, 0.001);
  EXPECT_EQ(kept.classes, (std::vector<std::uint8_t>{2, 1, 0, 0}));
  EXPECT_EQ(kept.positions.size(), kept.deviation_m.size());
  // Steel out of reach is not hidden.
  EXPECT_EQ(without_hiding_clutter(all, *design->surface, eye, 0.1F, 0.001).classes.size(), 5U);
}

TEST(PicturePoints, LeaveOutTheClutterInFrontOfWhatContradicts) {
  DesignModel model;
  test::add_box(model, "box", {-0.1, -0.1, -0.1}, {0.1, 0.1, 0.1});
  const auto design = test::prepared(std::move(model));
  PicturePoints all;
  const auto add = [&](const Eigen::Vector3f& point, std::uint8_t kind) {
    all.positions.push_back(point);
    all.deviation_m.push_back(0);
    all.classes.push_back(kind);
  };
  // A plate of steel beside the box, seen from above; between its points nothing is to be seen
  // either.
  for (int x = 0; x < 20; ++x)
    for (int y = 0; y < 20; ++y)
      add({0.5F + 0.01F * static_cast<float>(x), 0.01F * static_cast<float>(y), 0.0F}, 2);
  add({0.3F, 0.053F, 1.0F}, 0);     // before it, as seen from the eye
  add({0.604F, 0.105F, -0.3F}, 0);  // behind it
  add({0.604F, 0.105F, 0.01F}, 0);  // on it
  add({0.3F, -0.2F, 1.0F}, 0);      // beside it
  const auto kept =
      without_hiding_clutter(all, *design->surface, Eigen::Vector3d(0, 0, 2), 5.0F, 0.01);
  ASSERT_EQ(kept.classes.size(), 403U);
  EXPECT_FLOAT_EQ(kept.positions[400].z(), -0.3F);
}

TEST(SteelBounds, HoldWhatContradictsAndNoClutter) {
  const Eigen::AlignedBox3d design(Eigen::Vector3d::Zero(), Eigen::Vector3d::Ones());
  PicturePoints points;
  points.positions = {{2, 0, 0}, {0, 3, 0}, {0, 0, 4}};
  points.deviation_m = {0, 0, 0};
  points.classes = {2, 0, 1};
  const Eigen::AlignedBox3d bounds = steel_bounds(points, design);
  EXPECT_EQ(bounds.max(), Eigen::Vector3d(2, 1, 1));
  EXPECT_EQ(bounds.min(), Eigen::Vector3d::Zero());
}

TEST(ObjectSpacing, IsTheGridsOwnAndIgnoresClutter) {
  PicturePoints points;
  for (int x = 0; x < 40; ++x)
    for (int y = 0; y < 40; ++y) {
      points.positions.emplace_back(0.01F * static_cast<float>(x), 0.01F * static_cast<float>(y),
                                    0.0F);
      points.classes.push_back(1);
    }
  for (int i = 0; i < 5000; ++i) {
    points.positions.emplace_back(0.0001F * static_cast<float>(i), 0.5F, 0.0F);
    points.classes.push_back(0);
  }
  points.deviation_m.assign(points.positions.size(), 0.0F);
  // On a square grid the fourth neighbour is one step away: the estimate is sqrt(pi / 4) = 0.89 of
  // it.
  EXPECT_NEAR(object_spacing(points), 0.00886, 0.0005);
  EXPECT_EQ(object_spacing(PicturePoints{}), 0.0);
}

}  // namespace
}  // namespace spool::evidence
