// What the dimensions and sizes that were measured say of the parts.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "vision/design/design_model.h"
#include "vision/inspect/inspection.h"
#include "vision/measure/part_feature.h"

namespace spool {

// Adds to each pipe's finding the check of its outside diameter: is it of this nominal size at all.
// `nothing_ok`: see DimensionOptions.
void check_sizes(const DesignModel& design, const PartFeatures& features,
                 const std::string& nothing_ok, std::vector<PartFinding>& parts);

// A part that answers for a dimension or size that is not_ok is not_ok, with a finding; one that
// was seen and is not_ok for no other reason gets the worst of the dimensions that it lies in, but
// where such a dimension is not_ok and another part answers for it, suspicious: nobody can say then
// how much of it is whose.
void judge_dimensions(const DesignModel& design, const std::vector<Dimension>& dimensions,
                      std::vector<PartFinding>& parts, std::vector<Finding>& findings);

}  // namespace spool
