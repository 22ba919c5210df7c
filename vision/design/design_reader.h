// A design from any file it may be in: glTF, a mesh file or a bare cloud.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>

#include "vision/core/length_unit.h"
#include "vision/core/result.h"
#include "vision/design/design_model.h"

namespace spool {

// Reads .glb/.gltf (metres, ARCHITECTURE, Files), .pcf piping files, .stl/.obj/.ply meshes (assimp;
// unit given or inferred with a warning), .ply/.pcd/.xyz/.txt clouds. kBadInput with one sentence
// for anything missing, empty, cut short, hostile, without a surface, or in a unit that cannot be
// told.
[[nodiscard]] Result<DesignModel> read_design(const std::filesystem::path& path,
                                              std::optional<LengthUnit> unit = std::nullopt);

}  // namespace spool
