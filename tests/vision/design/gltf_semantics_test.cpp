// extras.spoolsight read as ARCHITECTURE, Files has it; what is wrong there warns, by node and key.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <numbers>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"
#include "tests/support/write_file.h"
#include "tests/vision/design/gltf_text.h"
#include "vision/design/design_reader.h"

namespace spool::test {
namespace {

class GltfSemantics : public testing::Test {
 protected:
  DesignModel read(const std::string& node_extras, const std::string& scene_extras = "{}",
                   const std::string& transform = "") {
    Pieces pieces;
    pieces.nodes = R"([{"mesh": 0, "name": "a", "extras": )" + node_extras + transform +
                   R"(}, {"mesh": 0, "name": "b", "extras": {"spoolsight": {"ports": [
        {"name": "in", "position": [0, 0, 0], "direction": [0, 0, -1]}]}}}])";
    pieces.scenes = R"([{"nodes": [0, 1], "extras": )" + scene_extras + "}]";
    Result<DesignModel> design =
        read_design(write_file(folder_.path() / "design.glb", pieces.glb()));
    EXPECT_TRUE(design.has_value()) << (design ? "" : design.error().message);
    return design ? std::move(*design) : DesignModel{};
  }
  static bool warns(const DesignModel& design, const std::string& text) {
    return std::any_of(
        design.warnings.begin(), design.warnings.end(),
        [&](const std::string& each) { return each.find(text) != std::string::npos; });
  }
  TemporaryFolder folder_;
};

TEST_F(GltfSemantics, ReadsEveryField) {
  const DesignModel design = read(
      R"({"spoolsight": {"kind": "flange", "nps": 4, "nps2": 3.5, "schedule": 40, "rating": "150",
          "order": 7, "spool": "main", "piece": "P1", "heat": "H22",
          "ports": [{"name": "face", "position": [0, 0, -0.1], "direction": [0, 0, -2], "nps": 4, "end": "FL"},
                    {"name": "weld", "position": [0, 0, 0.1], "direction": [0, 0, 1], "end": "BW"}],
          "holes": {"count": 8, "bolt_circle_m": 0.1905, "clocking_rad": 0.39},
          "marks": [{"type": "vent", "position": [0.1, 0, 0], "direction": [1, 0, 0], "size_m": 0.02}],
          "section": {"shape": "box", "width_m": 0.1, "height_m": 0.2}}})",
      R"({"spoolsight": {"line": "L1", "spool": "S1", "revision": 2, "root_gap_m": 0.003,
          "joints": [{"weld": "W1", "a": "a/weld", "b": "b/in", "type": "field"}], "datums": ["b", "a"]}})");
  EXPECT_TRUE(design.warnings.empty()) << design.warnings[0];
  const Part& part = design.parts.at(0);
  EXPECT_EQ(part.kind, PartKind::kFlange);
  EXPECT_EQ(part.nps, 4);
  EXPECT_EQ(part.nps2, 3.5);
  EXPECT_EQ(part.schedule, "40");
  EXPECT_EQ(part.rating, "150");
  EXPECT_EQ(part.order, 7);
  EXPECT_EQ(part.spool, "main");
  EXPECT_EQ(part.piece, "P1");
  EXPECT_EQ(part.heat, "H22");
  ASSERT_EQ(part.ports.size(), 2U);
  EXPECT_EQ(part.ports[0].name, "face");
  EXPECT_EQ(part.ports[0].end, EndType::kFlanged);
  EXPECT_EQ(part.ports[0].nps, 4);
  EXPECT_TRUE(part.ports[0].position.isApprox(Eigen::Vector3d(0, 0, -0.1)));
  EXPECT_TRUE(part.ports[0].direction.isApprox(Eigen::Vector3d(0, 0, -1)));  // made unit
  ASSERT_TRUE(part.holes);
  EXPECT_EQ(part.holes->count, 8);
  EXPECT_NEAR(part.holes->bolt_circle_m, 0.1905, 1e-12);
  EXPECT_NEAR(part.holes->clocking_rad, 0.39, 1e-12);
  ASSERT_EQ(part.marks.size(), 1U);
  EXPECT_EQ(part.marks[0].type, "vent");
  EXPECT_NEAR(part.marks[0].size_m, 0.02, 1e-12);
  ASSERT_TRUE(part.section);
  EXPECT_EQ(part.section->shape, "box");
  EXPECT_EQ(part.section->height_m, 0.2);
  EXPECT_EQ(design.line, "L1");
  EXPECT_EQ(design.spool, "S1");
  EXPECT_EQ(design.revision, "2");
  EXPECT_EQ(design.root_gap_m, 0.003);
  ASSERT_EQ(design.joints.size(), 1U);
  EXPECT_EQ(design.joints[0].weld, "W1");
  EXPECT_EQ(design.joints[0].type, JointType::kField);
  EXPECT_EQ(design.joints[0].part_a, 0);
  EXPECT_EQ(design.joints[0].port_a, 1);
  EXPECT_EQ(design.joints[0].part_b, 1);
  EXPECT_EQ(design.joints[0].port_b, 0);
  EXPECT_EQ(design.datums, (std::vector<int>{1, 0}));
}

