// A Piping Component File read as pipework.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "vision/core/result.h"
#include "vision/piping/pipework.h"

namespace spool::piping {

// Reads a whole file tolerantly: whatever can be read is, and all that is odd is a problem with its
// line. `name` opens each error's sentence; `coordinate_unit` (m) is taken over what the file says.
// Several pipelines may follow one another; units hold until said anew. Where units are missing
// they are told from the sizes of fittings and flagged as inferred. Coordinates as Pipework says.
// kBadInput: what is no such file (read_pcf_text()), without a component, all coordinates zero,
// units that nothing tells, more than 20 000 components.
[[nodiscard]] Result<Pipework> read_pcf(std::string_view bytes, const std::string& name,
                                        std::optional<double> coordinate_unit = std::nullopt);

}  // namespace spool::piping
