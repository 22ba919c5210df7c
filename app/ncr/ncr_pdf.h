// The report as PDF: the form's page, then pages of evidence.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "app/isometric/page_canvas.h"
#include "app/ncr/fill_form.h"

namespace spool::ncr {

// A4: the form; findings and pictures with their captions; the table of features, its head on every
// page; decision rule; what all was made from. `document` may go before the pages do. One thread.
[[nodiscard]] isometric::Pages ncr_pages(const NcrDocument& document);

// The bytes of NUMBER.pdf; equal documents are equal files. kInternal where cairo fails.
[[nodiscard]] Result<std::string> ncr_pdf(const NcrDocument& document);

}  // namespace spool::ncr
