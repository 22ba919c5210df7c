// What glTF can say about a mesh, read right; what it must not say, refused with a sentence.
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

#include "tests/support/temporary_folder.h"
#include "tests/vision/design/gltf_text.h"
#include "vision/design/design_reader.h"

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

class GltfReader : public testing::Test {
 protected:
  Result<DesignModel> read(const std::string& bytes, const std::string& name = "design.glb",
                           std::optional<LengthUnit> unit = std::nullopt) {
    return read_design(write(folder_.path(), name, bytes), unit);
  }
  DesignModel good(const std::string& bytes, const std::string& name = "design.glb",
                   std::optional<LengthUnit> unit = std::nullopt) {
    Result<DesignModel> design = read(bytes, name, unit);
    EXPECT_TRUE(design.has_value()) << (design ? "" : design.error().message);
    return design ? std::move(*design) : DesignModel{};
  }
  void refused(const std::string& bytes, const std::string& why,
               const std::string& name = "design.glb") {
    const Result<DesignModel> design = read(bytes, name);
    ASSERT_FALSE(design.has_value()) << why;
    EXPECT_EQ(design.error().code, ErrorCode::kBadInput);
    EXPECT_NE(design.error().message.find(name), std::string::npos) << design.error().message;
    EXPECT_NE(design.error().message.find(why), std::string::npos) << design.error().message;
    EXPECT_EQ(design.error().message.find('\n'), std::string::npos);
  }
  TemporaryFolder folder_;
};

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

TEST_F(GltfReader, ReadsABufferBesideTheFileAndNoOther) {
  Pieces pieces;
  const auto with_uri = [&](const std::string& uri) {
    Pieces own = pieces;
    own.buffers = R"([{"byteLength": 72, "uri": ")" + uri + R"("}])";
    return own.json();
  };
  std::filesystem::create_directories(folder_.path() / "sub");
  write(folder_.path(), "beside.bin", pieces.bin);
  write(folder_.path(), "with space.bin", pieces.bin);
  write(folder_.path() / "sub", "below.bin", pieces.bin);
  EXPECT_EQ(good(with_uri("beside.bin"), "design.gltf").mesh.triangles.size(), 4U);
  EXPECT_EQ(good(with_uri("with%20space.bin"), "design.gltf").mesh.triangles.size(), 4U);
  EXPECT_EQ(good(with_uri("sub/below.bin"), "design.gltf").mesh.triangles.size(), 4U);
  // A design in a folder below reaches for what lies above it.
  write(folder_.path() / "sub", "up.gltf", with_uri("../beside.bin"));
  const Result<DesignModel> up = read_design(folder_.path() / "sub" / "up.gltf");
  ASSERT_FALSE(up);
  EXPECT_NE(up.error().message.find("outside the design's folder"), std::string::npos);
  refused(with_uri((folder_.path() / "beside.bin").string()), "outside the design's folder",
          "design.gltf");
  refused(with_uri("%2e%2e/%2e%2e/etc/passwd"), "outside the design's folder", "design.gltf");
  refused(with_uri("http://example.com/buffer.bin"), "nothing is ever fetched", "design.gltf");
  refused(with_uri("file:///etc/passwd"), "nothing is ever fetched", "design.gltf");
  refused(with_uri("missing.bin"), "missing beside it", "design.gltf");
  refused(with_uri(""), "no file name", "design.gltf");
  std::filesystem::create_symlink("/etc/hostname", folder_.path() / "link.bin");
  refused(with_uri("link.bin"), "outside the design's folder", "design.gltf");
}

