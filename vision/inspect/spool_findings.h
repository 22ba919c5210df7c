// What is wrong with the spool as a whole: parts elsewhere, of the wrong length, missing.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "vision/design/design_model.h"
#include "vision/inspect/inspection.h"
#include "vision/inspect/missing_parts.h"

namespace spool {

// A finding for every piece that is elsewhere (misplaced, wrong_size), for what should not be there
// (unexpected), and for every part of which
// nothing shows although all round it does (missing_parts()), unless it is of such a piece.
// `parts`: as judged, in the design's order.
[[nodiscard]] std::vector<Finding> spool_findings(const DesignModel& design,
                                                  const std::vector<Piece>& pieces,
                                                  const std::vector<Unexpected>& unexpected,
                                                  const std::vector<MissingPart>& missing,
                                                  const std::vector<PartFinding>& parts);

// A part that the evidence shows in another place than the design's is not ok, whatever its
// features; what hangs on it moved with it.
void judge_pieces(const DesignModel& design, const std::vector<Piece>& pieces,
                  std::vector<PartFinding>& parts);

// Of a part that was not measured, why. That it was seen through is more than that it was not seen.
void judge_missing(const DesignModel& design, const std::vector<MissingPart>& missing,
                   std::vector<PartFinding>& parts);

// What a part carries that the design does not have is to be looked at, whatever its features.
void judge_unexpected(const DesignModel& design, const std::vector<Unexpected>& unexpected,
                      std::vector<PartFinding>& parts);

}  // namespace spool
