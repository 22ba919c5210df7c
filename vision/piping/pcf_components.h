// From a record of a Piping Component File to a component, still in the file's units.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "vision/piping/pcf_records.h"

namespace spool::piping {

// Reads a record that is a component, or an unknown one with END-POINTs. Positions and bend radius
// stay in file units, bores in PipePoint::nps as written. What cannot be read is left out with a
// problem at its line.
[[nodiscard]] Component read_component(const PcfRecord& record, std::vector<Problem>& problems);

}  // namespace spool::piping
