// A design written as glTF and read again is the same design.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/design/gltf_writer.h"

#include <string>

#include <gtest/gtest.h>

#include "tests/support/refusal.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/write_file.h"
#include "tests/vision/piping/pcf_samples.h"
#include "vision/design/design_reader.h"

namespace spool {
namespace {

using test::replaced;
using test::spool_pcf;

class GltfWriter : public testing::Test {
 protected:
  DesignModel read(const std::string& name, const std::string& bytes) {
    const auto design = read_design(test::write_file(folder_.path() / name, bytes));
    EXPECT_TRUE(design.has_value()) << (design ? "" : design.error().message);
    return design ? *design : DesignModel{};
  }
  DesignModel round_trip(const DesignModel& design) {
    const auto bytes = write_gltf(design);
    EXPECT_TRUE(bytes.has_value()) << (bytes ? "" : bytes.error().message);
    return bytes ? read("again.glb", *bytes) : DesignModel{};
  }
  test::TemporaryFolder folder_;
};

void expect_same_part(const Part& a, const Part& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.kind, b.kind) << a.name;
  EXPECT_EQ(a.nps, b.nps) << a.name;
  EXPECT_EQ(a.nps2, b.nps2) << a.name;
  EXPECT_EQ(a.schedule, b.schedule) << a.name;
  EXPECT_EQ(a.rating, b.rating) << a.name;
  EXPECT_EQ(a.spool, b.spool) << a.name;
  EXPECT_EQ(a.piece, b.piece) << a.name;
  EXPECT_EQ(a.heat, b.heat) << a.name;
  EXPECT_EQ(a.order, b.order) << a.name;
  EXPECT_EQ(a.triangle_count, b.triangle_count) << a.name;
  EXPECT_TRUE(a.T_design_part.isApprox(b.T_design_part, 1e-9)) << a.name;
  ASSERT_EQ(a.ports.size(), b.ports.size()) << a.name;
  for (std::size_t p = 0; p < a.ports.size(); ++p) {
    EXPECT_EQ(a.ports[p].name, b.ports[p].name) << a.name;
    EXPECT_EQ(a.ports[p].nps, b.ports[p].nps) << a.name;
    EXPECT_EQ(a.ports[p].end, b.ports[p].end) << a.name;
    EXPECT_NEAR((a.ports[p].position - b.ports[p].position).norm(), 0, 1e-9) << a.name;
    EXPECT_NEAR((a.ports[p].direction - b.ports[p].direction).norm(), 0, 1e-9) << a.name;
  }
  ASSERT_EQ(a.holes.has_value(), b.holes.has_value()) << a.name;
  if (a.holes) {
    EXPECT_EQ(a.holes->count, b.holes->count) << a.name;
    EXPECT_NEAR(a.holes->bolt_circle_m, b.holes->bolt_circle_m, 1e-9) << a.name;
    EXPECT_NEAR(a.holes->clocking_rad, b.holes->clocking_rad, 1e-9) << a.name;
  }
  ASSERT_EQ(a.section.has_value(), b.section.has_value()) << a.name;
  if (a.section) {
    EXPECT_EQ(a.section->shape, b.section->shape) << a.name;
    EXPECT_NEAR(a.section->height_m, b.section->height_m, 1e-9) << a.name;
  }
  ASSERT_EQ(a.marks.size(), b.marks.size()) << a.name;
  for (std::size_t m = 0; m < a.marks.size(); ++m) {
    EXPECT_EQ(a.marks[m].type, b.marks[m].type) << a.name;
    EXPECT_NEAR((a.marks[m].position - b.marks[m].position).norm(), 0, 1e-9) << a.name;
    EXPECT_NEAR((a.marks[m].direction - b.marks[m].direction).norm(), 0, 1e-9) << a.name;
    EXPECT_NEAR(a.marks[m].size_m, b.marks[m].size_m, 1e-9) << a.name;
  }
}

void expect_same(const DesignModel& a, const DesignModel& b) {
  ASSERT_EQ(a.parts.size(), b.parts.size());
  EXPECT_EQ(a.line, b.line);
  EXPECT_EQ(a.spool, b.spool);
  EXPECT_EQ(a.revision, b.revision);
  EXPECT_EQ(a.root_gap_m, b.root_gap_m);
  EXPECT_EQ(a.datums, b.datums);
  EXPECT_EQ(a.origin, b.origin);
  EXPECT_TRUE(b.warnings.empty()) << b.warnings.front();
  for (std::size_t p = 0; p < a.parts.size(); ++p) expect_same_part(a.parts[p], b.parts[p]);
  ASSERT_EQ(a.joints.size(), b.joints.size());
  for (std::size_t j = 0; j < a.joints.size(); ++j) {
    EXPECT_EQ(a.joints[j].weld, b.joints[j].weld);
    EXPECT_EQ(a.joints[j].type, b.joints[j].type);
    EXPECT_EQ(a.joints[j].part_a, b.joints[j].part_a);
    EXPECT_EQ(a.joints[j].port_b, b.joints[j].port_b);
  }
  ASSERT_EQ(a.mesh.triangles.size(), b.mesh.triangles.size());
  for (std::size_t t = 0; t < a.mesh.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& from = a.mesh.vertices[a.mesh.triangles[t][k]];
      const auto& to = b.mesh.vertices[b.mesh.triangles[t][k]];
      // Float rounding in the part's frame and again in the design's, at up to four metres.
      ASSERT_LT((from - to).norm(), 2e-6F) << "triangle " << t;
    }
  }
}

TEST_F(GltfWriter, GivesBackThePipingFile) {
  const DesignModel design = read("spool.pcf", spool_pcf());
  expect_same(design, round_trip(design));
}

TEST_F(GltfWriter, KeepsTheOriginOfAPlant) {
  const std::string far = test::pcf(
      "PIPE\n  END-POINT 482150130.6 5650130250.7 12345.6 4\n  END-POINT 482150130.6 "
      "5650131250.8 12345.6 4\n  SCHEDULE STD\n");
  const DesignModel design = read("far.pcf", far);
  EXPECT_GT(design.origin.norm(), 1e6);
  expect_same(design, round_trip(design));
}

TEST_F(GltfWriter, WritesAllThatAPartCanHave) {
  DesignModel design = read("spool.pcf", spool_pcf());
  design.spool = "SP1 \"left\"";
  design.root_gap_m = 0.0032;
  Part& part = design.parts[0];
  part.order = 7;
  part.piece = "P-12";
  part.section = Section{"HEA", 0.1, 0.096};
  design.joints[0].type = JointType::kYaw;
  expect_same(design, round_trip(design));
}

TEST_F(GltfWriter, RefusesACloud) {
  const DesignModel cloud =
      read("cloud.xyz", "0 0 0\n0.1 0 0\n0 0.1 0\n0 0 0.1\n0.1 0.1 0\n0.1 0.1 0.1\n");
  test::expect_refused(write_gltf(cloud), ErrorCode::kBadInput, "cloud.xyz", "cloud of points");
}

}  // namespace
}  // namespace spool
