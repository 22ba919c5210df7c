// Joints, bumps and fit-up in the reports: as JSON, in fitter's words, as HTML.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "app/common/length_text.h"
#include "vision/design/design_model.h"
#include "vision/inspect/joint_error.h"

namespace spool::evidence {

// As assets/report.schema.json has them.
[[nodiscard]] nlohmann::json joints_json(const ChainResult& chain);
[[nodiscard]] nlohmann::json joints_not_measured_json(const ChainResult& chain);
[[nodiscard]] nlohmann::json chain_json(const ChainResult& chain);
[[nodiscard]] nlohmann::json bumps_json(const DesignModel& design, const ChainResult& chain);
[[nodiscard]] nlohmann::json fit_up_json(const ChainResult& chain);

// "Turn elbow_2 1.0° clockwise seen from pipe_2 = 11.9 mm at flange_b/face." Directions are the
// drawing's.
[[nodiscard]] std::string bump_text(const DesignModel& design, const Bump& bump, LengthStyle style);

// "pipe_1/out to pipe_2/in: off by 3.1 mm and 1.0°. The joint to blame. At flange_b/face 11.9 mm.",
// or why it was not measured.
[[nodiscard]] std::string joint_text(const JointError& joint, LengthStyle style);

// "1.2 mm, U (k = 2) 0.6 mm", or why it was not measured.
[[nodiscard]] std::string fit_up_text(const FitUp& fit_up, LengthStyle style);

// Empty where nothing of the kind was looked at.
[[nodiscard]] std::string joints_section(const DesignModel& design, const ChainResult& chain,
                                         LengthStyle style);

}  // namespace spool::evidence
