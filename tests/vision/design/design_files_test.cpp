// Real and hostile files of other people: counts and sizes as their README has them, nothing
// crashes.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/shared_data.h"
#include "vision/design/design_reader.h"
#include "vision/design/design_surface.h"

namespace spool::test {
namespace {

DesignModel read(const std::filesystem::path& path, std::optional<LengthUnit> unit = std::nullopt) {
  Result<DesignModel> design = read_design(path, unit);
  EXPECT_TRUE(design.has_value()) << (design ? "" : design.error().message);
  return design ? std::move(*design) : DesignModel{};
}

nlohmann::json json_of(const std::filesystem::path& path) {
  std::ifstream file(path);
  return nlohmann::json::parse(file);
}

TEST(DesignFiles, GltfCountsAreThoseOfTheReadme) {
  SPOOL_REQUIRE_SHARED(folder, "models/gltf");
  const struct {
    const char* file;
    std::size_t parts;
    std::size_t triangles;  // as placed: a mesh counts once for every node that uses it
  } kRows[] = {
      {"BoxInterleaved.glb", 1, 12},
      {"BoxTextured.glb", 1, 12},
      {"cube.glb", 1, 12},  // chunk lengths are no multiples of four, as the format wants
      {"cubevc.glb", 1, 48},
      {"nested.glb", 3, 36},
      {"no_indices_3storybuilding.glb", 3, 72},
      {"pins.glb", 7, 3408},  // 1838 in two meshes; one node has the larger, six the smaller
      {"boolean.glb", 28, 3936},
      {"simple_pole.glb", 11, 580},
      {"testplate.glb", 1, 264},
      {"monkey.glb", 1, 968},
      {"rgb_cube_with_primitives.gltf", 1, 12},
      {"mode5.gltf", 54,
       2786},  // strips; joints of strips, which name a vertex twice, are no triangles
      {"Mesh_PrimitiveMode_04.gltf", 1, 2},
  };
  for (const auto& row : kRows) {
    SCOPED_TRACE(row.file);
    const DesignModel design = read(folder / row.file);
    EXPECT_EQ(design.parts.size(), row.parts);
    EXPECT_EQ(design.mesh.triangles.size(), row.triangles);
    EXPECT_EQ(design.triangle_part.size(), row.triangles);
    EXPECT_TRUE(DesignSurface::build(design).has_value());
  }
  const Result<DesignModel> empty = read_design(folder / "empty_nodes.glb");
  ASSERT_FALSE(empty);
  EXPECT_NE(empty.error().message.find("no mesh"), std::string::npos);
}

TEST(DesignFiles, NestedTransformsPlaceTheirBoxes) {
  SPOOL_REQUIRE_SHARED(path, "models/gltf/nested.glb");
  const DesignModel design = read(path);
  // Multiplied out by hand: block03 lies in block02, that in block01; all scale unevenly.
  const Eigen::Vector3d scale1(0.26938149333, 0.28434106708, 0.26938149333);
  const Eigen::Vector3d shift1(-0.89763182402, 0.6829495430, 0);
  const Eigen::Vector3d shift2(3.33219552042, -2.40186738968, 0);
  std::map<std::string, Eigen::Vector3d> centre;
  for (const Part& part : design.parts) centre[part.name] = part.T_design_part.translation();
  EXPECT_LT((centre["block01"] - shift1).norm(), 1e-6);
  EXPECT_LT((centre["block02"] - shift1 - scale1.cwiseProduct(shift2)).norm(), 1e-6);
}

TEST(DesignFiles, MeshSizesAreThoseOfTheReadme) {
  SPOOL_REQUIRE_SHARED(folder, "models/mesh");
  const struct {
    const char* file;
    std::optional<LengthUnit> unit;  // said; else inferred
    LengthUnit found;
    std::size_t parts;
    Eigen::Vector3d size_m;
    double tolerance_m;  // half of the README's last digit
  } kRows[] = {
      {"plate_holes.STL", std::nullopt, LengthUnit::kMillimetre, 1, {0.2032, 0.3048, 0.0127}, 5e-5},
      {"20mm-xyz-cube.stl", std::nullopt, LengthUnit::kMillimetre, 1, {0.02, 0.02, 0.02}, 5e-5},
      {"featuretype.STL", LengthUnit::kInch, LengthUnit::kInch, 1, {0.127, 0.0635, 0.034925}, 1e-6},
      {"featuretype.ply", LengthUnit::kInch, LengthUnit::kInch, 1, {0.127, 0.0635, 0.034925}, 1e-6},
      {"octagonal_pocket.stl", std::nullopt, LengthUnit::kMetre, 1, {0.229, 0.165, 0.016}, 5e-4},
      {"octagonal_pocket.ply", std::nullopt, LengthUnit::kMetre, 1, {0.229, 0.165, 0.016}, 5e-4},
      {"cylinder.stl", LengthUnit::kMetre, LengthUnit::kMetre, 1, {2, 2, 8}, 0.05},
      {"tube.obj", LengthUnit::kMetre, LengthUnit::kMetre, 1, {1.66, 11.84, 1.66}, 0.02},
      {"two_objects_mixed_case_names.stl",
       LengthUnit::kMetre,
       LengthUnit::kMetre,
       2,
       {6, 1, 1},
       1e-3},
  };
  for (const auto& row : kRows) {
    SCOPED_TRACE(row.file);
    const DesignModel design = read(folder / row.file, row.unit);
    EXPECT_EQ(design.unit, row.found);
    EXPECT_EQ(design.unit_inferred, !row.unit.has_value());
    EXPECT_EQ(design.parts.size(), row.parts);
    EXPECT_LT((design.bounds().sizes() - row.size_m).cwiseAbs().maxCoeff(), row.tolerance_m)
        << design.bounds().sizes().transpose();
  }
  // Five units long: metres of a frame or inches of a bracket. Nobody can tell, so somebody is
  // asked.
  for (const char* file : {"featuretype.STL", "featuretype.ply"}) {
    const Result<DesignModel> design = read_design(folder / file);
    ASSERT_FALSE(design);
    EXPECT_NE(design.error().message.find("--design-unit"), std::string::npos);
  }
  EXPECT_EQ(read(folder / "two_objects_mixed_case_names.stl", LengthUnit::kMetre).parts[1].name,
            "TranslatedCubeExportedFromCAD");
  const DesignModel cycloidal = read(folder / "cycloidal.ply", LengthUnit::kMetre);
  EXPECT_GE(cycloidal.mesh.triangles.size(), 43368U - 20U);  // some of its 43 368 have no area
}

TEST(DesignFiles, TheFlamingoSpoolsAreMillimetresAndWhole) {
  SPOOL_REQUIRE_SHARED(folder, "piping");
  const struct {
    const char* file;
    std::size_t triangles;
  } kRows[] = {{"flamingo_pipeline/spool1_flanged_stub_dn40.stl", 6220},
               {"flamingo_pipeline/flange_pipe_elbow90_dn40.stl", 22204},
               {"flamingo_pipeline/spool2_three_bends_dn40.stl", 48920},
               {"flamingo_pipeline/spool2_three_bends_dn40.obj", 48920},
               {"flamingo_pipeline/spool2_with_ubolts.stl", 87128},
               {"flamingo_pipeline/spool3_dn65_flange_pipe.stl", 3924},
               {"valves/butterfly_DN80_tess.stl", 13152},
               {"valves/check_DN50_tess.stl", 9286}};
  for (const auto& row : kRows) {
    SCOPED_TRACE(row.file);
    const DesignModel design = read(folder / row.file);
    EXPECT_EQ(design.unit, LengthUnit::kMillimetre);
    EXPECT_TRUE(design.unit_inferred);
    EXPECT_EQ(design.mesh.triangles.size(), row.triangles);
  }
  const DesignModel spool = read(folder / "flamingo_pipeline/spool2_three_bends_dn40.obj");
  EXPECT_EQ(spool.parts.size(), 8U);  // a flange, four pipes, three elbows
  // Its centre line runs at y = 488 mm from x = 700 to 3200 at z = 830: 48.26 mm outside, so the
  // axis lies half of that deep, 3.2 m from the origin to within the facets' 0.02 mm.
  const Result<DesignSurface> surface = DesignSurface::build(spool);
  ASSERT_TRUE(surface);
  for (double x = 1.0; x < 3.0; x += 0.25) {
    const auto above =
        surface->closest(Eigen::Vector3d(x, 0.488, 0.830 + 0.02413 + 0.002).cast<float>(), 1);
    ASSERT_TRUE(above);
    EXPECT_NEAR(above->distance, 0.002, 3e-5);
    const auto inside =
        surface->closest(Eigen::Vector3d(x, 0.488, 0.830 + 0.02413 - 0.001).cast<float>(), 1);
    ASSERT_TRUE(inside);
    EXPECT_NEAR(inside->distance, -0.001, 3e-5);
  }
}

TEST(DesignFiles, TheScenesDesignsHaveTheirPartsPortsAndJoints) {
  SPOOL_REQUIRE_SHARED(scenes, "scenes");
  for (const char* scene : {"spool1_handheld", "ps_laser", "bf_laser", "spool2_laser_defect"}) {
    SCOPED_TRACE(scene);
    const std::filesystem::path folder = scenes / scene / "design";
    const DesignModel design = read(folder / "model.glb");
    const nlohmann::json truth = json_of(folder / "design.json");
    EXPECT_TRUE(design.warnings.empty()) << design.warnings[0];
    EXPECT_EQ(design.datums, (std::vector<int>{0}));
    const nlohmann::json& components = truth.at("components");
    ASSERT_EQ(design.parts.size(), components.size());
    std::set<std::pair<int, int>> joined;
    for (const Joint& joint : design.joints) joined.insert(std::minmax(joint.part_a, joint.part_b));
    for (std::size_t i = 0; i < design.parts.size(); ++i) {
      const Part& part = design.parts[i];
      const nlohmann::json& component = components[i];
      EXPECT_EQ(part.name, component.at("name"));
      EXPECT_EQ(part.order, static_cast<int>(i));
      EXPECT_EQ(part.kind == PartKind::kFlange, part.holes.has_value());
      Eigen::Matrix4d pose;
      for (int r = 0; r < 4; ++r) {
        for (int c = 0; c < 4; ++c) {
          pose(r, c) =
              component.at("pose").at(static_cast<std::size_t>(r)).at(static_cast<std::size_t>(c));
        }
      }
      EXPECT_TRUE(part.T_design_part.matrix().isApprox(pose, 1e-9)) << part.name;
      if (part.kind != PartKind::kStructure) {
        EXPECT_EQ(part.nps, component.at("nps")) << part.name;
      }
    }
    // Welded ports lie on one another and face each other.
    for (const Joint& joint : design.joints) {
      const Part& a = design.parts[static_cast<std::size_t>(joint.part_a)];
      const Part& b = design.parts[static_cast<std::size_t>(joint.part_b)];
      const Port& port_a = a.ports[static_cast<std::size_t>(joint.port_a)];
      const Port& port_b = b.ports[static_cast<std::size_t>(joint.port_b)];
      EXPECT_LT((a.T_design_part * port_a.position - b.T_design_part * port_b.position).norm(),
                1e-6);
      EXPECT_LT((a.T_design_part.linear() * port_a.direction +
                 b.T_design_part.linear() * port_b.direction)
                    .norm(),
                1e-6);
    }
  }
}

TEST(DesignFiles, NoFileOfTheGltfValidatorCrashesAndTheBrokenAreRefused) {
  SPOOL_REQUIRE_SHARED(folder, "robust/gltf_validator");
  const std::set<std::string> refused_folders{"glb",    "accessor",    "accessor_data",
                                              "buffer", "buffer_view", "mesh"};
  int files = 0;
  int broken = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    const std::string ending = entry.path().extension().string();
    if (ending != ".glb" && ending != ".gltf") continue;
    SCOPED_TRACE(entry.path().filename());
    ++files;
    const Result<DesignModel> design = read_design(entry.path());
    const nlohmann::json report = json_of(entry.path().string() + ".report.json");
    const bool has_errors = report.at("issues").at("numErrors").get<int>() > 0;
    if (has_errors && refused_folders.count(entry.path().parent_path().filename()) != 0) {
      ++broken;
      ASSERT_FALSE(design.has_value());
    }
    if (!design) {
      EXPECT_EQ(design.error().code, ErrorCode::kBadInput);
      EXPECT_GT(design.error().message.size(), entry.path().string().size() + 10);
    }
  }
  EXPECT_EQ(files, 111);
  EXPECT_GT(broken, 80);
}

TEST(DesignFiles, NoBrokenMeshFileCrashes) {
  SPOOL_REQUIRE_SHARED(folder, "robust/mesh");
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    SCOPED_TRACE(entry.path().filename());
    for (const LengthUnit unit : {LengthUnit::kMetre, LengthUnit::kMillimetre}) {
      const Result<DesignModel> design = read_design(entry.path(), unit);
      if (design) {
        EXPECT_FALSE(design->parts.empty());
        EXPECT_TRUE(DesignSurface::build(*design).has_value());
      } else {
        EXPECT_EQ(design.error().code, ErrorCode::kBadInput);
        EXPECT_NE(design.error().message.find(entry.path().filename().string()), std::string::npos);
      }
    }
  }
}

}  // namespace
}  // namespace spool::test
