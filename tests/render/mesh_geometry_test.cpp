// Normals, creases and outlines of design meshes.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "render/mesh_geometry.h"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace spool::render {
namespace {

constexpr double kPi = std::numbers::pi;

TriangleMesh cube() {
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i) mesh.vertices.emplace_back(i & 1, (i >> 1) & 1, (i >> 2) & 1);
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

// Radius 1 about z, from 0 to 2, open ends.
TriangleMesh tube(std::uint32_t around) {
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i < around; ++i) {
    const double angle = 2 * kPi * i / around;
    for (const double z : {0.0, 2.0}) {
      mesh.vertices.push_back(Eigen::Vector3d(std::cos(angle), std::sin(angle), z).cast<float>());
    }
  }
  for (std::uint32_t i = 0; i < around; ++i) {
    const std::uint32_t a = 2 * i;
    const std::uint32_t b = 2 * ((i + 1) % around);
    mesh.triangles.push_back({a, b, b + 1});
    mesh.triangles.push_back({a, b + 1, a + 1});
  }
  return mesh;
}

// As STL files hold meshes: three vertices of its own for each triangle.
TriangleMesh soup(const TriangleMesh& mesh) {
  TriangleMesh result;
  for (const Triangle& triangle : mesh.triangles) {
    const auto first = static_cast<std::uint32_t>(result.vertices.size());
    for (const auto v : triangle) result.vertices.push_back(mesh.vertices[v]);
    result.triangles.push_back({first, first + 1, first + 2});
  }
  return result;
}

TEST(MeshGeometry, CubeHasTwelveCreasesAndFlatFaces) {
  const MeshGeometry g = prepare_mesh(cube(), {});
  EXPECT_EQ(g.creases.size(), 12U);
  EXPECT_TRUE(g.smooth.empty());      // the faces' diagonals
  EXPECT_EQ(g.vertices.size(), 24U);  // eight corners with three normals
  EXPECT_EQ(g.indices.size(), 36U);
  for (const MeshVertex& v : g.vertices) {
    EXPECT_NEAR(v.normal.cwiseAbs().maxCoeff(), 1, 1e-6);
    EXPECT_GT((v.position - Eigen::Vector3f(0.5F, 0.5F, 0.5F)).dot(v.normal), 0);
  }
}

TEST(MeshGeometry, TubeIsSmoothAroundAndHasTwoRims) {
  const MeshGeometry g = prepare_mesh(tube(32), {});
  EXPECT_EQ(g.creases.size(), 64U);
  EXPECT_EQ(g.smooth.size(), 32U);
  EXPECT_EQ(g.vertices.size(), 64U);
  for (const MeshVertex& v : g.vertices) {
    const Eigen::Vector3f radial(v.position.x(), v.position.y(), 0);
    EXPECT_NEAR(v.normal.dot(radial), 1,
                1e-4);  // weighted by angle: exact by symmetry but for rounding
  }
}

TEST(MeshGeometry, ATriangleSoupGivesTheSame) {
  const MeshGeometry whole = prepare_mesh(tube(24), {});
  const MeshGeometry pieces = prepare_mesh(soup(tube(24)), {});
  EXPECT_EQ(pieces.creases.size(), whole.creases.size());
  EXPECT_EQ(pieces.smooth.size(), whole.smooth.size());
  EXPECT_EQ(pieces.vertices.size(), whole.vertices.size());
}

TEST(MeshGeometry, PartsMeetInACreaseAndKeepTheirNumbers) {
  TriangleMesh mesh = tube(16);
  std::vector<std::int32_t> part(mesh.triangles.size(), 0);
  for (std::size_t t = 0; t < 8; ++t) part[t] = 3;
  const MeshGeometry g = prepare_mesh(mesh, part);
  std::size_t between = 0;
  for (const MeshEdge& edge : g.creases) between += edge.part != edge.other_part ? 1U : 0U;
  EXPECT_EQ(between, 2U);
  EXPECT_EQ(g.smooth.size(), 14U);
  for (std::size_t i = 0; i < g.indices.size(); ++i)
    EXPECT_EQ(g.vertices[g.indices[i]].part, part[i / 3]);
}

TEST(MeshGeometry, OutlineOfATubeIsItsTwoTangentLines) {
  const MeshGeometry g = prepare_mesh(tube(64), {});
  std::vector<MeshEdge> outline;
  const Eigen::Vector3f eye(5, 0, 1);
  append_outline(g.smooth, eye, outline);
  ASSERT_EQ(outline.size(), 2U);
  for (const MeshEdge& edge : outline) {
    // Tangents from (5, 0) to the unit circle touch it at x = 1/5; a facet is 2 pi / 64 wide.
    EXPECT_NEAR(edge.from.x(), 0.2, 2 * kPi / 64);
    EXPECT_EQ(edge.from.x(), edge.to.x());
  }
}

TEST(MeshGeometry, OneTriangleInsideOutChangesNoOutline) {
  TriangleMesh mesh = tube(64);
  std::swap(mesh.triangles[10][0], mesh.triangles[10][1]);
  std::vector<MeshEdge> outline;
  const MeshGeometry g = prepare_mesh(mesh, {});
  EXPECT_EQ(g.creases.size(), 128U);
  append_outline(g.smooth, {5, 0, 1}, outline);
  EXPECT_EQ(outline.size(), 2U);
}

TEST(MeshGeometry, LeavesOutTrianglesWithoutArea) {
  TriangleMesh mesh = cube();
  mesh.triangles.push_back({0, 0, 1});
  mesh.vertices.emplace_back(0.5F, 0, 0);
  mesh.triangles.push_back({0, 1, 8});
  mesh.vertices.emplace_back(std::nanf(""), 0, 0);
  mesh.triangles.push_back({0, 2, 9});
  const MeshGeometry g = prepare_mesh(mesh, {});
  EXPECT_EQ(g.indices.size(), 36U);
  EXPECT_EQ(g.creases.size(), 12U);
}

TEST(MeshGeometry, IsSolidOnlyWhereEveryPartIsClosedAndWoundOutwards) {
  TriangleMesh mesh = cube();
  EXPECT_TRUE(prepare_mesh(mesh, {}).is_solid);
  EXPECT_TRUE(prepare_mesh(soup(mesh), {}).is_solid);
  EXPECT_FALSE(prepare_mesh(tube(8), {}).is_solid);  // open ends
  // A second cube on the first one's face, as parts meet at a weld; then the same inside out.
  std::vector<std::int32_t> part(24, 0);
  for (std::size_t v = 0; v < 8; ++v)
    mesh.vertices.push_back(mesh.vertices[v] + Eigen::Vector3f(0, 0, 1));
  for (std::size_t t = 0; t < 12; ++t) {
    const Triangle& first = mesh.triangles[t];
    mesh.triangles.push_back({first[0] + 8, first[1] + 8, first[2] + 8});
    part[12 + t] = 1;
  }
  EXPECT_TRUE(prepare_mesh(mesh, part).is_solid);
  for (std::size_t t = 12; t < 24; ++t) std::swap(mesh.triangles[t][0], mesh.triangles[t][1]);
  EXPECT_FALSE(prepare_mesh(mesh, part).is_solid);
  mesh.triangles.pop_back();
  part.pop_back();
  EXPECT_FALSE(prepare_mesh(mesh, part).is_solid);  // a triangle missing
}

TEST(MeshGeometry, NothingGivesNothing) {
  const MeshGeometry g = prepare_mesh({}, {});
  EXPECT_TRUE(g.vertices.empty() && g.indices.empty() && g.creases.empty() && g.smooth.empty());
}

}  // namespace
}  // namespace spool::render