TEST_F(GltfSemantics, KnowsEveryKindEndAndJointByItsName) {
  for (const char* kind : {"pipe", "elbow", "tee", "cross", "reducer", "flange", "blind", "cap",
                           "olet", "valve", "gasket", "support", "structure", "other"}) {
    const DesignModel design = read(std::string(R"({"spoolsight": {"kind": ")") + kind + "\"}}");
    EXPECT_TRUE(design.warnings.empty());
    EXPECT_EQ(name(design.parts.at(0).kind), kind);
  }
  for (const char* end : {"BW", "FL", "SW", "SC", "PL"}) {
    EXPECT_EQ(name(parse_end_type(end).value()), end);
  }
  for (const char* type : {"fab", "field", "yaw"}) {
    EXPECT_EQ(name(parse_joint_type(type).value()), type);
  }
  EXPECT_FALSE(parse_part_kind("Pipe"));
  EXPECT_FALSE(parse_end_type(""));
}

TEST_F(GltfSemantics, WarnsByNodeAndKeyOfWrongTypes) {
  const struct {
    const char* extras;
    const char* warning;
  } kRows[] = {
      {R"({"spoolsight": 5})", "node 'a' extras.spoolsight is not an object"},
      {R"({"spoolsight": {"kind": 3}})", "'kind' that is not text"},
      {R"({"spoolsight": {"kind": "sprocket"}})", "unknown kind 'sprocket'"},
      {R"({"spoolsight": {"nps": "four"}})",
       "node 'a' extras.spoolsight has 'nps' that is not a number"},
      {R"({"spoolsight": {"nps": -4}})", "'nps' below zero"},
      {R"({"spoolsight": {"order": 1.5}})", "'order' that is not a whole number"},
      {R"({"spoolsight": {"schedule": [4]}})", "'schedule' that is not text"},
      {R"({"spoolsight": {"ports": {"in": 1}}})", "'ports' that is not a list"},
      {R"({"spoolsight": {"ports": [7]}})", "node 'a' extras.spoolsight ports[0] is not an object"},
      {R"({"spoolsight": {"ports": [{"name": "in", "position": [0, 0], "direction": [0, 0, 1]}]}})",
       "ports[0] has 'position' that is not three numbers"},
      {R"({"spoolsight": {"ports": [{"name": "in", "position": [0, 0, 0], "direction": [0, 0, 0]}]}})",
       "a direction without length"},
      {R"({"spoolsight": {"ports": [{"name": "in", "position": [0, 0, 0], "direction": [0, 0, 1], "end": "XX"}]}})",
       "an end 'XX'"},
      {R"({"spoolsight": {"holes": [8]}})", "'holes' that is not an object"},
      {R"({"spoolsight": {"holes": {"count": 0, "bolt_circle_m": 0.1}}})",
       "a count and a bolt_circle_m"},
      {R"({"spoolsight": {"marks": [{"type": "tap"}]}})",
       "marks[0] lacks a type, a position or a direction"},
      {R"({"spoolsight": {"section": {"width_m": 1}}})", "section lacks a shape"},
  };
  for (const auto& row : kRows) {
    const DesignModel design = read(row.extras);
    EXPECT_TRUE(warns(design, row.warning))
        << row.warning << " / " << (design.warnings.empty() ? "none" : design.warnings[0]);
    EXPECT_EQ(design.parts.size(), 2U);
  }
}

