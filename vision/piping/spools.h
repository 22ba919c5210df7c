// Numbers of welds and the spools that they make.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "vision/core/result.h"
#include "vision/piping/pipework.h"

namespace spool::piping {

// Gives every welded joint its number and place: its WELD record's, else made up ("W3?", the mark
// of doubt is part of the number) and shop, or site where it joins what goes up on site or two
// spools. Then spools: what SPOOL-IDENTIFIER says, else what shop welds hold together, named by the
// file's prefix and flagged. Problems: numbers given twice, welds that do not say shop or site.
void name_welds_and_spools(Pipework& pipework);

// One spool of a pipework as pipework of its own: its components, the joints and welds between
// them, its problems. kBadInput names the spools that there are.
[[nodiscard]] Result<Pipework> only_spool(const Pipework& pipework, const std::string& spool);

}  // namespace spool::piping
