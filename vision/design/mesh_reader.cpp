// STL, OBJ and PLY meshes through assimp: named groups become parts, the unit is given or guessed.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>
#include <assimp/scene.h>

#include "vision/design/design_builder.h"
#include "vision/design/polygon.h"
#include "vision/design/readers.h"
#include "vision/design/unit_guess.h"
#include "vision/design/vertex_welding.h"

namespace spool {
namespace {

// Nothing beside the design is opened: material libraries and textures mean nothing to us.
class NoFiles final : public Assimp::IOSystem {
 public:
  bool Exists(const char*) const override { return false; }
  char getOsSeparator() const override { return '/'; }
  Assimp::IOStream* Open(const char*, const char*) override { return nullptr; }
  void Close(Assimp::IOStream*) override {}
};

Error bad(const DesignFile& file, const std::string& what) {
  return {ErrorCode::kBadInput, file.path.string() + " " + what};
}

// The triangles of one assimp mesh as a part in the file's units; indices are not believed.
// Polygons are cut here and not by assimp, whose Debian build aborts the program where its own
// steps disagree.
RawPart to_part(const aiMesh& mesh, std::size_t& dropped) {
  RawPart raw;
  raw.vertices.reserve(mesh.mNumVertices);
  for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
    const aiVector3D& p = mesh.mVertices[v];
    raw.vertices.emplace_back(static_cast<double>(p.x), static_cast<double>(p.y),
                              static_cast<double>(p.z));
  }
  for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
    const std::span<const std::uint32_t> loop(mesh.mFaces[f].mIndices, mesh.mFaces[f].mNumIndices);
    const bool good =
        loop.size() >= 3 && std::all_of(loop.begin(), loop.end(), [&](std::uint32_t v) {
          return v < raw.vertices.size() && raw.vertices[v].allFinite();
        });
    if (good) {
      triangulate_polygon(raw.vertices, loop, raw.triangles);
    } else {
      ++dropped;
    }
  }
  return raw;
}

// Moves the second part's triangles into the first's.
void merge(RawPart& into, const RawPart& from) {
  const auto first = static_cast<std::uint32_t>(into.vertices.size());
  into.vertices.insert(into.vertices.end(), from.vertices.begin(), from.vertices.end());
  for (Triangle triangle : from.triangles) {
    for (std::uint32_t& vertex : triangle) vertex += first;
    into.triangles.push_back(triangle);
  }
}

// One part a node, in the order of the tree: assimp makes a node of each OBJ group and ASCII solid,
// and splits its faces into several meshes by material.
std::vector<RawPart> parts_of(const aiScene& scene, const DesignFile& file, std::size_t& dropped) {
  std::vector<RawPart> parts;
  std::vector<const aiNode*> open{scene.mRootNode};
  while (!open.empty()) {
    const aiNode& node = *open.back();
    open.pop_back();
    for (unsigned c = node.mNumChildren; c > 0; --c) open.push_back(node.mChildren[c - 1]);
    RawPart part;
    for (unsigned m = 0; m < node.mNumMeshes; ++m) {
      merge(part, to_part(*scene.mMeshes[node.mMeshes[m]], dropped));
    }
    if (part.triangles.empty()) continue;
    part.part.name = node.mName.C_Str();
    // Assimp's own names for what had none: "<STL_BINARY>", "defaultobject".
    const bool is_made_up = part.part.name.empty() || part.part.name.front() == '<' ||
                            part.part.name == "defaultobject" || &node == scene.mRootNode;
    if (is_made_up) part.part.name.clear();
    parts.push_back(std::move(part));
  }
  const std::string stem = file.path.stem().string();
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (!parts[i].part.name.empty()) continue;
    parts[i].part.name = parts.size() == 1 ? stem : "part_" + std::to_string(i + 1);
  }
  return parts;
}

// Corners that lie on one another become one vertex (STL writes each three times). Metres.
void weld(RawPart& raw) {
  std::vector<Eigen::Vector3f> rounded(raw.vertices.size());
  std::transform(raw.vertices.begin(), raw.vertices.end(), rounded.begin(),
                 [](const Eigen::Vector3d& v) { return v.cast<float>(); });
  const std::vector<std::uint32_t> first = weld_vertices(rounded, welding_tolerance(rounded));
  for (Triangle& triangle : raw.triangles) {
    for (std::uint32_t& vertex : triangle) vertex = first[vertex];
  }
}

