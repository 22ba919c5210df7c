// What a glTF file must not say, refused with a sentence that names it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "tests/vision/design/gltf_reader_fixture.h"

namespace spool::test {
namespace {

// Two accessors, of which the one not given is as it should be.
std::string with_positions(const std::string& accessor) {
  return "[" + accessor +
         R"(, {"bufferView": 1, "componentType": 5123, "count": 12, "type": "SCALAR"}])";
}
std::string with_indices(const std::string& accessor) {
  return R"([{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"}, )" + accessor +
         "]";
}

TEST_F(GltfReader, ReadsABufferBesideTheFileAndNoOther) {
  Pieces pieces;
  const auto with_uri = [&](const std::string& uri) {
    Pieces own = pieces;
    own.buffers = R"([{"byteLength": 72, "uri": ")" + uri + R"("}])";
    return own.json();
  };
  write_file(folder_.path() / "beside.bin", pieces.bin);
  write_file(folder_.path() / "with space.bin", pieces.bin);
  write_file(folder_.path() / "sub" / "below.bin", pieces.bin);
  EXPECT_EQ(good(with_uri("beside.bin"), "design.gltf").mesh.triangles.size(), 4U);
  EXPECT_EQ(good(with_uri("with%20space.bin"), "design.gltf").mesh.triangles.size(), 4U);
  EXPECT_EQ(good(with_uri("sub/below.bin"), "design.gltf").mesh.triangles.size(), 4U);
  // A design in a folder below reaches for what lies above it.
  refused(with_uri("../beside.bin"), "outside the design's folder", "sub/up.gltf");
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
    std::string text;
  } kRows[] = {
      {"view past buffer", "does not lie within its buffer", &Pieces::views,
       R"([{"buffer": 0, "byteLength": 49}, {"buffer": 0, "byteOffset": 48, "byteLength": 1000}])"},
      {"view of no buffer", "names a buffer that is not there", &Pieces::views,
       R"([{"buffer": 7, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 24}])"},
      {"count past view", "reaches past the end", &Pieces::accessors,
       with_positions(R"({"bufferView": 0, "componentType": 5126, "count": 5, "type": "VEC3"})")},
      {"count of 1e8", "a count that cannot be", &Pieces::accessors,
       with_positions(
           R"({"bufferView": 0, "componentType": 5126, "count": 100000000, "type": "VEC3"})")},
      {"offset past view", "reaches past the end", &Pieces::accessors,
       with_positions(
           R"({"bufferView": 0, "byteOffset": 4294967292, "componentType": 5126, "count": 4, "type": "VEC3"})")},
      {"misaligned", "not aligned", &Pieces::accessors,
       with_positions(
           R"({"bufferView": 0, "byteOffset": 2, "componentType": 5126, "count": 3, "type": "VEC3"})")},
      {"positions of two", "wrong type for its use", &Pieces::accessors,
       with_positions(R"({"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC2"})")},
      {"float indices", "wrong component type for indices", &Pieces::accessors,
       with_indices(R"({"bufferView": 1, "componentType": 5126, "count": 6, "type": "SCALAR"})")},
      {"index past vertices", "an index past the last vertex", &Pieces::accessors,
       with_positions(R"({"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"})")},
      {"corners of no triangle", "makes no triangles", &Pieces::accessors,
       with_indices(R"({"bufferView": 1, "componentType": 5123, "count": 11, "type": "SCALAR"})")},
      {"sparse of no view", "names a buffer view that is not there", &Pieces::accessors,
       with_positions(
           R"({"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "sparse": {"count": 1,
            "indices": {"bufferView": 9, "componentType": 5123}, "values": {"bufferView": 9}}})")},
      {"sparse beyond count", "sparse part that cannot be", &Pieces::accessors,
       with_positions(
           R"({"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "sparse": {"count": 5,
            "indices": {"bufferView": 1, "componentType": 5123}, "values": {"bufferView": 0}}})")},
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
      with_indices(R"({"bufferView": 1, "componentType": 5123, "count": 30000, "type": "SCALAR"})");
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
