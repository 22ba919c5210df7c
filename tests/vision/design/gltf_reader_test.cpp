// What glTF can say about a mesh, read right.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "tests/vision/design/gltf_reader_fixture.h"

namespace spool::test {
namespace {

// Volume enclosed by a design's triangles (m^3), + where they look outwards: the divergence
// theorem.
double volume(const DesignModel& design) {
  double six = 0;
  for (const Triangle& t : design.mesh.triangles) {
    const auto at = [&](std::size_t k) { return design.mesh.vertices[t[k]].cast<double>(); };
    six += at(0).eval().dot(at(1).eval().cross(at(2).eval()));
  }
  return six / 6;
}

TEST_F(GltfReader, ReadsATetrahedronInMetres) {
  const DesignModel design = good(Pieces().glb());
  ASSERT_EQ(design.parts.size(), 1U);
  EXPECT_EQ(design.parts[0].name, "corner");
  EXPECT_EQ(design.mesh.triangles.size(), 4U);
  EXPECT_EQ(design.mesh.vertices.size(), 4U);
  EXPECT_NEAR(volume(design), 1.0 / 6, 1e-6);
  EXPECT_EQ(design.unit, LengthUnit::kMetre);
  EXPECT_FALSE(design.unit_inferred);
  EXPECT_TRUE(design.warnings.empty());
  EXPECT_EQ(design.sha256.size(), 64U);
  EXPECT_EQ(design.origin, Eigen::Vector3d::Zero());
}

TEST_F(GltfReader, TakesAUnitThatIsGivenOverMetres) {
  Pieces pieces;
  pieces.nodes = R"([{"mesh": 0, "name": "a", "translation": [10, 0, 0], "extras": {"spoolsight": {
      "ports": [{"name": "in", "position": [0, 0, 1], "direction": [0, 0, 1]}]}}}])";
  const DesignModel design = good(pieces.glb(), "design.glb", LengthUnit::kInch);
  EXPECT_NEAR(volume(design), std::pow(0.0254, 3) / 6, 1e-9);
  EXPECT_NEAR(design.parts[0].T_design_part.translation().x(), 0.254, 1e-12);
  EXPECT_NEAR(design.parts[0].ports[0].position.z(), 0.0254, 1e-12);
}

TEST_F(GltfReader, ComposesTransformsDownTheTree) {
  Pieces pieces;
  // A quarter turn about z, then a step along the turned x, then twice the size.
  pieces.nodes =
      R"([{"children": [1], "rotation": [0, 0, 0.70710678118654752, 0.70710678118654752]},
      {"children": [2], "translation": [3, 0, 0]},
      {"mesh": 0, "name": "corner", "scale": [2, 2, 2]}])";
  const DesignModel design = good(pieces.glb());
  EXPECT_NEAR(volume(design), 8.0 / 6, 1e-5);
  const Pose& T = design.parts[0].T_design_part;
  EXPECT_TRUE(T.translation().isApprox(Eigen::Vector3d(0, 3, 0), 1e-9));
  EXPECT_TRUE((T.linear() * Eigen::Vector3d::UnitX()).isApprox(Eigen::Vector3d::UnitY(), 1e-9));
  EXPECT_TRUE(design.bounds().min().isApprox(Eigen::Vector3d(-2, 3, 0), 1e-6));
  EXPECT_TRUE(design.bounds().max().isApprox(Eigen::Vector3d(0, 5, 2), 1e-6));
}

TEST_F(GltfReader, ReadsAMatrixColumnByColumn) {
  Pieces pieces;
  pieces.nodes = R"([{"mesh": 0, "matrix": [0,1,0,0, -1,0,0,0, 0,0,1,0, 5,6,7,1]}])";
  const DesignModel design = good(pieces.glb());
  EXPECT_EQ(design.parts[0].name, "part_1");
  EXPECT_TRUE(design.parts[0].T_design_part.translation().isApprox(Eigen::Vector3d(5, 6, 7)));
  EXPECT_TRUE(design.bounds().min().isApprox(Eigen::Vector3d(4, 6, 7), 1e-6));
}

