// A design as a GLB file with the semantics of extras.spoolsight (ARCHITECTURE, Files).
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "vision/core/result.h"
#include "vision/design/design_model.h"

namespace spool {

// The bytes of a GLB: metres, one node a part in its own frame, under one node that carries the
// design's origin, so that places far out lose nothing; what read_design() reads back is the same
// design. kBadInput for a design without triangles; kInternal where the library refuses.
[[nodiscard]] Result<std::string> write_gltf(const DesignModel& design);

}  // namespace spool
