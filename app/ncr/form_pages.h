// The form as boxes on paper: labels, values, check boxes, rooms to write and sign in.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/ncr/fill_form.h"
#include "app/ncr/page_flow.h"

namespace spool::ncr {

// Long values make their row higher; a row that is higher than a page goes on on the next.
void lay_out_form(const NcrDocument& document, PageFlow& flow);

}  // namespace spool::ncr
