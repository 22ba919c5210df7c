// The pieces of known size on a spool that a scan measured, for the check of the sensor's scale.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "vision/core/cancel.h"
#include "vision/design/design_model.h"
#include "vision/inspect/sensor_evidence.h"
#include "vision/measure/part_feature.h"

namespace spool {

// Outside diameters of pipes (their fits with the radius freed: where it is held by the catalogue
// it says nothing of the scale), known to ASTM A999, and of flanges by their rims, known to ASME
// B16.5. Ranges are from `scan.eye` where there is one. Metres, design frame.
[[nodiscard]] std::vector<Gauge> gauges_of(const DesignModel& design, const FeatureScan& scan,
                                           const PartFeatures& features, const Watch& watch = {});

}  // namespace spool
