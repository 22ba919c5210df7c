// The triangles of one glTF mesh, whichever way its primitives spell them (glTF 2.0, 3.7.2.1).
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/design/gltf_mesh.h"

#include <numeric>
#include <utility>

#include <tiny_gltf.h>

#include "vision/design/gltf_accessor.h"

namespace spool {
namespace {

bool has_triangles(int mode) {
  return mode == TINYGLTF_MODE_TRIANGLES || mode == TINYGLTF_MODE_TRIANGLE_STRIP ||
         mode == TINYGLTF_MODE_TRIANGLE_FAN;
}

// Appends the triangles of a run of vertex numbers; those that name a vertex twice join strips and
// have no area by intent.
void append(int mode, const std::vector<std::uint32_t>& run, std::uint32_t first,
            std::vector<Triangle>& out) {
  const std::size_t step = mode == TINYGLTF_MODE_TRIANGLES ? 3 : 1;
  for (std::size_t i = 0; i + 2 < run.size(); i += step) {
    Triangle triangle{run[i], run[i + 1], run[i + 2]};
    if (mode == TINYGLTF_MODE_TRIANGLE_FAN) triangle = {run[i + 1], run[i + 2], run[0]};
    if (mode == TINYGLTF_MODE_TRIANGLE_STRIP && i % 2 == 1) std::swap(triangle[1], triangle[2]);
    if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0]) {
      continue;
    }
    for (std::uint32_t& vertex : triangle) vertex += first;
    out.push_back(triangle);
  }
}

// Drops vertices that no triangle uses, so that what every instance copies is bounded by its
// triangles.
void keep_used_vertices(GltfMesh& mesh) {
  constexpr std::uint32_t kUnused = 0xFFFFFFFFU;
  std::vector<std::uint32_t> place(mesh.vertices.size(), kUnused);
  std::vector<Eigen::Vector3d> kept;
  for (Triangle& triangle : mesh.triangles) {
    for (std::uint32_t& vertex : triangle) {
      if (place[vertex] == kUnused) {
        place[vertex] = static_cast<std::uint32_t>(kept.size());
        kept.push_back(mesh.vertices[vertex]);
      }
      vertex = place[vertex];
    }
  }
  mesh.vertices = std::move(kept);
}

}  // namespace

Result<GltfMesh> read_gltf_mesh(const tinygltf::Model& model, std::size_t mesh) {
  const std::string name = "mesh " + std::to_string(mesh);
  GltfMesh out;
  for (const tinygltf::Primitive& primitive : model.meshes[mesh].primitives) {
    const int mode = primitive.mode == -1 ? TINYGLTF_MODE_TRIANGLES : primitive.mode;
    if (mode < TINYGLTF_MODE_POINTS || mode > TINYGLTF_MODE_TRIANGLE_FAN) {
      return Error{ErrorCode::kBadInput, name + " has a primitive of an unknown mode"};
    }
    const auto position = primitive.attributes.find("POSITION");
    if (!has_triangles(mode) || position == primitive.attributes.end()) {
      ++out.skipped_primitives;
      continue;
    }
    Result<std::vector<Eigen::Vector3d>> points = read_gltf_points(model, position->second);
    if (!points) return Error{ErrorCode::kBadInput, name + ": " + points.error().message};
    std::vector<std::uint32_t> run;
    if (primitive.indices >= 0) {
      Result<std::vector<std::uint32_t>> indices =
          read_gltf_indices(model, primitive.indices, points->size());
      if (!indices) return Error{ErrorCode::kBadInput, name + ": " + indices.error().message};
      run = std::move(*indices);
    } else {
      run.resize(points->size());
      std::iota(run.begin(), run.end(), 0U);
    }
    if (mode == TINYGLTF_MODE_TRIANGLES && run.size() % 3 != 0) {
      return Error{ErrorCode::kBadInput, name + " has a number of corners that makes no triangles"};
    }
    if (out.vertices.size() + points->size() > 3 * kMaxDesignTriangles) {
      return Error{ErrorCode::kBadInput,
                   name + " has more vertices than are read; export it coarser"};
    }
    append(mode, run, static_cast<std::uint32_t>(out.vertices.size()), out.triangles);
    out.vertices.insert(out.vertices.end(), points->begin(), points->end());
  }
  keep_used_vertices(out);
  return out;
}

}  // namespace spool
