// All that the simulated camera can see, as one triangle mesh.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/simulator/world.h"

#include <cmath>
#include <numbers>

#include "tools/simulator/solids.h"
#include "vision/design/design_reader.h"

namespace spool::simulator {
namespace {

void add(World& world, const TriangleMesh& mesh, const Pose& T_map_mesh,
         const std::vector<std::int32_t>& part, const std::vector<std::uint8_t>& bright) {
  const auto first = static_cast<std::uint32_t>(world.mesh.vertices.size());
  for (const Eigen::Vector3f& vertex : mesh.vertices)
    world.mesh.vertices.push_back((T_map_mesh * vertex.cast<double>()).cast<float>());
  for (const Triangle& t : mesh.triangles)
    world.mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  world.triangle_part.insert(world.triangle_part.end(), part.begin(), part.end());
  world.bright.insert(world.bright.end(), bright.begin(), bright.end());
}

// True for a triangle (part frame) that lies in a machined flange face.
bool is_flange_face(const Part& part, const Eigen::Vector3d& centroid,
                    const Eigen::Vector3d& normal) {
  constexpr double kRaisedFace = 0.008;  // m; 1.6 mm and 6.4 mm raised faces lie within
  constexpr double kParallel = 0.999;
  if (part.kind != PartKind::kFlange && part.kind != PartKind::kBlind) return false;
  for (const Port& port : part.ports)
    if (port.end == EndType::kFlanged && normal.dot(port.direction) > kParallel &&
        std::abs(port.direction.dot(centroid - port.position)) < kRaisedFace)
      return true;
  return false;
}

std::vector<std::uint8_t> bright_triangles(const DesignModel& design, const AsBuilt& built) {
  std::vector<std::uint8_t> bright(built.mesh.triangles.size(), 0);
  for (std::size_t t = 0; t < bright.size(); ++t) {
    const auto part = static_cast<std::size_t>(built.triangle_part[t]);
    const Pose T_part_design = built.parts[part].T_design_part.inverse();
    std::array<Eigen::Vector3d, 3> p;
    for (std::size_t c = 0; c < 3; ++c)
      p[c] = T_part_design * built.mesh.vertices[built.mesh.triangles[t][c]].cast<double>();
    const Eigen::Vector3d normal = (p[1] - p[0]).cross(p[2] - p[0]).normalized();
    bright[t] = is_flange_face(design.parts[part], (p[0] + p[1] + p[2]) / 3, normal) ? 1 : 0;
  }
  return bright;
}

// Where the design lies when the scene does not say: its y up, in the table's middle, on the table.
Pose resting(const AsBuilt& built, double table_height_m) {
  Pose upright = Pose::Identity();
  upright.linear() = Eigen::AngleAxisd(std::numbers::pi / 2, Eigen::Vector3d::UnitX()).matrix();
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3f& vertex : built.mesh.vertices)
    box.extend(upright * vertex.cast<double>());
  upright.translation() =
      Eigen::Vector3d(-box.center().x(), -box.center().y(), table_height_m - box.min().z());
  return upright;
}

}  // namespace

Result<World> build_world(const Scene& scene, const std::string& file) {
  World world;
  Eigen::AlignedBox3d box;
  if (!scene.design.empty()) {
    auto design = read_design(scene.design, LengthUnit::kMetre);
    if (!design) return design.error();
    if (design->is_cloud())
      return Error{ErrorCode::kBadInput, scene.design.string() +
                                             ": has no surface to look at; name a design of "
                                             "triangles in " +
                                             file};
    auto built = build_as(*design, scene.as_built, file);
    if (!built) return built.error();
    world.as_built = *std::move(built);
    world.T_map_design =
        scene.on_table ? resting(world.as_built, scene.table_height_m) : scene.T_map_design;
    add(world, world.as_built.mesh, world.T_map_design, world.as_built.triangle_part,
        bright_triangles(*design, world.as_built));
    for (const Eigen::Vector3f& vertex : world.mesh.vertices) box.extend(vertex.cast<double>());
    world.design = *std::move(design);
  }
  for (const Body& body : scene.bodies) {
    // 256 facets: a 100 mm cylinder is 4 um inside its circle at most.
    const TriangleMesh mesh = body.kind == BodyKind::kBox
                                  ? box_mesh(body.size_m)
                                  : cylinder_mesh(body.size_m.x(), body.size_m.z(), 256);
    add(world, mesh, body.T_map_body, std::vector<std::int32_t>(mesh.triangles.size(), -1),
        std::vector<std::uint8_t>(mesh.triangles.size(), body.bright_metal ? 1 : 0));
    if (!world.design) box.extend(body.T_map_body.translation());
  }
  if (world.mesh.triangles.empty())
    return Error{ErrorCode::kBadInput, file + ": the scene is empty; add a design or clutter"};
  world.centre = box.center();
  return world;
}

}  // namespace spool::simulator
