// The few views of a report show every part that can be seen.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/evidence/view_choice.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "tests/app/evidence/sample_record.h"

namespace spool::evidence {
namespace {

InspectionRecord record_of(DesignModel model) {
  InspectionRecord record;
  record.design = test::prepared(std::move(model));
  return record;
}

// The least component of any view's direction along `axis`.
double least_along(const std::vector<ViewChoice>& views, const Eigen::Vector3d& axis) {
  double least = 1;
  for (const auto& view : views) least = std::min(least, view.direction.dot(axis));
  return least;
}

TEST(ChooseViews, LooksFromBothSidesOfASingleBox) {
  DesignModel model;
  test::add_box(model, "box", {0, 0, 0}, {1, 1, 1});
  const auto views = choose_views(record_of(std::move(model)), 1.6);
  ASSERT_EQ(views.size(), 2U);
  // A corner shows three faces of six; the second view has to add the other three.
  EXPECT_LT(views[0].direction.dot(views[1].direction), -0.9);
}

TEST(ChooseViews, FindsTheOnlyWayIntoAChannel) {
  // "plug" lies at the bottom of a shaft that is open towards -y only.
  DesignModel model;
  test::add_box(model, "lid", {-0.5, 0.3, -0.5}, {0.5, 0.35, 0.5});
  test::add_box(model, "left", {-0.5, -0.5, -0.5}, {-0.1, 0.3, 0.5});
  test::add_box(model, "right", {0.1, -0.5, -0.5}, {0.5, 0.3, 0.5});
  test::add_box(model, "front", {-0.1, -0.5, -0.5}, {0.1, 0.3, -0.1});
  test::add_box(model, "back", {-0.1, -0.5, 0.1}, {0.1, 0.3, 0.5});
  test::add_box(model, "plug", {-0.09, -0.31, -0.09}, {0.09, 0.29, 0.09});
  const auto views = choose_views(record_of(std::move(model)), 1.6);
  // Only straight up the shaft is the plug's end in sight: at 45 degrees 0.19 m of depth hide all
  // of its 0.18 m.
  const bool looks_in = std::any_of(views.begin(), views.end(), [](const ViewChoice& view) {
    return view.direction.dot(Eigen::Vector3d::UnitY()) > 0.99;
  });
  EXPECT_TRUE(looks_in);
}

TEST(ChooseViews, LooksAtSteelThatShouldNotBeThere) {
  DesignModel model;
  test::add_box(model, "plate", {0, 0, 0}, {1, 1, 0.01});
  auto record = record_of(std::move(model));
  // Measured from above only; below it, within the shadow of the plate from there, hangs a branch.
  auto& inspection = record.inspection;
  const auto add = [&](const Eigen::Vector3f& point, PointClass kind, float distance) {
    inspection.scan_design.points.push_back(point);
    inspection.declutter.classes.push_back(kind);
    inspection.deviations.distance_m.push_back(distance);
    inspection.deviations.part.push_back(0);
  };
  for (int i = 0; i < 100; ++i)
    add({0.01F * static_cast<float>(i), 0.5F, 0.01F}, PointClass::kObject, 0.0F);
  const auto looks_up = [](const std::vector<ViewChoice>& views) {
    return least_along(views, -Eigen::Vector3d::UnitZ()) < -0.3;
  };
  ASSERT_FALSE(looks_up(choose_views(record, 1.6)));
  Unexpected branch;
  branch.part = 0;
  for (int i = 0; i < 50; ++i) {
    branch.points.push_back(static_cast<std::uint32_t>(inspection.scan_design.size()));
    add({0.5F, 0.5F, -0.02F - 0.002F * static_cast<float>(i)}, PointClass::kContradicting, 0.02F);
  }
  inspection.unexpected.push_back(branch);
  EXPECT_TRUE(looks_up(choose_views(record, 1.6)));
}

TEST(ChooseViews, LooksAtTheSideThatWasMeasured) {
  DesignModel model;
  test::add_box(model, "plate", {0, 0, 0}, {1, 1, 0.01});
  auto record = record_of(std::move(model));
  auto& inspection = record.inspection;
  for (int i = 0; i < 100; ++i) {
    inspection.scan_design.points.emplace_back(0.1F + 0.008F * static_cast<float>(i), 0.5F,
                                               -0.001F);
    inspection.declutter.classes.push_back(PointClass::kObject);
    inspection.deviations.distance_m.push_back(0.001F);
    inspection.deviations.part.push_back(0);
  }
  const auto views = choose_views(record, 1.6);
  ASSERT_FALSE(views.empty());
  EXPECT_GT(views[0].direction.z(), 0.2);  // from below, where the points are
}

TEST(ChooseViews, GivesUnitDirectionsWithUpAcross) {
  const auto views = choose_views(test::sample_record(), 1.6);
  EXPECT_GE(views.size(), 2U);
  EXPECT_LE(views.size(), 6U);
  for (const auto& view : views) {
    EXPECT_NEAR(view.direction.norm(), 1, 1e-9);
    EXPECT_NEAR(view.up.norm(), 1, 1e-9);
    EXPECT_NEAR(view.up.dot(view.direction), 0, 1e-9);
    EXPECT_EQ(view.text.find("seen from"), 0U);
  }
}

TEST(ChooseViews, TakesTheSensorsOwnPlaceOfAFrame) {
  auto record = test::sample_record();
  record.scan.frame = 0;
  // The sensor looks along the design's -y with its y axis along -z... a proper turn of the camera
  // frame.
  Eigen::Matrix3d turn;
  turn.col(2) = -Eigen::Vector3d::UnitY();
  turn.col(1) = -Eigen::Vector3d::UnitZ();
  turn.col(0) = turn.col(1).cross(turn.col(2));
  record.inspection.alignment.T_design_scan.linear() = turn;
  const auto views = choose_views(record, 1.6);
  const bool there = std::any_of(views.begin(), views.end(), [](const ViewChoice& view) {
    return view.text == "seen from where the sensor was" &&
           view.up.isApprox(Eigen::Vector3d::UnitZ());
  });
  EXPECT_TRUE(there || least_along(views, Eigen::Vector3d::UnitY()) < -0.5);
}

}  // namespace
}  // namespace spool::evidence
