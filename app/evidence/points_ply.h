// points.ply: every point of the scan in the design file's frame, with what it was taken for.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "app/evidence/inspection_record.h"
#include "vision/core/result.h"

namespace spool::evidence {

// x y z (m, the design file's own frame; NaN stays NaN), object (0 clutter, 1 object, 2
// contradicting), part
// (-1 for clutter), deviation (m; NaN for clutter); one row an input point, in input order. kIo
// names the file.
// Where no pose was found the points stand in the scan file's frame, all clutter.
[[nodiscard]] Status write_points(const std::filesystem::path& path,
                                  const InspectionRecord& record);

}  // namespace spool::evidence
