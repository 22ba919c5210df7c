// The readers behind read_design(): one function a format.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "vision/design/design_reader.h"

namespace spool {

// A file that is read: its place, its bytes and what was said of its unit.
struct DesignFile {
  std::filesystem::path path;
  std::string bytes;
  std::optional<LengthUnit> unit;
};

// Each gives a whole design except for path and sha256, which read_design() sets before and checks
// after; kBadInput with one sentence as read_design() promises. May throw what its library throws.
[[nodiscard]] Result<DesignModel> read_gltf_design(const DesignFile& file);
[[nodiscard]] Result<DesignModel> read_mesh_design(const DesignFile& file);
[[nodiscard]] Result<DesignModel> read_cloud_design(const DesignFile& file);
[[nodiscard]] Result<DesignModel> read_pcf_design(const DesignFile& file);
[[nodiscard]] Result<DesignModel> read_ply_design(
    const DesignFile& file);  // either of the two above

}  // namespace spool
