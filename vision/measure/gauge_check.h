// The sensor's scale from pieces of known size: s(z) = 1 + a + b z by weighted least squares.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include "vision/inspect/sensor_evidence.h"

namespace spool {

struct GaugeCheckOptions {
  double scale_u = 0.005;     // of the calibration, a fraction
  double false_alarm = 0.01;  // of sensors that are as calibrated, this share is contradicted
};

// Of gauges that are of the size drawn (one further off than 4 % and its own doubt is another
// piece): the scale by generalised least squares, gauges of one kind sharing what they share. The
// calibration's `scale_u` is the prior: half of its variance is a scale (base line, focal length),
// half grows with range (an offset of the disparity). Where the gauges scatter beyond what chance
// does once in twenty, their doubt grows by Birge's ratio.
//
// The calibration is contradicted where the scale at the gauges' mean range, or its slope, differs
// from one by more than both doubts together explain, at `false_alarm` in all (Bonferroni), and at
// least two gauges of different parts say so. A correction is made only where the gauges alone
// differ from one beyond chance at the same level and do not contradict the calibration; else what
// they found is part of `scale_u`. Nothing where there is no gauge.
[[nodiscard]] std::optional<ScaleCheck> check_scale(std::span<const Gauge> gauges,
                                                    const GaugeCheckOptions& options = {});

}  // namespace spool