TEST_F(GltfSemantics, IsSilentWhereThereIsNothingToRead) {
  for (const char* extras : {"{}", "null", "[1, 2]", "7", "\"text\"", R"({"other": {"kind": 3}})",
                             R"({"spoolsight": {"kind": null, "unknown_key": {}}})"}) {
    EXPECT_TRUE(read(extras).warnings.empty()) << extras;
  }
}

TEST_F(GltfSemantics, WarnsOfJointsAndDatumsThatNameNothing) {
  const std::string ports =
      R"({"spoolsight": {"ports": [{"name": "out", "position": [0, 0, 0], "direction": [0, 0, 1]}]}})";
  for (const char* joint :
       {R"({"weld": "W", "a": "a/out", "b": "c/in"})",
        R"({"weld": "W", "a": "a/nothing", "b": "b/in"})",
        R"({"weld": "W", "a": "a", "b": "b/in"})", R"({"weld": "W", "b": "b/in"})", "5"}) {
    const DesignModel design =
        read(ports, std::string(R"({"spoolsight": {"joints": [)") + joint + "]}}");
    EXPECT_TRUE(design.joints.empty()) << joint;
    EXPECT_TRUE(warns(design, "the joint is left out")) << joint;
  }
  const DesignModel design = read(ports, R"({"spoolsight": {"datums": ["a", "zebra", 4]}})");
  EXPECT_EQ(design.datums, (std::vector<int>{0}));
  EXPECT_TRUE(warns(design, "'zebra'"));
}

TEST_F(GltfSemantics, BringsPortsAndSizesToMetresThroughTheNodesScale) {
  // A node in millimetres, as an exporter of millimetres makes it, turned about x.
  const DesignModel design = read(
      R"({"spoolsight": {"ports": [{"name": "out", "position": [0, 0, 500], "direction": [0, 0, 1]}],
          "holes": {"count": 4, "bolt_circle_m": 120.7, "clocking_rad": 0.5}}})",
      "{}",
      R"(, "scale": [0.001, 0.001, 0.001], "rotation": [0.70710678118654752, 0, 0, 0.70710678118654752])");
  const Part& part = design.parts.at(0);
  EXPECT_TRUE(part.ports.at(0).position.isApprox(Eigen::Vector3d(0, 0, 0.5), 1e-9));
  EXPECT_TRUE(part.ports[0].direction.isApprox(Eigen::Vector3d(0, 0, 1), 1e-9));
  EXPECT_NEAR(part.holes->bolt_circle_m, 0.1207, 1e-9);
  const Eigen::Vector3d placed = part.T_design_part * part.ports[0].position;
  EXPECT_TRUE(placed.isApprox(Eigen::Vector3d(0, -0.5, 0), 1e-9));
}

TEST_F(GltfSemantics, TurnsClockingOverWithAMirroredNode) {
  const double clocking = 0.3;
  const DesignModel design =
      read(R"({"spoolsight": {"holes": {"count": 4, "bolt_circle_m": 0.1, "clocking_rad": 0.3}}})",
           "{}", R"(, "scale": [1, -1, 1])");
  const Part& part = design.parts.at(0);
  // The first hole as the node has it, and as the part says it, at the same place of the design.
  const Eigen::Vector3d truth(0.05 * std::cos(clocking), -0.05 * std::sin(clocking), 0);
  const Eigen::Vector3d said =
      part.T_design_part * Eigen::Vector3d(0.05 * std::cos(part.holes->clocking_rad),
                                           0.05 * std::sin(part.holes->clocking_rad), 0);
  EXPECT_TRUE(said.isApprox(truth, 1e-9)) << said.transpose();
}

}  // namespace
}  // namespace spool::test
