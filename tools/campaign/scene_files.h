// A scene as files: cloud.ply, sensor.json, design/model.glb and truth/.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "tools/campaign/scene.h"
#include "vision/core/result.h"

namespace spool::campaign {

// Makes the folder. truth/labels.bin holds a little-endian uint16 a point; truth/truth.json the
// pose, defects and each part's error; truth/pose.json what --pose of spoolsight-inspect takes.
[[nodiscard]] Status write_scene(const Scene& scene, const std::filesystem::path& folder);

}  // namespace spool::campaign
