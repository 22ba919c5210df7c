// One spool as a shop builds it, scanned and inspected: each dimension that was stated beside its
// truth.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tools/campaign/scene.h"
#include "vision/core/result.h"
#include "vision/inspect/dimension.h"
#include "vision/inspect/sensor_evidence.h"

namespace spool::campaign {

struct DimensionRow {
  std::string name;
  SceneRequest request;
  double scale_u = 0.0005;               // stated; the sensor's own scale is drawn from it
  std::optional<double> stated_scale_u;  // in its place, where the calibration is wrong
  double warp_u_m = 0;                   // stated
  bool single_frame = false;             // one depth image in place of a cloud
  double scale_error = 0;    // besides what is drawn from scale_u: what the calibration denies
  double corner_warp_m = 0;  // of the depth image, in its corners at its median depth
};
[[nodiscard]] std::vector<DimensionRow> dimension_rows();

struct TriedDimension {
  Dimension stated;
  std::optional<double> truth;  // of the deviation (m, rad); nothing where it is not defined here
  double nps = 0;               // of the part that it is of; 0: of several
};

struct TriedSpool {
  std::vector<TriedDimension> dimensions;
  std::vector<std::string> wrong_parts;  // that were called not_ok
  std::vector<Defect> defects;
  std::optional<ScaleCheck> scale;
  std::optional<WarpCheck> warp;
  double largest_nps = 0;  // of its pipes
  int flanges = 0;
  double true_scale = 1;
  Verdict status = Verdict::kNotMeasured;
};

// The pose is given, true at the first part; measured and truth share no code but the names.
[[nodiscard]] Result<TriedSpool> run_dimensions(const DimensionRow& row, std::uint32_t seed);

}  // namespace spool::campaign
