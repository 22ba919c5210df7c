// The records of a Piping Component File: an opening keyword and the attributes that follow it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/piping/pcf_records.h"

#include <algorithm>
#include <set>

namespace spool::piping {
namespace {

struct Layout {
  int margin = 0;              // the file's least indentation
  bool is_unindented = false;  // attributes stand at the margin too
};

Layout layout_of(const std::vector<PcfLine>& lines) {
  Layout layout;
  if (lines.empty()) return layout;
  layout.margin = std::min_element(lines.begin(), lines.end(), [](const auto& a, const auto& b) {
                    return a.indent < b.indent;
                  })->indent;
  layout.is_unindented = std::any_of(lines.begin(), lines.end(), [&](const PcfLine& line) {
    return line.indent == layout.margin && canonical(line.keyword) == "END-POINT";
  });
  return layout;
}

bool opens(const PcfLine& line, KeywordRole role, const Layout& layout) {
  if (role == KeywordRole::kAttribute) return false;
  if (line.indent == layout.margin)
    return role != KeywordRole::kUnknown || !layout.is_unindented || line.value.empty();
  return role == KeywordRole::kComponent && line.value.empty();
}

}  // namespace

std::string_view PcfRecord::attribute(std::string_view key) const {
  for (const PcfAttribute& each : attributes) {
    if (each.keyword == key) return each.value;
  }
  return {};
}

bool PcfRecord::has(std::string_view key) const {
  return std::any_of(attributes.begin(), attributes.end(),
                     [&](const PcfAttribute& each) { return each.keyword == key; });
}

std::vector<PcfRecord> group_records(const std::vector<PcfLine>& lines,
                                     std::vector<Problem>& problems) {
  const Layout layout = layout_of(lines);
  std::vector<PcfRecord> records;
  std::set<std::string, std::less<>> named;
  for (const PcfLine& line : lines) {
    const std::string_view keyword = canonical(line.keyword);
    const KeywordRole role = role_of(keyword);
    if (opens(line, role, layout)) {
      if (role == KeywordRole::kUnknown && named.insert(std::string(keyword)).second)
        problems.push_back({line.number, "'" + line.keyword +
                                             "' is no keyword that is known; it is kept as text" +
                                             ", and as a rigid piece where it has two END-POINTs"});
      records.push_back({line.number, role, std::string(keyword), line.value, {}, {}});
    } else if (records.empty()) {
      problems.push_back({line.number, "'" + line.keyword + "' stands before the first record"});
      continue;
    } else {
      records.back().attributes.push_back({line.number, std::string(keyword), line.value});
    }
    records.back().raw += line.raw;
    records.back().raw += '\n';
  }
  return records;
}

}  // namespace spool::piping
