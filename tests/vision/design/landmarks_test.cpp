// Laws of the points that are proposed for picking.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/design/landmarks.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace spool {
namespace {

// An L of two closed round bars, the second with a kind of its own.
DesignModel bars(const Pose& T) {
  DesignModel model;
  const auto add = [&](const std::string& name, PartKind kind, const Eigen::Vector3d& from,
                       const Eigen::Vector3d& to, double radius) {
    Part part;
    part.name = name;
    part.kind = kind;
    part.first_triangle = static_cast<std::uint32_t>(model.mesh.triangles.size());
    const Eigen::Vector3d axis = (to - from).normalized();
    const Eigen::Vector3d x = axis.unitOrthogonal(), y = axis.cross(x);
    constexpr std::uint32_t kSides = 24;
    const auto base = static_cast<std::uint32_t>(model.mesh.vertices.size());
    for (std::uint32_t i = 0; i < kSides; ++i) {
      const double angle = 2 * std::numbers::pi * i / kSides;
      const Eigen::Vector3d out = radius * (std::cos(angle) * x + std::sin(angle) * y);
      model.mesh.vertices.push_back((T * (from + out)).cast<float>());
      model.mesh.vertices.push_back((T * (to + out)).cast<float>());
    }
    model.mesh.vertices.push_back((T * from).cast<float>());
    model.mesh.vertices.push_back((T * to).cast<float>());
    for (std::uint32_t i = 0; i < kSides; ++i) {
      const std::uint32_t a = base + 2 * i, b = base + 2 * ((i + 1) % kSides);
      model.mesh.triangles.push_back({a, b, b + 1});
      model.mesh.triangles.push_back({a, b + 1, a + 1});
      model.mesh.triangles.push_back({base + 2 * kSides, b, a});
      model.mesh.triangles.push_back({base + 2 * kSides + 1, a + 1, b + 1});
    }
    part.triangle_count =
        static_cast<std::uint32_t>(model.mesh.triangles.size()) - part.first_triangle;
    model.triangle_part.insert(model.triangle_part.end(), part.triangle_count,
                               static_cast<std::int32_t>(model.parts.size()));
    model.parts.push_back(part);
  };
  add("P1", PartKind::kPipe, {0, 0, 0}, {1, 0, 0}, 0.05);
  add("F1", PartKind::kFlange, {1, 0, 0}, {1, 0.6, 0}, 0.08);
  return model;
}

void expect_usable(const LandmarkProposal& proposal, const DesignModel& model,
                   const DesignSurface& surface) {
  ASSERT_GE(proposal.landmarks.size(), 3U);
  const double size = model.bounds().diagonal().norm();
  for (const Landmark& landmark : proposal.landmarks) {
    const auto nearest = surface.closest(landmark.position.cast<float>(), 0.01F);
    ASSERT_TRUE(nearest.has_value());
    EXPECT_LT(std::abs(nearest->distance), 1e-4F) << "on the surface";
    EXPECT_FALSE(landmark.text.empty());
    ASSERT_GE(landmark.part, 0);
    // Seen along the look that is proposed with them.
    const Eigen::Vector3d from = landmark.position - 2e-3 * size * proposal.look;
    EXPECT_FALSE(
        surface.cast(from.cast<float>(), (-proposal.look).cast<float>(), 5.0F).has_value());
  }
  const Eigen::Vector3d& a = proposal.landmarks[0].position;
  const Eigen::Vector3d ab = proposal.landmarks[1].position - a,
                        ac = proposal.landmarks[2].position - a;
  const double longest = std::max({ab.norm(), ac.norm(), (ab - ac).norm()});
  EXPECT_GT(longest, 0.5 * size) << "far apart";
  EXPECT_GT(ab.cross(ac).norm(), 0.1 * longest * longest) << "not in line";
}

TEST(Landmarks, AreOnTheSurfaceFarApartNotInLineAndInSight) {
  const DesignModel model = bars(Pose::Identity());
  const auto surface = DesignSurface::build(model);
  ASSERT_TRUE(surface.has_value());
  expect_usable(propose_landmarks(model, *surface), model, *surface);
}

TEST(Landmarks, StayUsableHoweverTheDesignLies) {
  for (int turn = 1; turn < 6; ++turn) {
    Vector6d small;
    small << 0.3 * turn, -0.2, 0.1, 0.7 * turn, 0.4 * turn, -0.5 * turn;
    const DesignModel model = bars(pose_from_small(small));
    const auto surface = DesignSurface::build(model);
    ASSERT_TRUE(surface.has_value());
    SCOPED_TRACE(turn);
    expect_usable(propose_landmarks(model, *surface), model, *surface);
  }
}

TEST(Landmarks, PreferAFlangesRimAndSaySo) {
  const DesignModel model = bars(Pose::Identity());
  const auto surface = DesignSurface::build(model);
  ASSERT_TRUE(surface.has_value());
  const LandmarkProposal proposal = propose_landmarks(model, *surface);
  std::size_t rims = 0;
  for (const Landmark& landmark : proposal.landmarks) rims += landmark.text == "flange F1, rim";
  EXPECT_GE(rims, 1U);
}

TEST(Landmarks, AreNoneWhereADesignHasNoThreePointsOffALine) {
  DesignModel needle;
  Part part;
  part.name = "needle";
  part.triangle_count = 1;
  needle.mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0.5F, 1e-4F, 0}};
  needle.mesh.triangles = {{0, 1, 2}};
  needle.triangle_part = {0};
  needle.parts = {part};
  const auto surface = DesignSurface::build(needle);
  ASSERT_TRUE(surface.has_value());
  EXPECT_TRUE(propose_landmarks(needle, *surface).landmarks.empty());
}

}  // namespace
}  // namespace spool