TEST_F(GltfReader, RefusesWhatCannotBe) {
  const struct {
    const char* name;
    const char* why;
    std::string Pieces::*piece;
    const char* text;
  } kRows[] = {
      {"view past buffer", "does not lie within its buffer", &Pieces::views,
       R"([{"buffer": 0, "byteLength": 49}, {"buffer": 0, "byteOffset": 48, "byteLength": 1000}])"},
      {"view of no buffer", "names a buffer that is not there", &Pieces::views,
       R"([{"buffer": 7, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 24}])"},
      {"count past view", "reaches past the end", &Pieces::accessors,
       R"([{"bufferView": 0, "componentType": 5126, "count": 5, "type": "VEC3"},
           {"bufferView": 1, "componentType": 5123, "count": 12, "type": "SCALAR"}])"},
      {"count of 1e8", "a count that cannot be", &Pieces::accessors,
       R"([{"bufferView": 0, "componentType": 5126, "count": 100000000, "type": "VEC3"},
           {"bufferView": 1, "componentType": 5123, "count": 12, "type": "SCALAR"}])"},
      {"offset past view", "reaches past the end", &Pieces::accessors,
       R"([{"bufferView": 0, "byteOffset": 4294967292, "componentType": 5126, "count": 4, "type": "VEC3"},
           {"bufferView": 1, "componentType": 5123, "count": 12, "type": "SCALAR"}])"},
      {"misaligned", "not aligned", &Pieces::accessors,
       R"([{"bufferView": 0, "byteOffset": 2, "componentType": 5126, "count": 3, "type": "VEC3"},
           {"bufferView": 1, "componentType": 5123, "count": 12, "type": "SCALAR"}])"},
      {"positions of two", "wrong type for its use", &Pieces::accessors,
       R"([{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC2"},
           {"bufferView": 1, "componentType": 5123, "count": 12, "type": "SCALAR"}])"},
      {"float indices", "wrong component type for indices", &Pieces::accessors,
       R"([{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
           {"bufferView": 1, "componentType": 5126, "count": 6, "type": "SCALAR"}])"},
      {"index past vertices", "an index past the last vertex", &Pieces::accessors,
       R"([{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
           {"bufferView": 1, "componentType": 5123, "count": 12, "type": "SCALAR"}])"},
      {"corners of no triangle", "makes no triangles", &Pieces::accessors,
       R"([{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
           {"bufferView": 1, "componentType": 5123, "count": 11, "type": "SCALAR"}])"},
      {"sparse of no view", "names a buffer view that is not there", &Pieces::accessors,
       R"([{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "sparse": {"count": 1,
            "indices": {"bufferView": 9, "componentType": 5123}, "values": {"bufferView": 9}}},
           {"bufferView": 1, "componentType": 5123, "count": 12, "type": "SCALAR"}])"},
      {"sparse beyond count", "sparse part that cannot be", &Pieces::accessors,
       R"([{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "sparse": {"count": 5,
            "indices": {"bufferView": 1, "componentType": 5123}, "values": {"bufferView": 0}}},
           {"bufferView": 1, "componentType": 5123, "count": 12, "type": "SCALAR"}])"},
      {"accessor not there", "accessor 44 is not there", &Pieces::meshes,
       R"([{"primitives": [{"attributes": {"POSITION": 44}, "indices": 1}]}])"},
      {"unknown mode", "unknown mode", &Pieces::meshes,
       R"([{"primitives": [{"attributes": {"POSITION": 0}, "mode": 9}]}])"},
      {"meshes are a word", "names a mesh that is not there", &Pieces::meshes, R"("oops")"},
      {"mesh not there", "names a mesh that is not there", &Pieces::nodes, R"([{"mesh": 7}])"},
      {"own child", "two parents or is its own", &Pieces::nodes,
       R"([{"children": [0], "mesh": 0}])"},
      {"cycle", "two parents or is its own", &Pieces::nodes,
       R"([{"children": [1]}, {"children": [0], "mesh": 0}])"},
      {"shared child", "two parents or is its own", &Pieces::nodes,
       R"([{"children": [1, 2]}, {"children": [3]}, {"children": [3]}, {"mesh": 0}])"},
      {"child not there", "node 5 is not there", &Pieces::nodes,
       R"([{"children": [5], "mesh": 0}])"},
      {"matrix of nine", "a transform that cannot be", &Pieces::nodes,
       R"([{"mesh": 0, "matrix": [1,0,0, 0,1,0, 0,0,1]}])"},
      {"projective matrix", "a transform that cannot be", &Pieces::nodes,
       R"([{"mesh": 0, "matrix": [1,0,0,1, 0,1,0,0, 0,0,1,0, 0,0,0,1]}])"},
      {"rotation of zeros", "a transform that cannot be", &Pieces::nodes,
       R"([{"mesh": 0, "rotation": [0, 0, 0, 0]}])"},
      {"so far out that it overflows", "not a finite place", &Pieces::nodes,
       R"([{"mesh": 0, "translation": [1e300, 0, 0]}])"},
      {"no mesh", "no mesh in its scene", &Pieces::nodes, R"([{"name": "empty"}])"},
      {"scaled away", "no mesh in its scene", &Pieces::nodes,
       R"([{"mesh": 0, "scale": [0, 0, 0]}])"},
      {"scene not there", "default scene is not there", &Pieces::extra, R"(, "scene": 9)"},
      {"draco", "KHR_draco_mesh_compression", &Pieces::extra,
       R"(, "extensionsRequired": ["KHR_draco_mesh_compression"])"},
      {"meshopt", "EXT_meshopt_compression", &Pieces::extra,
       R"(, "extensionsRequired": ["EXT_meshopt_compression"])"},
      {"number too large", "is not a glTF 2.0 file that can be read", &Pieces::extra,
       R"(, "extras": 1e999)"},
      {"no version", "is not a glTF 2.0 file that can be read", &Pieces::asset, "{}"},
  };
  for (const auto& row : kRows) {
    SCOPED_TRACE(row.name);
    Pieces pieces;
    pieces.*row.piece = row.text;
    refused(pieces.glb(), row.why);
  }
}

