// As-built changes: what moves, what follows, what the truth says.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/simulator/as_built.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/shared_data.h"
#include "tests/tools/simulator/test_scene.h"
#include "tools/simulator/solids.h"
#include "tools/simulator/truth.h"

namespace spool::simulator {
namespace {

// Three pipes of 1 m end to end along z, and one branching off the second's middle along x.
DesignModel line() {
  DesignModel design;
  const TriangleMesh mesh = cylinder_mesh(0.1, 1, 16);
  const auto add = [&](const char* name, const Pose& pose) {
    Part part;
    part.name = name;
    part.kind = PartKind::kPipe;
    part.T_design_part = pose;
    part.ports = {{.name = "in", .position = {0, 0, -0.5}, .direction = {0, 0, -1}},
                  {.name = "out", .position = {0, 0, 0.5}, .direction = {0, 0, 1}}};
    part.first_triangle = static_cast<std::uint32_t>(design.mesh.triangles.size());
    part.triangle_count = static_cast<std::uint32_t>(mesh.triangles.size());
    const auto first = static_cast<std::uint32_t>(design.mesh.vertices.size());
    for (const auto& v : mesh.vertices)
      design.mesh.vertices.push_back((pose * v.cast<double>()).cast<float>());
    for (const auto& t : mesh.triangles) {
      design.mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
      design.triangle_part.push_back(static_cast<std::int32_t>(design.parts.size()));
    }
    design.parts.push_back(part);
  };
  Pose pose = Pose::Identity();
  for (const char* name : {"A", "B", "C"}) {
    add(name, pose);
    pose.translation().z() += 1;
  }
  Pose branch = Pose::Identity();
  branch.linear() = Eigen::AngleAxisd(std::numbers::pi / 2, Eigen::Vector3d::UnitY()).matrix();
  branch.translation() = Eigen::Vector3d(0.5, 0, 1);
  add("D", branch);
  design.joints = {{"W1", 0, 1, 1, 0, JointType::kFab},
                   {"W2", 1, 1, 2, 0, JointType::kFab},
                   {"W3", 1, 1, 3, 0, JointType::kFab}};
  design.datums = {0};
  return design;
}

Eigen::AlignedBox3d box_of(const AsBuilt& built, int part) {
  Eigen::AlignedBox3d box;
  for (std::size_t t = 0; t < built.mesh.triangles.size(); ++t)
    if (built.triangle_part[t] == part)
      for (const auto v : built.mesh.triangles[t])
        box.extend(built.mesh.vertices[v].cast<double>());
  return box;
}

TEST(AsBuilt, IsTheDesignWithoutChanges) {
  const DesignModel design = line();
  const auto built = build_as(design, {}, "scene");
  ASSERT_TRUE(built);
  EXPECT_EQ(built->mesh.triangles.size(), design.mesh.triangles.size());
  for (int part = 0; part < 4; ++part)
    EXPECT_TRUE(built->parts[static_cast<std::size_t>(part)].T_design_part.isApprox(
        design.parts[static_cast<std::size_t>(part)].T_design_part));
}

TEST(AsBuilt, ALongerPipePushesOutWhatHangsOnIt) {
  const auto built = build_as(line(), {{.part = "B", .length_m = 0.006}}, "scene");
  ASSERT_TRUE(built) << built.error().message;
  EXPECT_NEAR(box_of(*built, 1).min().z(), 0.5, 1e-6) << "its near end stays";
  EXPECT_NEAR(box_of(*built, 1).max().z(), 1.506, 1e-6);
  EXPECT_NEAR(box_of(*built, 2).min().z(), 1.506, 1e-6);
  EXPECT_NEAR(box_of(*built, 2).max().z(), 2.506, 1e-6);
  EXPECT_NEAR(box_of(*built, 0).max().z(), 0.5, 1e-6) << "what lies before stays";
  EXPECT_EQ(built->parts[1].length_m, 0.006);
}

TEST(AsBuilt, ATurnedPartTakesItsFollowersAlongAboutThePort) {
  const auto built =
      build_as(line(), {{.part = "B", .rotation_rad = {std::numbers::pi / 2, 0, 0}, .about = "in"}},
               "scene");
  ASSERT_TRUE(built) << built.error().message;
  // About x at (0, 0, 0.5): what pointed along z points along -y.
  EXPECT_TRUE(
      built->parts[1].T_design_part.translation().isApprox(Eigen::Vector3d(0, -0.5, 0.5), 1e-9));
  EXPECT_TRUE(
      built->parts[2].T_design_part.translation().isApprox(Eigen::Vector3d(0, -1.5, 0.5), 1e-9));
  EXPECT_TRUE(built->parts[0].T_design_part.isApprox(Pose::Identity()));
}

TEST(AsBuilt, FollowersStayWhenToldTo) {
  const auto built =
      build_as(line(), {{.part = "B", .translation_m = {0.01, 0, 0}, .followers = false}}, "scene");
  ASSERT_TRUE(built);
  EXPECT_NEAR(built->parts[1].T_design_part.translation().x(), 0.01, 1e-12);
  EXPECT_NEAR(built->parts[2].T_design_part.translation().x(), 0, 1e-12);
}

TEST(AsBuilt, AMissingPartIsNotSeen) {
  const auto built = build_as(line(), {{.part = "C", .missing = true}}, "scene");
  ASSERT_TRUE(built);
  EXPECT_TRUE(box_of(*built, 2).isEmpty());
  EXPECT_FALSE(box_of(*built, 3).isEmpty());
}

TEST(AsBuilt, WithoutJointsTheAssemblyOrderCounts) {
  DesignModel design = line();
  design.joints.clear();
  const auto built = build_as(design, {{.part = "B", .translation_m = {0, 0.02, 0}}}, "scene");
  ASSERT_TRUE(built);
  EXPECT_NEAR(built->parts[3].T_design_part.translation().y(), 0.02, 1e-12);
  EXPECT_NEAR(built->parts[0].T_design_part.translation().y(), 0, 1e-12);
}

TEST(AsBuilt, RefusesUnknownPartsAndPorts) {
  for (const AsBuiltChange& change :
       {AsBuiltChange{.part = "Z"}, AsBuiltChange{.part = "B", .about = "side"}}) {
    const auto built = build_as(line(), {change}, "scene.json");
    ASSERT_FALSE(built);
    EXPECT_EQ(built.error().code, ErrorCode::kBadInput);
    EXPECT_EQ(built.error().message.rfind("scene.json", 0), 0u);
  }
}

TEST(Truth, OfTheSampleBlamesTheOneWeldThatIsWrong) {
  const auto simulator = Simulator::open(test::source_dir() / "assets" / "sample" / "scene.json");
  ASSERT_TRUE(simulator) << simulator.error().message;
  const nlohmann::json truth = truth_json(*simulator, 2);
  ASSERT_EQ(truth["frames"].size(), 2u);
  // Elbow E2 is rolled by 5 degrees about its inlet; P5 and F3 hang on it.
  const double roll = 5 * std::numbers::pi / 180;
  const auto size = [](const nlohmann::json& v) {
    const auto x = v.get<std::vector<double>>();
    return std::hypot(x[0], x[1], x[2]);
  };
  for (const auto& part : truth["parts"]) {
    const bool moved = part["name"] == "E2" || part["name"] == "P5" || part["name"] == "F3";
    EXPECT_NEAR(size(part["pose_error"]["rotation_rad"]), moved ? roll : 0, 1e-4) << part["name"];
    if (!moved) {
      EXPECT_LT(size(part["pose_error"]["translation_m"]), 1e-9) << part["name"];
    }
  }
  for (const auto& joint : truth["joints"])
    EXPECT_NEAR(size(joint["error"]["rotation_rad"]), joint["weld"] == "W8" ? roll : 0, 1e-4)
        << joint["weld"];
}

}  // namespace
}  // namespace spool::simulator
