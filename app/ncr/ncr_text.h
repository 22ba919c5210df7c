// The report's evidence in words and cells, the same in PDF and HTML.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/ncr/fill_form.h"

namespace spool::ncr {

inline constexpr std::string_view kToFillIn = "to be filled in";

// Name of a fact and what it is; facts that nobody said are "not said", never left out.
using Fact = std::pair<std::string, std::string>;
[[nodiscard]] std::vector<Fact> spool_facts(const NcrDocument& document);   // what was measured
[[nodiscard]] std::vector<Fact> source_facts(const NcrDocument& document);  // out of what, by whom

// Heads and cells of the table of features: name, drawing, measured, off by, U (k), tolerance,
// clause, probability, status.
inline constexpr std::size_t kFeatureColumns = 9;
using FeatureCells = std::array<std::string, kFeatureColumns>;
[[nodiscard]] FeatureCells feature_heads(const NcrDocument& document);
[[nodiscard]] FeatureCells feature_cells(const Feature& feature, LengthStyle style);

// "missing, pipe-1: …" of a finding.
[[nodiscard]] std::string finding_text(const Finding& finding);

// "overlay_1.png: seen from +x"
[[nodiscard]] std::string picture_text(const Picture& picture);

}  // namespace spool::ncr
