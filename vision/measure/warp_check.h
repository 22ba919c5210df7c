// Planes in one depth image against what the sensor's calibration says of its warp.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include <Eigen/Core>

#include "vision/core/cancel.h"
#include "vision/inspect/sensor_evidence.h"
#include "vision/scan/noise_model.h"

namespace spool {

struct WarpCheckOptions {
  double warp_u_m = 0;    // of the calibration, at the picture's corners
  double correlated = 1;  // readings that are worth one
  // Planes of that length and half as wide are floor, wall, table top or plate: a third of the
  // picture at a metre, so that their bend shows.
  double size_m = 0.5;
  std::uint32_t seed = 1;
};

// `points`: readings of one frame, m, camera frame, NaN allowed. Floor, walls and table tops are
// looked for, and the squares of DepthWarp fitted to all of them together, each plane with its own
// place and tilt. The calibration is contradicted where the three together differ from nothing
// beyond their uncertainty, what the calibration leaves, and what floors are off being flat, once
// in 100 honest sensors (chi-square of three degrees over 11.34). Nothing where no plane covers
// enough of the picture.
[[nodiscard]] std::optional<WarpCheck> check_warp(std::span<const Eigen::Vector3f> points,
                                                  const NoiseModel& noise,
                                                  const WarpCheckOptions& options,
                                                  const Watch& watch = {});

}  // namespace spool
