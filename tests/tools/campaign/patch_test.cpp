// Rays and samples against solids: where a ray hits, there is surface, and before it there is none.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/campaign/patch.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <ostream>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "tests/tools/campaign/solid_distance.h"
#include "tools/campaign/part_mesh.h"
#include "tools/campaign/ray_world.h"

namespace spool::campaign {

// Found by GoogleTest in the type's own namespace.
void PrintTo(const PartSpec& spec, std::ostream* out);
void PrintTo(const PartSpec& spec, std::ostream* out) { *out << spec.name; }

namespace {

using Eigen::Vector3d;
constexpr double kRight = std::numbers::pi / 2;

const PartSpec kParts[] = {
    {.kind = PartKind::kPipe, .name = "pipe", .nps = 4, .length_m = 0.3},
    {.kind = PartKind::kElbow, .name = "elbow_90", .nps = 3, .angle_rad = kRight},
    {.kind = PartKind::kElbow, .name = "elbow_45", .nps = 2, .angle_rad = kRight / 2},
    {.kind = PartKind::kTee, .name = "tee", .nps = 4, .nps2 = 4},
    {.kind = PartKind::kTee, .name = "reducing_tee", .nps = 6, .nps2 = 3},
    {.kind = PartKind::kReducer, .name = "reducer", .nps = 4, .nps2 = 2},
    {.kind = PartKind::kFlange, .name = "flange_4_holes", .nps = 2},
    {.kind = PartKind::kFlange, .name = "flange_8_holes", .nps = 8},
    {.kind = PartKind::kCap, .name = "cap", .nps = 3},
    {.kind = PartKind::kTube, .name = "tube", .length_m = 0.4, .width_m = 0.1}};

class Parts : public testing::TestWithParam<PartSpec> {
 protected:
  RayWorld world() const {
    std::vector<Placed> placed;
    for (const Patch& patch : patches_of(GetParam()))
      placed.push_back({patch, patch.T_part_patch, 0, 0});
    return RayWorld(std::move(placed));
  }
  double distance(const Vector3d& p) const { return test::solid_distance(GetParam(), p); }
};

TEST_P(Parts, AreHitWhereTheirSolidBegins) {
  const RayWorld part = world();
  Random random(1, 1);
  int hits = 0;
  for (int i = 0; i < 4000; ++i) {
    const Vector3d from = Vector3d(0, 0, 0.1) + 0.6 * random.direction();
    const Vector3d aim = Vector3d(0.05, 0, 0.1) + 0.2 * random.uniform() * random.direction();
    const Vector3d direction = (aim - from).normalized();
    const auto hit = part.cast(from, direction, 3);
    hits += hit ? 1 : 0;
    // Rounding at these sizes is 1e-16 m; near double roots its square root.
    if (hit) {
      EXPECT_NEAR(distance(from + hit->distance * direction), 0, 1e-7) << i;
    }
    // Sphere tracing with the solid's distance never steps over a surface: nothing lies before the
    // hit, and on a miss nothing at all. A ray within a milliradian of a surface comes as near as
    // this within the last 10 micrometres.
    constexpr double kNear = 1e-8;
    const double end = hit ? hit->distance : 3;
    for (double t = 0; t < end - 1e-5;) {
      const double d = std::abs(distance(from + t * direction));
      if (d < kNear) {
        ADD_FAILURE() << "ray " << i << " passes a surface at " << t << " of " << end;
        break;
      }
      t += d;
    }
  }
  EXPECT_GT(hits, 300);  // of 4000 aimed at a ball that the part fills a tenth of or more
}

TEST_P(Parts, HaveSamplesOnTheirSurfaceThatFaceTheAir) {
  Random random(1, 2);
  for (const Patch& patch : patches_of(GetParam()))
    for (int i = 0; i < 300; ++i) {
      const auto local = sample(patch, random);
      if (!local) continue;
      const Vector3d p = patch.T_part_patch * *local;
      const Vector3d normal = patch.T_part_patch.linear() * normal_at(patch, *local);
      EXPECT_NEAR(distance(p), 0, 1e-9);
      EXPECT_NEAR(normal.norm(), 1, 1e-12);
      // A step of 0.1 micrometres along the normal leads out, one back leads in; only within that
      // of an edge would it not.
      EXPECT_GT(distance(p + 1e-7 * normal), 0.5e-7);
      EXPECT_LT(distance(p - 1e-7 * normal), 0);
    }
}

TEST_P(Parts, AreSampledEvenly) {
  // Half of a patch's samples lie in each half of its area, cut by planes through its middle that
  // its symmetry makes equal; here: the mean of many is the mean that mesh triangles give.
  const TriangleMesh mesh = mesh_of(GetParam());
  Vector3d expected = Vector3d::Zero();
  double area = 0;
  for (const Triangle& t : mesh.triangles) {
    const Vector3d a = mesh.vertices[t[0]].cast<double>();
    const Vector3d b = mesh.vertices[t[1]].cast<double>();
    const Vector3d c = mesh.vertices[t[2]].cast<double>();
    const double each = 0.5 * (b - a).cross(c - a).norm();
    expected += each * (a + b + c) / 3;
    area += each;
  }
  Random random(1, 3);
  Vector3d sum = Vector3d::Zero();
  double weight = 0;
  double sampled = 0;
  for (const Patch& patch : patches_of(GetParam())) {
    constexpr int kDraws = 4000;
    int kept = 0;
    Vector3d of_patch = Vector3d::Zero();
    for (int i = 0; i < kDraws; ++i)
      if (const auto local = sample(patch, random)) {
        of_patch += patch.T_part_patch * *local;
        ++kept;
      }
    const double each = sampled_area(patch) / kDraws;
    sum += each * of_patch;
    weight += each * kept;
    sampled += each * kept;
  }
  // 4000 draws of a patch: 1.6 % of its size; several patches together do better. Chords take
  // 0.2 % of the area.
  EXPECT_NEAR(sampled / area, 1, 0.02);
  EXPECT_LT((sum / weight - expected / area).norm(), 0.004);
}

TEST_P(Parts, HaveMeshesThatAreClosedAndLieOnTheirSurface) {
  const TriangleMesh mesh = mesh_of(GetParam());
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  double volume = 0;
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) ++edges[{t[i], t[(i + 1) % 3]}];
    const Vector3d a = mesh.vertices[t[0]].cast<double>();
    const Vector3d b = mesh.vertices[t[1]].cast<double>();
    const Vector3d c = mesh.vertices[t[2]].cast<double>();
    volume += a.dot(b.cross(c)) / 6;
    // Chords leave the surface by r / 830 (part_mesh.h), along a bend by half as much again.
    EXPECT_NEAR(distance((a + b + c) / 3), 0, 0.0004) << (a + b + c).transpose() / 3;
  }
  for (const auto& [edge, count] : edges) {
    ASSERT_EQ(count, 1);
    ASSERT_TRUE(edges.contains({edge.second, edge.first}));
  }
  EXPECT_GT(volume, 0);
  for (const Eigen::Vector3f& v : mesh.vertices)
    ASSERT_NEAR(distance(v.cast<double>()), 0, 1e-6);  // floats of 0.4 m: 3e-8
}

INSTANTIATE_TEST_SUITE_P(All, Parts, testing::ValuesIn(kParts),
                         [](const auto& each) { return each.param.name; });

}  // namespace
}  // namespace spool::campaign