TEST_F(GltfReader, TurnsMirroredTrianglesOutwardsAndKeepsPosesRigid) {
  for (const char* scale : {"[-1, 1, 1]", "[1, 1, -2]", "[-1, -2, -3]"}) {
    Pieces pieces;
    pieces.nodes = std::string(R"([{"mesh": 0, "name": "m", "scale": )") + scale +
                   R"(, "extras": {"spoolsight": {"kind": "flange", "ports": [
        {"name": "out", "position": [0, 0, 1], "direction": [0, 0, 1]}]}}}])";
    const DesignModel design = good(pieces.glb());
    EXPECT_GT(volume(design), 0) << scale;
    const Eigen::Matrix3d R = design.parts[0].T_design_part.linear();
    EXPECT_NEAR(R.determinant(), 1, 1e-9);
    EXPECT_TRUE((R * R.transpose()).isApprox(Eigen::Matrix3d::Identity(), 1e-9));
    // The port stays at the tip that the mesh has there.
    const Eigen::Vector3d port = design.parts[0].T_design_part * design.parts[0].ports[0].position;
    const Eigen::Vector3d towards = R * design.parts[0].ports[0].direction;
    const bool down = std::string(scale).find("1, -2]") != std::string::npos ||
                      std::string(scale).find("-3") != std::string::npos;
    EXPECT_EQ(port.z() < 0, down) << scale;
    EXPECT_NEAR(towards.z(), down ? -1 : 1, 1e-9);
    EXPECT_NEAR(std::abs(port.z()), design.bounds().sizes().z(), 1e-6);
  }
}

TEST_F(GltfReader, PlacesInstancesOfOneMesh) {
  Pieces pieces;
  pieces.nodes = R"([{"mesh": 0, "name": "a"}, {"mesh": 0, "name": "a", "translation": [4, 0, 0]},
                     {"mesh": 0, "translation": [8, 0, 0]}])";
  pieces.scenes = R"([{"nodes": [0, 1, 2]}])";
  const DesignModel design = good(pieces.glb());
  ASSERT_EQ(design.parts.size(), 3U);
  EXPECT_EQ(design.parts[0].name, "a");
  EXPECT_EQ(design.parts[1].name, "a_2");
  EXPECT_EQ(design.parts[2].name, "part_3");
  ASSERT_EQ(design.warnings.size(), 1U);
  EXPECT_NE(design.warnings[0].find("'a_2'"), std::string::npos);
  EXPECT_EQ(design.parts[2].first_triangle, 8U);
  EXPECT_EQ(design.parts[2].triangle_count, 4U);
  EXPECT_EQ(design.triangle_part, (std::vector<std::int32_t>{0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2}));
  EXPECT_NEAR(design.bounds().max().x(), 9, 1e-6);
}

TEST_F(GltfReader, ReadsStripsFansAndMeshesWithoutIndices) {
  // A unit square as strip, fan and list; all three face +z.
  const struct {
    const char* name;
    int mode;
    std::vector<float> points;
  } kRows[] = {
      {"strip", 5, {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}},
      {"fan", 6, {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}},
      {"list", 4, {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 1, 0, 0, 1, 0}},
  };
  for (const auto& row : kRows) {
    Pieces pieces;
    pieces.bin = floats(row.points);
    const std::string bytes = std::to_string(pieces.bin.size());
    pieces.buffers = R"([{"byteLength": )" + bytes + "}]";
    pieces.views = R"([{"buffer": 0, "byteLength": )" + bytes + "}]";
    pieces.accessors = R"([{"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": )" +
                       std::to_string(row.points.size() / 3) + "}]";
    pieces.meshes = R"([{"primitives": [{"attributes": {"POSITION": 0}, "mode": )" +
                    std::to_string(row.mode) + "}]}]";
    const DesignModel design = good(pieces.glb());
    ASSERT_EQ(design.mesh.triangles.size(), 2U) << row.name;
    for (const Triangle& t : design.mesh.triangles) {
      const auto& v = design.mesh.vertices;
      const Eigen::Vector3f normal = (v[t[1]] - v[t[0]]).cross(v[t[2]] - v[t[0]]);
      EXPECT_NEAR(normal.z(), 1, 1e-6) << row.name;
    }
  }
}

