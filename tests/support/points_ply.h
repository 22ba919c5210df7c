// points.ply of an inspection, read by code that shares nothing with its writer.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

namespace spool::test {

// A row as ARCHITECTURE, What inspect writes orders it.
struct PointsRow {
  std::array<float, 3> position = {};  // m
  std::uint8_t object = 0;
  std::int32_t part = -1;
  float deviation = 0;  // m
};

// All rows; nothing where the header is not exactly the published one or the length does not fit
// it.
[[nodiscard]] std::optional<std::vector<PointsRow>> read_points_ply(
    const std::filesystem::path& path);

}  // namespace spool::test