// A binary STL whose triangle count disagrees with its size is cut short or has been tampered with.
Status check_stl(const DesignFile& file) {
  const std::string_view bytes = file.bytes;
  const bool is_text = bytes.substr(0, 5) == "solid" &&
                       bytes.substr(0, 4096).find("facet") != std::string_view::npos;
  if (is_text) return {};
  if (bytes.substr(0, 5) == "solid" && bytes.find("endsolid") != std::string_view::npos) {
    return bad(file, "has no surface: its solid has no facet");
  }
  if (bytes.size() < 84) return bad(file, "is cut short: it holds no STL header");
  std::uint64_t count = 0;
  for (std::size_t i = 4; i-- > 0;)
    count = (count << 8U) | static_cast<unsigned char>(bytes[80 + i]);
  if (84 + 50 * count > bytes.size()) {
    return bad(file, "is cut short: its header says " + std::to_string(count) +
                         " triangles, the file holds " + std::to_string((bytes.size() - 84) / 50));
  }
  return {};
}

std::string lower_ending(const DesignFile& file) {
  std::string ending = file.path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](char c) {
    return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  });
  return ending;
}

// Assimp keeps coordinates as float: far from the origin a file's own digits are already lost.
void warn_of_rounding(const Eigen::AlignedBox3d& bounds_m, std::vector<std::string>& warnings) {
  const double furthest = bounds_m.min().cwiseAbs().cwiseMax(bounds_m.max().cwiseAbs()).maxCoeff();
  const double step = furthest * static_cast<double>(std::numeric_limits<float>::epsilon());
  if (step < 2e-5) return;
  warnings.push_back("the design lies " + std::to_string(std::lround(furthest)) +
                     " m from its origin, where mesh files are rounded to " +
                     std::to_string(step * 1e3) + " mm; export it near its origin");
}

}  // namespace

Result<DesignModel> read_mesh_design(const DesignFile& file) {
  const std::string ending = lower_ending(file);
  if (ending == ".stl") {
    if (Status checked = check_stl(file); !checked) return checked.error();
  }
  Assimp::Importer importer;
  importer.SetIOHandler(new NoFiles);  // the importer deletes it
  constexpr unsigned kAsParsed = 0;    // no step after parsing
  const aiScene* scene = importer.ReadFileFromMemory(file.bytes.data(), file.bytes.size(),
                                                     kAsParsed, ending.c_str() + 1);
  if (scene == nullptr || scene->mRootNode == nullptr) {
    return bad(file, std::string("cannot be read as a mesh: ") + importer.GetErrorString());
  }
  std::size_t dropped = 0;
  std::vector<RawPart> parts = parts_of(*scene, file, dropped);
  Eigen::AlignedBox3d bounds;  // file units
  for (RawPart& part : parts) {
    for (const Triangle& triangle : part.triangles) {
      for (const std::uint32_t vertex : triangle) bounds.extend(part.vertices[vertex]);
    }
  }
  if (bounds.isEmpty()) return bad(file, "has no surface: it holds no triangle");
  DesignModel design;
  design.path = file.path.string();
  if (dropped > 0) {
    design.warnings.push_back("faces without three finite corners are left out: " +
                              std::to_string(dropped));
  }
  if (file.unit) {
    design.unit = *file.unit;
  } else {
    const Result<LengthUnit> unit = guess_unit(file.path, bounds);
    if (!unit) return unit.error();
    design.unit = *unit;
    design.unit_inferred = true;
    design.warnings.push_back("the file does not say its unit: by its size it is taken as " +
                              size_text(bounds, design.unit) + "; confirm it by --design-unit");
  }
  const double unit_m = metres(design.unit);
  for (RawPart& part : parts) {
    for (Eigen::Vector3d& vertex : part.vertices) vertex *= unit_m;
    weld(part);
  }
  warn_of_rounding({unit_m * bounds.min(), unit_m * bounds.max()}, design.warnings);
  if (Status built = build_mesh(std::move(parts), design); !built) return built.error();
  return design;
}

}  // namespace spool
