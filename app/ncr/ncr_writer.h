// All files of a non-conformance report.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "app/ncr/fill_form.h"
#include "app/ncr/ncr_register.h"

namespace spool::ncr {

// NUMBER.pdf, .html, .json and .bcfzip of a document that is given this number; for issue_ncr().
// kInternal where cairo or libzip fails. One thread.
[[nodiscard]] Result<std::vector<NcrFile>> ncr_files(NcrDocument document,
                                                     const std::string& number);

}  // namespace spool::ncr
