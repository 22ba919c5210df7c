// Parts of which nothing shows although what they are joined to does.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "vision/design/design_model.h"
#include "vision/design/sampling.h"
#include "vision/inspect/chain_pieces.h"
#include "vision/inspect/deviation.h"
#include "vision/scan/sight.h"

namespace spool {

// Where a depth image was taken from, and what it saw.
struct DesignInSight {
  Sight sight;
  Eigen::Isometry3f T_camera_design;
  float gate_m;  // so far off (m) it is the part, out of place
};

struct MissingPart {
  int part = -1;
  bool is_seen_through = false;  // by the camera; else something may hide it
};

// The scan as its deviations were measured; all outlive the call.
struct MeasuredScan {
  CloudView points;  // m, design frame
  std::span<const PointClass> classes;
  const Deviations& deviations;
  std::span<const Piece> pieces = {};  // that are elsewhere: nothing has to show where they are not
};

// Ascending. A part's own surface is looked for where nothing else of the design is near enough to
// be taken for it: the end of a pipe lies on the hub of the flange that is not there. Of a depth
// image (`in_sight`; of no other scan) a part is missing where the camera saw through it. Of
// any other nobody knows what the scanner looked at: there a part is missing where it does not show
// although what it is joined to does and all else of the spool shows from end to end. Where
// something else has a gap, the scan is incomplete, and the part may be in the gap. A stand that
// reaches its place is not the part. `parts`: summarise_parts() of the same. None of a cancelled
// run.
[[nodiscard]] std::vector<MissingPart> missing_parts(
    const DesignModel& design, const MeasuredScan& scan, const SurfaceSamples& samples,
    const std::vector<PartDeviation>& parts,
    const std::optional<DesignInSight>& in_sight = std::nullopt, const Watch& watch = {});

}  // namespace spool
