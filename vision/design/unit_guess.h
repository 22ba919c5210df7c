// Which unit a file without one is in, judged by the size of what it holds.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include <Eigen/Geometry>

#include "vision/core/length_unit.h"
#include "vision/core/result.h"

namespace spool {

// The unit in which a design of these bounds (file units) has the size of pipework, 15 mm to 15 m
// at its longest side. Numbers from 15 to 15 000 are millimetres, as nearly every exporter writes;
// below 15 they are metres, and inches are possible only where millimetres are not, from 0.6 up:
// there, between metres and inches, and outside all of them, nobody can tell and kBadInput asks for
// --design-unit.
[[nodiscard]] Result<LengthUnit> guess_unit(const std::filesystem::path& path,
                                            const Eigen::AlignedBox3d& bounds);

// "203.2 x 304.8 x 12.7 mm", for warnings.
[[nodiscard]] std::string size_text(const Eigen::AlignedBox3d& bounds, LengthUnit unit);

}  // namespace spool
