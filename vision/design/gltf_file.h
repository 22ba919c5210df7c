// A glTF or GLB file through tinygltf, with the checks that the library leaves to its callers.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "vision/core/result.h"
#include "vision/design/readers.h"

namespace tinygltf {
class Model;
}

namespace spool {

struct GltfDelete {
  void operator()(tinygltf::Model* model) const;
};
using GltfModel = std::unique_ptr<tinygltf::Model, GltfDelete>;

// Parses the file. Checked before the library sees it: GLB chunk sizes, JSON nesting. Checked
// after: every buffer view lies in its buffer, no required extension is unknown. Opens no file
// outside the design's own folder, fetches nothing, decodes no image. Accessors, meshes and nodes
// are still unchecked.
[[nodiscard]] Result<GltfModel> load_gltf(const DesignFile& file);

}  // namespace spool
