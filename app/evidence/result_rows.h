// Everything that an inspection found as one list, the worst first.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "vision/design/design_model.h"
#include "vision/inspect/inspection.h"

namespace spool::evidence {

// In the order in which those that are as bad are read.
enum class ResultKind : std::uint8_t { kFinding, kDimension, kJoint, kPart, kFitUp };

struct ResultRow {
  ResultKind kind = ResultKind::kPart;
  std::size_t index = 0;  // into the inspection's findings, dimensions, joints, parts or fit-ups
  Verdict status = Verdict::kNotMeasured;
  double against_limit = 0;          // how far it is off over what is allowed; 0: there is no such
  std::array<int, 2> parts{-1, -1};  // of the design, to be lit: one, or both sides of a joint
};

// One row a part, dimension, joint and fit-up, and one a finding that no dimension tells already
// (gross errors: what is missing, too many, elsewhere, of another size). By status, then by how far
// off against the limit. A finding has its part's status; a joint that of joint_verdict(); a part
// is as far off as the worst dimension that it is judged by. A fit-up that was measured is
// suspicious: what is allowed stands in a weld procedure, which nobody has told.
[[nodiscard]] std::vector<ResultRow> result_rows(const DesignModel& design,
                                                 const Inspection& inspection);

// The first row that lights the part; nothing where there is none.
[[nodiscard]] std::optional<std::size_t> worst_row_of(const std::vector<ResultRow>& rows, int part);

// The row whose number decides: of the rows that `step_part` (-1: any) has to do with those of the
// worst status, and of these the first dimension, else the first. Nothing where there is none.
[[nodiscard]] std::optional<std::size_t> deciding_row(const std::vector<ResultRow>& rows,
                                                      const Inspection& inspection, int step_part);

}  // namespace spool::evidence
