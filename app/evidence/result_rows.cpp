// Everything that an inspection found as one list, the worst first.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/evidence/result_rows.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "app/evidence/worst_first.h"
#include "vision/measure/dimension_text.h"
#include "vision/measure/joint_verdict.h"

namespace spool::evidence {
namespace {

int part_named(const DesignModel& design, std::string_view name) {
  const auto found = std::ranges::find(design.parts, name, &Part::name);
  return found == design.parts.end() ? -1 : static_cast<int>(found - design.parts.begin());
}

// The part of "part/port"; -1: none of that name ("datum").
int part_at(const DesignModel& design, std::string_view place) {
  return part_named(design, place.substr(0, place.rfind('/')));
}

bool is_told_by_a_dimension(const Finding& finding, const std::vector<Dimension>& dimensions) {
  return std::ranges::any_of(
      dimensions, [&](const Dimension& dimension) { return finding.text == told_by(dimension); });
}

ResultRow row_of(const DesignModel& design, const Dimension& dimension) {
  ResultRow row{.kind = ResultKind::kDimension,
                .status = dimension.status,
                .against_limit = against_limit(dimension)};
  if (dimension.answers >= 0) {
    row.parts = {dimension.answers, -1};
    return row;
  }
  const int from = part_at(design, dimension.from), to = part_at(design, dimension.to);
  row.parts = {to, from == to ? -1 : from};
  if (to < 0) std::swap(row.parts[0], row.parts[1]);
  return row;
}

ResultRow row_of(const DesignModel& design, const Inspection& inspection, const Finding& finding) {
  const int part = part_named(design, finding.part);
  ResultRow row{.kind = ResultKind::kFinding, .status = Verdict::kSuspicious, .parts = {part, -1}};
  for (const PartFinding& of : inspection.parts)
    if (of.part == part && of.status != Verdict::kOk) row.status = of.status;
  return row;
}

ResultRow row_of(const Inspection& inspection, const PartFinding& part) {
  ResultRow row{.kind = ResultKind::kPart,
                .status = part.status,
                .against_limit = 0,
                .parts = {part.part, -1}};
  for (const Dimension& dimension : inspection.dimensions) {
    const bool is_judged_by_it =
        part.status == Verdict::kNotOk
            ? dimension.answers == part.part && dimension.status == Verdict::kNotOk
            : std::ranges::find(dimension.parts, part.part) != dimension.parts.end();
    if (is_judged_by_it) row.against_limit = std::max(row.against_limit, against_limit(dimension));
  }
  return row;
}

}  // namespace

std::vector<ResultRow> result_rows(const DesignModel& design, const Inspection& inspection) {
  std::vector<ResultRow> rows;
  const auto add = [&](ResultRow row, std::size_t index) {
    row.index = index;
    rows.push_back(row);
  };
  for (std::size_t i = 0; i < inspection.findings.size(); ++i)
    if (!is_told_by_a_dimension(inspection.findings[i], inspection.dimensions))
      add(row_of(design, inspection, inspection.findings[i]), i);
  for (std::size_t i = 0; i < inspection.dimensions.size(); ++i)
    add(row_of(design, inspection.dimensions[i]), i);
  for (std::size_t i = 0; i < inspection.chain.joints.size(); ++i) {
    const JointError& joint = inspection.chain.joints[i];
    add({.kind = ResultKind::kJoint,
         .status = joint_verdict(joint, inspection.dimensions),
         .against_limit = joint.is_measured ? joint.against_tolerance : 0,
         .parts = {joint.part_near, joint.part_far}},
        i);
  }
  for (std::size_t i = 0; i < inspection.parts.size(); ++i)
    add(row_of(inspection, inspection.parts[i]), i);
  for (std::size_t i = 0; i < inspection.chain.fit_ups.size(); ++i) {
    const FitUp& fit_up = inspection.chain.fit_ups[i];
    add({.kind = ResultKind::kFitUp,
         .status = fit_up.is_measured ? Verdict::kSuspicious : Verdict::kNotMeasured,
         .parts = {part_named(design, fit_up.a), part_named(design, fit_up.b)}},
        i);
  }
  std::stable_sort(rows.begin(), rows.end(), [](const ResultRow& a, const ResultRow& b) {
    return is_worse(a.status, a.against_limit, b.status, b.against_limit);
  });
  return rows;
}

std::optional<std::size_t> worst_row_of(const std::vector<ResultRow>& rows, int part) {
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (part >= 0 && (rows[i].parts[0] == part || rows[i].parts[1] == part)) return i;
  return std::nullopt;
}

std::optional<std::size_t> deciding_row(const std::vector<ResultRow>& rows,
                                        const Inspection& inspection, int step_part) {
  const auto is_asked_for = [&](const ResultRow& row) {
    if (step_part < 0 || row.parts[0] == step_part || row.parts[1] == step_part) return true;
    if (row.kind != ResultKind::kDimension) return false;
    const std::vector<int>& parts = inspection.dimensions[row.index].parts;
    return std::ranges::find(parts, step_part) != parts.end();
  };
  std::optional<std::size_t> first;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!is_asked_for(rows[i])) continue;
    if (!first) first = i;
    if (rows[i].status != rows[*first].status) break;
    if (rows[i].kind == ResultKind::kDimension) return i;
  }
  return first;
}

}  // namespace spool::evidence
