// A design as a .glb file: one node a part, semantics in extras.spoolsight (ARCHITECTURE, Files).
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tools/campaign/assembly.h"
#include "vision/core/triangle_mesh.h"

namespace spool::campaign {

// The bytes of the file. The first member is the datum.
[[nodiscard]] std::string design_glb(const Assembly& assembly);

// The same surface as one mesh in the design frame (m).
[[nodiscard]] TriangleMesh design_mesh(const Assembly& assembly);

}  // namespace spool::campaign
