// The report as one HTML file with its pictures inside.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "app/ncr/fill_form.h"

namespace spool::ncr {

// NUMBER.html: offline, for a tablet. Every text is escaped.
[[nodiscard]] std::string ncr_html(const NcrDocument& document);

}  // namespace spool::ncr
