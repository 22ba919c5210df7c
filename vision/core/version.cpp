// Which build this is; the numbers come from CMake.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/core/version.h"

namespace spool {

std::string_view version() { return SPOOL_VERSION; }
std::string_view commit() { return SPOOL_COMMIT; }

}  // namespace spool
