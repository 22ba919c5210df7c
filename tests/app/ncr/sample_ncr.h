// A non-conformance report made by hand: the orifice flange whose tap points the wrong way.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "app/ncr/fill_form.h"

namespace spool::test {

// A text that every format has to mask: tags, quotes, an ampersand, accents, a line end.
inline const std::string kAwkward = "é <b>\"A&B\" 'ø' ]]> ½ ß\nsecond line";

// `features` dimensions of 80 letters' names, one of them an angle, every status; two pictures;
// every field that may be filled in is.
[[nodiscard]] ncr::NcrDocument sample_ncr(int features = 4);

// The value that sample_ncr() gives a field.
[[nodiscard]] std::string sample_value(const ncr::FormField& field);

// Files of an inspection: report.json of `design_sha256` with a dimension, an angle and a size, two
// pictures and report.html with their captions.
void write_report(const std::filesystem::path& folder, const std::string& design_sha256);

}  // namespace spool::test
