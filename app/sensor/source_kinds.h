// How each kind of source is opened: what source_table.cpp lists; a new kind adds a line here.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "app/sensor/depth_source.h"

namespace spool::sensor {

using OpenedSource = Result<std::unique_ptr<DepthSource>>;

// A folder with camera.json and depth/*.png (ARCHITECTURE, Files).
[[nodiscard]] OpenedSource open_depth_folder(const std::string& path, const SourceOptions& options);

// A camera of OpenNI2's: its URI, or the first camera found where `uri` is empty.
[[nodiscard]] OpenedSource open_openni_device(const std::string& uri);

// A recording of OpenNI2's, once a child process has played it to its end (oni_check.h).
[[nodiscard]] OpenedSource open_oni_file(const std::string& path, const SourceOptions& options);

// The simulated camera in `scene` (a JSON file; empty: the sample scene), through OpenNI2 and our
// plug-in.
[[nodiscard]] OpenedSource open_simulated(const std::string& scene);

}  // namespace spool::sensor
