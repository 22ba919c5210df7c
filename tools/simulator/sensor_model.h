// From what is there to what a structured-light sensor says is there (ARCHITECTURE, The sensor).
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tools/simulator/caster.h"
#include "tools/simulator/noise_field.h"
#include "tools/simulator/scene.h"
#include "vision/core/depth_frame.h"

namespace spool::simulator {

// Metres between two depths that differ by one step of disparity (1/8 px): z^2 / (8 f b).
[[nodiscard]] double quantisation_step_m(const SensorSettings& sensor, double z_m);

// Total standard deviation along the axis (m), quantisation included, by range and incidence:
// Nguyen, Izadi & Lovell 2012, the third term held at its value for 80 degrees beyond that.
[[nodiscard]] double axial_sigma_m(double z_m, double incidence_rad);

// The counts of frame `index`; the same for the same image, settings and index. In this order:
// edges move outwards by 1 to 2 px with the lateral jitter, systematic errors, axial noise
// correlated over 7 x 7 pixels, disparity rounded to 1/8 px, projector shadow, dropout at grazing
// angles and on bright metal, range limits, rounding to counts. Without `noise` only systematic
// errors, limits and rounding.
//
// The projector stands at -baseline on the camera's x axis: shadows fall on the right of
// silhouettes. Occluders that the camera does not see itself cast none.
//
// `noise` is memory, kept from one frame to the next.
void sense(const SensorSettings& sensor, const IdealImage& image, std::int64_t index,
           NoiseField& noise, DepthFrame& frame);

}  // namespace spool::simulator
