// The design file as the project reads it: parts, ports, joints, and sizes as the standards say.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/campaign/design_glb.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"
#include "tools/campaign/designs.h"
#include "vision/core/file_io.h"
#include "vision/design/design_reader.h"

namespace spool::campaign {
namespace {

using Eigen::Vector3d;
constexpr double kFloat = 1e-6;  // m: a float of up to 3.5 m, twice

Result<DesignModel> read_back(const Assembly& assembly) {
  const spool::test::TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "model.glb";
  EXPECT_TRUE(write_file_whole(path, design_glb(assembly)));
  return read_design(path);
}

const spool::Part& part_named(const DesignModel& design, const std::string& name) {
  return *std::find_if(design.parts.begin(), design.parts.end(),
                       [&](const spool::Part& part) { return part.name == name; });
}

// Extent of a part's triangles in its own frame.
Eigen::AlignedBox3d extent(const DesignModel& design, const spool::Part& part) {
  Eigen::AlignedBox3d box;
  for (std::uint32_t t = part.first_triangle; t < part.first_triangle + part.triangle_count; ++t)
    for (const std::uint32_t v : design.mesh.triangles[t])
      box.extend(part.T_design_part.inverse() * design.mesh.vertices[v].cast<double>());
  return box;
}

TEST(DesignGlb, IsReadBackAsItWasPlanned) {
  for (const ObjectKind kind : {ObjectKind::kPipeSpool3m, ObjectKind::kFourBranch,
                                ObjectKind::kBoxFrame, ObjectKind::kRandomSpool}) {
    const Assembly assembly = design_of(kind, 3, true);
    const auto design = read_back(assembly);
    ASSERT_TRUE(design) << design.error().message;
    EXPECT_EQ(design->warnings, std::vector<std::string>());
    ASSERT_EQ(design->parts.size(), assembly.members.size());
    EXPECT_EQ(design->datums, std::vector<int>({0}));
    const std::vector<Pose> poses = poses_of(assembly);
    std::size_t joined = 0;
    for (std::size_t i = 0; i < poses.size(); ++i) {
      const spool::Part& part = design->parts[i];
      const PartSpec& spec = assembly.members[i].spec;
      EXPECT_EQ(part.name, spec.name);
      EXPECT_EQ(part.nps, spec.nps);
      EXPECT_EQ(part.nps2, spec.nps2);
      EXPECT_EQ(part.order, static_cast<int>(i));
      EXPECT_TRUE(part.T_design_part.isApprox(poses[i], 1e-9)) << part.name;
      if (assembly.members[i].parent >= 0) ++joined;
    }
    // Ports that are joined meet, face to face.
    ASSERT_EQ(design->joints.size(), joined);
    for (const Joint& joint : design->joints) {
      const auto at = [&](int part, int port) {
        const spool::Part& p = design->parts[static_cast<std::size_t>(part)];
        const Port& q = p.ports[static_cast<std::size_t>(port)];
        return std::pair<Vector3d, Vector3d>(p.T_design_part * q.position,
                                             p.T_design_part.linear() * q.direction);
      };
      const auto [a, direction_a] = at(joint.part_a, joint.port_a);
      const auto [b, direction_b] = at(joint.part_b, joint.port_b);
      EXPECT_LT((a - b).norm(), kFloat) << joint.weld;
      EXPECT_LT((direction_a + direction_b).norm(), 1e-9) << joint.weld;
    }
  }
}

// The numbers below are typed from ASME B16.5 class 150, B16.9 and B36.10M, not
// taken from the generator's table.
TEST(DesignGlb, HasPartsOfStandardSizes) {
  const Assembly assembly = design_of(ObjectKind::kPipeSpool3m, 3, true);
  const auto design = read_back(assembly);
  ASSERT_TRUE(design) << design.error().message;

  const spool::Part& flange = part_named(*design, "flange_1");
  EXPECT_EQ(flange.kind, spool::PartKind::kFlange);
  EXPECT_EQ(flange.rating, "150");
  ASSERT_TRUE(flange.holes);
  EXPECT_EQ(flange.holes->count, 8);
  EXPECT_NEAR(flange.holes->bolt_circle_m, 0.1905, kFloat);
  EXPECT_NEAR(flange.holes->clocking_rad, std::numbers::pi / 8, kFloat);
  const Eigen::AlignedBox3d rim = extent(*design, flange);
  EXPECT_NEAR(rim.sizes().x(), 0.2286, kFloat);
  EXPECT_NEAR(rim.sizes().z(), 0.0762, kFloat);
  ASSERT_EQ(flange.ports.size(), 2U);
  EXPECT_EQ(flange.ports[0].end, EndType::kFlanged);
  EXPECT_EQ(flange.ports[1].end, EndType::kButtWeld);
  EXPECT_NEAR((flange.ports[0].position - flange.ports[1].position).norm(), 0.0762, kFloat);

  const spool::Part& pipe = part_named(*design, "pipe_1");
  EXPECT_EQ(pipe.kind, spool::PartKind::kPipe);
  EXPECT_NEAR(extent(*design, pipe).sizes().x(), 0.1143, kFloat);

  const spool::Part& elbow = part_named(*design, "elbow_1");
  ASSERT_EQ(elbow.ports.size(), 2U);
  // A right-angled bend's ends are its radius apart along both legs.
  EXPECT_NEAR((elbow.ports[0].position - elbow.ports[1].position).norm(), 0.152 * std::sqrt(2.0),
              kFloat);
  const spool::Part& half = part_named(*design, "elbow_4");
  EXPECT_EQ(half.nps, 2);
  EXPECT_NEAR(half.ports[0].direction.dot(half.ports[1].direction), -std::sqrt(0.5), 1e-9);
  EXPECT_NEAR((half.ports[0].position - half.ports[1].position).norm(),
              2 * 0.035 * std::cos(std::numbers::pi / 8), kFloat);

  const spool::Part& tee = part_named(*design, "tee_1");
  EXPECT_EQ(tee.nps2, 3);
  ASSERT_EQ(tee.ports.size(), 3U);
  EXPECT_NEAR((tee.ports[0].position - tee.ports[1].position).norm(), 2 * 0.105, kFloat);
  const Vector3d centre = (tee.ports[0].position + tee.ports[1].position) / 2;
  EXPECT_NEAR((tee.ports[2].position - centre).norm(), 0.098, kFloat);

  const spool::Part& reducer = part_named(*design, "reducer_1");
  EXPECT_EQ(reducer.nps2, 2);
  EXPECT_NEAR((reducer.ports[0].position - reducer.ports[1].position).norm(), 0.102, kFloat);
}

TEST(DesignGlb, HasBoltHolesWhereItSaysSo) {
  // A small flange's plate has no corner inside a hole, and some on each hole's rim.
  const Assembly assembly = design_of(ObjectKind::kSmallSpool, 3, true);
  const auto design = read_back(assembly);
  ASSERT_TRUE(design) << design.error().message;
  const spool::Part& flange = part_named(*design, "flange_1");
  ASSERT_TRUE(flange.holes);
  EXPECT_EQ(flange.holes->count, 4);
  EXPECT_NEAR(flange.holes->bolt_circle_m, 0.1206, kFloat);
  int on_rims = 0;
  for (std::uint32_t t = flange.first_triangle; t < flange.first_triangle + flange.triangle_count;
       ++t)
    for (const std::uint32_t v : design->mesh.triangles[t]) {
      const Vector3d p = flange.T_design_part.inverse() * design->mesh.vertices[v].cast<double>();
      for (int hole = 0; hole < 4; ++hole) {
        const double angle = flange.holes->clocking_rad + std::numbers::pi / 2 * hole;
        const double r = flange.holes->bolt_circle_m / 2;
        const double distance =
            std::hypot(p.x() - r * std::cos(angle), p.y() - r * std::sin(angle));
        EXPECT_GT(distance, 0.0095 - kFloat);
        on_rims += distance < 0.0095 + kFloat ? 1 : 0;
      }
    }
  EXPECT_GT(on_rims, 4 * 2 * 24);
}

}  // namespace
}  // namespace spool::campaign
