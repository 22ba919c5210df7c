// The report as JSON for other programs.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "app/ncr/fill_form.h"

namespace spool::ncr {

// NUMBER.json, schema spoolsight-ncr/1 (assets/ncr.schema.json). Lengths m, angles rad; a field
// that is to be filled in is null.
[[nodiscard]] std::string ncr_json(const NcrDocument& document);

}  // namespace spool::ncr
