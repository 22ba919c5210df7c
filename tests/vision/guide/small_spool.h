// A spool of eight parts written down by hand: ports and joints, no surface.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "vision/design/design_model.h"

namespace spool::test {

// Along x: flange_1, pipe_1 (0.4 m), tee_1, pipe_2 (0.9 m), flange_2; up from the tee: pipe_3
// (0.3 m), elbow_1, pipe_4 (0.2 m). NPS 4, the pipes end to end. Welds W1 to W7, all shop. No
// datum.
[[nodiscard]] DesignModel small_spool();

[[nodiscard]] int part_named(const DesignModel& design, const std::string& name);
[[nodiscard]] std::vector<std::string> names_of(const DesignModel& design,
                                                const std::vector<int>& order);

}  // namespace spool::test
