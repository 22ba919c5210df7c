// A scene's design as a file gives it: written, read again and prepared.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/campaign/scene_design.h"

#include <filesystem>
#include <string>
#include <utility>

#include <unistd.h>

#include "vision/core/file_io.h"
#include "vision/design/design_reader.h"

namespace spool::campaign {

Result<std::shared_ptr<const PreparedDesign>> prepare_design(const Scene& scene, bool to_be_found) {
  const auto file = std::filesystem::temp_directory_path() /
                    ("scene-design-" + std::to_string(getpid()) + ".glb");
  if (auto written = write_file_whole(file, scene.glb()); !written) return written.error();
  auto model = read_design(file);
  std::filesystem::remove(file);
  if (!model) return model.error();
  return PreparedDesign::prepare(std::move(*model), 1, to_be_found);
}

}  // namespace spool::campaign
