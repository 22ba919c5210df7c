// Where each part stands, in the reports.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "app/common/length_text.h"
#include "vision/inspect/part_pose.h"

namespace spool::evidence {

// As assets/report.schema.json has pose_error: null where nothing is known.
[[nodiscard]] nlohmann::json pose_error_json(const PartPose& pose);

// " It stands 4.1 mm and 1.2° off the drawing (…). Not observed: a turn about its axis." Empty of a
// part that is not off by more than chance.
[[nodiscard]] std::string pose_words(const PartPose& pose, LengthStyle style);

}  // namespace spool::evidence