TEST_F(GltfReader, ReadsSparseAccessorsWithAndWithoutABase) {
  for (const bool has_base : {true, false}) {
    Pieces pieces;
    // Sparse: vertex 3 becomes (0, 0, 5); without a base the others are zero, so nothing has an
    // area but what is listed: then all of 1, 2, 3 are.
    const std::string places = has_base ? shorts({3, 0}) : shorts({1, 2, 3, 0});
    const std::string values = has_base ? floats({0, 0, 5}) : floats({1, 0, 0, 0, 1, 0, 0, 0, 5});
    const std::size_t at = pieces.bin.size();
    pieces.bin += places + values;
    pieces.buffers = R"([{"byteLength": )" + std::to_string(pieces.bin.size()) + "}]";
    pieces.views.pop_back();
    pieces.views += R"(, {"buffer": 0, "byteOffset": )" + std::to_string(at) +
                    R"(, "byteLength": )" + std::to_string(places.size()) +
                    R"(}, {"buffer": 0, "byteOffset": )" + std::to_string(at + places.size()) +
                    R"(, "byteLength": )" + std::to_string(values.size()) + "}]";
    pieces.accessors =
        std::string("[{") + (has_base ? R"("bufferView": 0, )" : "") +
        R"("componentType": 5126, "count": 4, "type": "VEC3", "sparse": {"count": )" +
        (has_base ? "1" : "3") +
        R"(, "indices": {"bufferView": 2, "componentType": 5123}, "values": {"bufferView": 3}}},)"
        R"( {"bufferView": 1, "componentType": 5123, "count": 12, "type": "SCALAR"}])";
    EXPECT_NEAR(volume(good(pieces.glb())), 5.0 / 6, 1e-5) << has_base;
  }
}

TEST_F(GltfReader, ReadsInterleavedAndQuantizedPositions) {
  Pieces pieces;
  // x y z as signed shorts normalised to one, every 8 bytes.
  const std::uint16_t one = 32767;
  const std::string points = shorts({0, 0, 0, 9, one, 0, 0, 9, 0, one, 0, 9, 0, 0, one, 9});
  pieces.bin = points + pieces.bin.substr(48);
  pieces.buffers = R"([{"byteLength": )" + std::to_string(pieces.bin.size()) + "}]";
  pieces.views = R"([{"buffer": 0, "byteLength": 32, "byteStride": 8},
                     {"buffer": 0, "byteOffset": 32, "byteLength": 24}])";
  pieces.accessors =
      R"([{"bufferView": 0, "componentType": 5122, "normalized": true, "count": 4, "type": "VEC3"},
          {"bufferView": 1, "componentType": 5123, "count": 12, "type": "SCALAR"}])";
  pieces.extra = R"(, "extensionsRequired": ["KHR_mesh_quantization"])";
  EXPECT_NEAR(volume(good(pieces.glb())), 1.0 / 6, 1e-6);
}

TEST_F(GltfReader, RebasesADesignFarFromItsOrigin) {
  Pieces pieces;
  pieces.nodes = R"([{"mesh": 0, "name": "far", "translation": [431207.3, 5812044.7, 12.1]}])";
  const DesignModel design = good(pieces.glb());
  EXPECT_NEAR(volume(design), 1.0 / 6, 1e-6);  // lost entirely in float without an origin
  EXPECT_LT(design.bounds().max().norm(), 3);
  const Eigen::Vector3d corner = design.origin + design.parts[0].T_design_part.translation();
  EXPECT_NEAR(corner.x(), 431207.3, 1e-6);
  EXPECT_NEAR(corner.y(), 5812044.7, 1e-6);
}

TEST_F(GltfReader, WarnsOfADesignThatIsNoSizeForMetres) {
  Pieces pieces;
  pieces.nodes = R"([{"mesh": 0, "scale": [500, 500, 500]}])";
  const DesignModel design = good(pieces.glb());
  ASSERT_EQ(design.warnings.size(), 1U);
  EXPECT_NE(design.warnings[0].find("--design-unit"), std::string::npos);
  EXPECT_NEAR(design.bounds().sizes().x(), 500, 1e-3);  // told, not rescaled
}

TEST_F(GltfReader, SkipsPointsAndLinesWithAWarning) {
  Pieces pieces;
  pieces.meshes = R"([{"primitives": [{"attributes": {"POSITION": 0}, "mode": 0},
      {"attributes": {"POSITION": 0}, "indices": 1}, {"attributes": {"POSITION": 0}, "mode": 1}]}])";
  const DesignModel design = good(pieces.glb());
  EXPECT_EQ(design.mesh.triangles.size(), 4U);
  ASSERT_EQ(design.warnings.size(), 1U);
  EXPECT_NE(design.warnings[0].find("2 primitives"), std::string::npos);
}

TEST_F(GltfReader, ReadsAllRootsWhereThereIsNoScene) {
  Pieces pieces;
  pieces.scenes = "[]";
  pieces.nodes =
      R"([{"mesh": 0, "name": "b", "translation": [2, 0, 0]}, {"children": [0]}, {"mesh": 0}])";
  EXPECT_EQ(good(pieces.glb()).parts.size(), 2U);
}

}  // namespace
}  // namespace spool::test
