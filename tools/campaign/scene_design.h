// A scene's design as a file gives it: written, read again and prepared.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "tools/campaign/scene.h"
#include "vision/core/result.h"
#include "vision/inspector.h"

namespace spool::campaign {

[[nodiscard]] Result<std::shared_ptr<const PreparedDesign>> prepare_design(
    const Scene& scene, bool to_be_found = false);

}  // namespace spool::campaign
