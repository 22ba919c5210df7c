// The triangles of one glTF mesh, whichever way its primitives spell them.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "vision/design/design_builder.h"

namespace tinygltf {
class Model;
}

namespace spool {

struct GltfMesh {
  std::vector<Eigen::Vector3d> vertices;  // file units, the mesh's own frame
  std::vector<Triangle> triangles;
  std::size_t skipped_primitives = 0;  // points and lines
};

// Triangles, strips and fans, with indices or without. Errors read on from a file's name.
[[nodiscard]] Result<GltfMesh> read_gltf_mesh(const tinygltf::Model& model, std::size_t mesh);

}  // namespace spool
