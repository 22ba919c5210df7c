// STL, OBJ and PLY meshes and bare clouds as designs: parts, welding, units, refusals.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "tests/support/refusal.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/write_file.h"
#include "tests/vision/design/gltf_text.h"
#include "vision/design/design_reader.h"
#include "vision/design/polygon.h"
#include "vision/design/vertex_welding.h"

namespace spool::test {
namespace {

class MeshReader : public testing::Test {
 protected:
  Result<DesignModel> read(const std::string& name, const std::string& bytes,
                           std::optional<LengthUnit> unit = LengthUnit::kMetre) {
    return read_design(write_file(folder_.path() / name, bytes), unit);
  }
  void refused(const std::string& name, const std::string& bytes, const std::string& why,
               std::optional<LengthUnit> unit = LengthUnit::kMetre) {
    expect_refused(read(name, bytes, unit), ErrorCode::kBadInput, name, why);
  }
  TemporaryFolder folder_;
};

// A tetrahedron as an ASCII solid.
std::string solid(const std::string& name, double size) {
  const double corners[4][3] = {{0, 0, 0}, {size, 0, 0}, {0, size, 0}, {0, 0, size}};
  const int faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  std::string text = "solid " + name + "\n";
  for (const auto& face : faces) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const int k : face) {
      text += "vertex " + std::to_string(corners[k][0]) + " " + std::to_string(corners[k][1]) +
              " " + std::to_string(corners[k][2]) + "\n";
    }
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid " + name + "\n";
}

std::string binary_stl(std::uint32_t said, int held) {
  std::string bytes(80, ' ');
  for (int i = 0; i < 4; ++i) bytes += static_cast<char>((said >> (8 * i)) & 255U);
  for (int i = 0; i < held; ++i) {
    const float z = static_cast<float>(i);
    bytes += floats({0, 0, 1, 0, 0, z, 1, 0, z, 0, 1, z}) + std::string(2, '\0');
  }
  return bytes;
}

TEST_F(MeshReader, WeldsAnStlAndNamesItByItsFile) {
  const Result<DesignModel> design = read("bracket.stl", binary_stl(2, 2));
  ASSERT_TRUE(design) << design.error().message;
  ASSERT_EQ(design->parts.size(), 1U);
  EXPECT_EQ(design->parts[0].name, "bracket");
  EXPECT_EQ(design->parts[0].kind, PartKind::kOther);
  EXPECT_EQ(design->mesh.triangles.size(), 2U);
  const Result<DesignModel> whole = read("one.stl", solid("flange", 1));
  ASSERT_TRUE(whole) << whole.error().message;
  EXPECT_EQ(whole->mesh.triangles.size(), 4U);
  EXPECT_EQ(whole->mesh.vertices.size(), 4U);  // of 12 written
  EXPECT_FALSE(whole->unit_inferred);
}

TEST_F(MeshReader, MakesAPartOfEachSolidAndEachObjGroup) {
  const Result<DesignModel> stl = read("two.stl", solid("Left", 1) + solid("Right", 2));
  ASSERT_TRUE(stl) << stl.error().message;
  ASSERT_EQ(stl->parts.size(), 2U);
  EXPECT_EQ(stl->parts[0].name, "Left");
  EXPECT_EQ(stl->parts[1].name, "Right");
  const Result<DesignModel> obj =
      read("two.obj",
           "mtllib ../../secret.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n"
           "o flange\nf 1 2 3\no pipe\nusemtl red\nf 2 4 3\n");
  ASSERT_TRUE(obj) << obj.error().message;
  ASSERT_EQ(obj->parts.size(), 2U);
  EXPECT_EQ(obj->parts[0].name, "flange");
  EXPECT_EQ(obj->parts[1].name, "pipe");
  EXPECT_EQ(obj->triangle_part, (std::vector<std::int32_t>{0, 1}));
}

TEST_F(MeshReader, TriangulatesPolygonsAndDropsTrianglesWithoutArea) {
  const Result<DesignModel> design =
      read("quad.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\nf 1 2 2\nf 1 2 1\n");
  ASSERT_TRUE(design) << design.error().message;
  EXPECT_EQ(design->mesh.triangles.size(), 2U);
  EXPECT_FALSE(design->warnings.empty());
}

TEST_F(MeshReader, InfersTheUnitOnlyWhereTheSizeTellsIt) {
  const struct {
    double size;
    std::optional<LengthUnit> unit;
  } kRows[] = {{0.001, std::nullopt},
               {0.02, LengthUnit::kMetre},
               {0.5, LengthUnit::kMetre},
               {1.375, std::nullopt},  // inches of a small part, or metres of a large one
               {5, std::nullopt},
               {14, std::nullopt},
               {20, LengthUnit::kMillimetre},
               {304.8, LengthUnit::kMillimetre},
               {2999.1, LengthUnit::kMillimetre},
               {14000, LengthUnit::kMillimetre},
               {60000, std::nullopt}};
  for (const auto& row : kRows) {
    SCOPED_TRACE(row.size);
    const std::string bytes = solid("part", row.size);
    if (!row.unit) {
      refused("part.stl", bytes, "give --design-unit", std::nullopt);
      continue;
    }
    const Result<DesignModel> design = read("part.stl", bytes, std::nullopt);
    ASSERT_TRUE(design) << design.error().message;
    EXPECT_EQ(design->unit, *row.unit);
    EXPECT_TRUE(design->unit_inferred);
    ASSERT_EQ(design->warnings.size(), 1U);
    EXPECT_NE(design->warnings[0].find("confirm it by --design-unit"), std::string::npos);
    EXPECT_NEAR(design->bounds().sizes().x(), row.size * metres(*row.unit), 1e-5);
  }
  EXPECT_NEAR(read("part.stl", solid("part", 5), LengthUnit::kInch)->bounds().sizes().x(), 0.127,
              1e-6);
}

TEST_F(MeshReader, ReadsAPlyAsMeshOrCloudByItsFaces) {
  const std::string vertices =
      "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
  const std::string mesh = "ply\nformat ascii 1.0\n" + vertices +
                           "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
                           "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  const Result<DesignModel> triangle = read("a.ply", mesh);
  ASSERT_TRUE(triangle) << triangle.error().message;
  EXPECT_EQ(triangle->mesh.triangles.size(), 1U);
  EXPECT_FALSE(triangle->is_cloud());
  const Result<DesignModel> points =
      read("b.ply", "ply\nformat ascii 1.0\n" + vertices + "end_header\n0 0 0\n1 0 0\n0 1 0\n");
  ASSERT_TRUE(points) << points.error().message;
  EXPECT_TRUE(points->is_cloud());
  ASSERT_EQ(points->parts.size(), 1U);
  EXPECT_EQ(points->parts[0].name, "b");
  EXPECT_EQ(points->cloud.size(), 3U);
  EXPECT_TRUE(points->cloud.has_normals());
}

TEST_F(MeshReader, KeepsTheNormalsThatACloudBrings) {
  const Result<DesignModel> design = read("c.xyz", "0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n");
  ASSERT_TRUE(design) << design.error().message;
  ASSERT_TRUE(design->cloud.has_normals());
  EXPECT_EQ(design->cloud.normals[0], Eigen::Vector3f::UnitZ());
  for (const std::string& warning : design->warnings) {
    EXPECT_EQ(warning.find("without normals"), std::string::npos);
  }
}

TEST_F(MeshReader, WarnsOfDigitsThatFloatCannotKeep) {
  const Result<DesignModel> design =
      read("far.obj", "v 431207.25 0 0\nv 431208.25 0 0\nv 431207.25 1 0\nf 1 2 3\n");
  ASSERT_TRUE(design) << design.error().message;
  ASSERT_EQ(design->warnings.size(), 1U);
  EXPECT_NE(design->warnings[0].find("export it near its origin"), std::string::npos);
  EXPECT_NEAR(design->origin.x(), 431208, 1.0);
}

TEST_F(MeshReader, RefusesBadFilesWithASentence) {
  refused("short.stl", binary_stl(100, 3), "cut short");
  refused("lying.stl", binary_stl(4000000000U, 3), "cut short");
  refused("tiny.stl", "xyz", "cut short");
  refused("empty.stl", "", "is empty");
  refused("none.stl", "solid nothing\nendsolid nothing\n", "no surface");
  refused("zero.stl", binary_stl(0, 0), "cannot be read as a mesh");
  refused("points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n", "no surface");
  refused("flat.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n", "not one triangle with an area");
  refused("index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 99999999\n", "index.obj");
  refused("nan.obj", "v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n", "nan.obj");
  refused("notply.ply", "plx\n", "notply.ply");
  const std::string header =
      "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\nproperty float x\n"
      "property float y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\n"
      "end_header\n";
  refused("huge.ply", header + "abc", "cut short");
}

TEST_F(MeshReader, RefusesOrSurvivesEveryTruncation) {
  const std::string whole =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
      "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
      "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  for (std::size_t length = 1; length < whole.size(); length += 3) {
    const Result<DesignModel> design = read("cut.ply", whole.substr(0, length));
    if (!design) {
      EXPECT_EQ(design.error().code, ErrorCode::kBadInput);
    }
  }
  const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1/1/1 2//2 3\nf -1 -2 -3\ng a b c\nl 1 2\n";
  for (std::size_t length = 1; length < obj.size(); ++length) {
    (void)read("cut.obj", obj.substr(0, length)).has_value();
  }
}

