// The records of a Piping Component File: an opening keyword and the attributes that follow it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "vision/piping/pcf_keywords.h"
#include "vision/piping/pcf_text.h"

namespace spool::piping {

struct PcfAttribute {
  int line = 0;
  std::string keyword, value;  // one spelling of the keyword: canonical()
};

struct PcfRecord {
  int line = 0;
  KeywordRole role = KeywordRole::kUnknown;
  std::string keyword, value;
  std::vector<PcfAttribute> attributes;  // in order, repeats kept
  std::string raw;                       // its lines as written

  // The first attribute of that keyword, "" where there is none.
  [[nodiscard]] std::string_view attribute(std::string_view key) const;
  [[nodiscard]] bool has(std::string_view key) const;
};

// Groups lines into records. At the file's own margin a line opens a record, deeper ones are its
// attributes; attribute keywords are attributes at any indentation, and bare component keywords
// open a record at any. Where attributes stand at the margin (writers that do not indent), an
// unknown word with a value is an attribute. Adds a problem for each unknown record keyword.
[[nodiscard]] std::vector<PcfRecord> group_records(const std::vector<PcfLine>& lines,
                                                   std::vector<Problem>& problems);

}  // namespace spool::piping