TEST_F(GltfReader, RefusesPositionsThatAreNoNumbers) {
  for (const float bad : {std::nanf(""), std::numeric_limits<float>::infinity()}) {
    Pieces pieces;
    pieces.bin.replace(4, 4, floats({bad}));
    refused(pieces.glb(), "not a number");
  }
}

TEST_F(GltfReader, RefusesDeepNestingBeforeItCanOverflowTheStack) {
  for (const char* bracket : {"[", "{\"a\":"}) {
    std::string deep;
    for (int i = 0; i < 300000; ++i) deep += bracket;
    Pieces pieces;
    pieces.extra = ", \"extras\": " + deep;
    refused(pieces.glb(), "levels deep");
    refused(pieces.json(), "levels deep", "design.gltf");
  }
  Pieces pieces;  // brackets in text nest nothing
  pieces.extra = ", \"extras\": \"" + std::string(300, '[') + "\\\"" + std::string(300, '{') + "\"";
  EXPECT_EQ(good(pieces.glb()).parts.size(), 1U);
}

TEST_F(GltfReader, ReadsAChainOfNodesOfAnyLength) {
  Pieces pieces;
  std::string nodes = "[";
  const int length = 50000;
  for (int i = 0; i < length; ++i) nodes += R"({"children": [)" + std::to_string(i + 1) + "]},";
  pieces.nodes = nodes + R"({"mesh": 0}])";
  EXPECT_EQ(good(pieces.glb()).parts.size(), 1U);
}

TEST_F(GltfReader, RefusesMoreTrianglesThanItReads) {
  Pieces pieces;  // a strip of 30 000 over four vertices, placed a thousand times
  std::vector<std::uint16_t> indices;
  for (int i = 0; i < 10000; ++i) indices.insert(indices.end(), {0, 1, 2});
  pieces.bin = pieces.bin.substr(0, 48) + shorts(indices);
  pieces.buffers = R"([{"byteLength": 60048}])";
  pieces.views =
      R"([{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 60000}])";
  pieces.accessors =
      R"([{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
          {"bufferView": 1, "componentType": 5123, "count": 30000, "type": "SCALAR"}])";
  std::string nodes = "[{\"children\": [1";
  for (int i = 2; i <= 2001; ++i) nodes += "," + std::to_string(i);
  nodes += "]}";
  for (int i = 1; i <= 2001; ++i) nodes += R"(,{"mesh": 0})";
  pieces.nodes = nodes + "]";
  refused(pieces.glb(), "export it coarser");
}

TEST_F(GltfReader, RefusesEveryTruncationOfAGoodFile) {
  const std::string whole = Pieces().glb();
  for (std::size_t length = 0; length < whole.size(); length += 7) {
    const Result<DesignModel> design = read(whole.substr(0, length));
    ASSERT_FALSE(design) << length;
    EXPECT_EQ(design.error().code, ErrorCode::kBadInput);
    EXPECT_FALSE(design.error().message.empty());
  }
}

TEST_F(GltfReader, SurvivesAnyByteChanged) {
  const std::string whole = Pieces().glb();
  constexpr std::array<char, 5> kBytes{'\0', '\xff', '9', '-', '{'};
  for (std::size_t at = 0; at < whole.size(); at += 2) {
    std::string changed = whole;
    changed[at] = kBytes[at / 2 % kBytes.size()];
    const Result<DesignModel> design = read(changed);  // good or refused; asan and ubsan look on
    if (!design) {
      EXPECT_EQ(design.error().code, ErrorCode::kBadInput);
    }
  }
}

TEST_F(GltfReader, RefusesMissingFilesAndFolders) {
  EXPECT_EQ(read_design(folder_.path() / "missing.glb").error().code, ErrorCode::kBadInput);
  std::filesystem::create_directory(folder_.path() / "folder.glb");
  EXPECT_EQ(read_design(folder_.path() / "folder.glb").error().code, ErrorCode::kBadInput);
  refused("", "is empty");
  refused("whatever", "not a design that can be read", "design.step");
}

}  // namespace
}  // namespace spool::test