TEST(Polygon, IsCoveredByItsTrianglesWhereItIsConcave) {
  // An arrow head, a comb and a square, tilted in space: areas add up and no triangle turns over.
  const std::vector<std::vector<Eigen::Vector2d>> loops{{{0, 0}, {2, 1}, {0, 2}, {0.5, 1}},
                                                        {{0, 0},
                                                         {5, 0},
                                                         {5, 2},
                                                         {4, 2},
                                                         {4, 1},
                                                         {3, 1},
                                                         {3, 2},
                                                         {2, 2},
                                                         {2, 1},
                                                         {1, 1},
                                                         {1, 2},
                                                         {0, 2}},
                                                        {{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  const std::vector<double> areas{1.5, 8, 1};
  const Eigen::Matrix3d turned =
      Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).matrix();
  for (std::size_t l = 0; l < loops.size(); ++l) {
    std::vector<Eigen::Vector3d> vertices;
    std::vector<std::uint32_t> loop;
    for (const Eigen::Vector2d& p : loops[l]) {
      loop.push_back(static_cast<std::uint32_t>(vertices.size()));
      vertices.push_back(turned * Eigen::Vector3d(p.x(), p.y(), 0));
    }
    std::vector<Triangle> triangles;
    triangulate_polygon(vertices, loop, triangles);
    EXPECT_EQ(triangles.size(), loop.size() - 2);
    double area = 0;
    for (const Triangle& t : triangles) {
      const Eigen::Vector3d cross =
          (vertices[t[1]] - vertices[t[0]]).cross(vertices[t[2]] - vertices[t[0]]);
      EXPECT_GE((turned.transpose() * cross).z(), 0);
      area += 0.5 * cross.norm();
    }
    EXPECT_NEAR(area, areas[l], 1e-12);
  }
}

TEST(VertexWelding, JoinsWhatLiesWithinTheToleranceAndNothingElse) {
  std::vector<Eigen::Vector3f> vertices;
  for (int i = 0; i < 1000; ++i) {
    const float x = 0.01F * static_cast<float>(i);
    vertices.emplace_back(x, -x, 0.5F * x);
    vertices.emplace_back(x + 5e-7F, -x, 0.5F * x - 5e-7F);  // another rounding of the same place
  }
  vertices.emplace_back(std::numeric_limits<float>::quiet_NaN(), 0.0F, 0.0F);
  const float tolerance = 2e-6F;
  const std::vector<std::uint32_t> welded = weld_vertices(vertices, tolerance);
  for (std::uint32_t v = 0; v < 2000; ++v) EXPECT_EQ(welded[v], v - v % 2) << v;
  EXPECT_EQ(welded[2000], 2000U);
}

}  // namespace
}  // namespace spool::test
