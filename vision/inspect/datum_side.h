// Of a spool that is not built as designed: the pose that its datum's side has, not its largest
// piece.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "vision/core/cancel.h"
#include "vision/core/pose.h"
#include "vision/inspect/explanation.h"
#include "vision/inspect/piece_shape.h"

namespace spool {

struct DatumSide {
  Pose T_new_old = Pose::Identity();  // from the design frame of the pose so far into the new one
  std::vector<std::uint8_t> is_held;  // one a part: where it is does not hang on the wrong joint
  HeldBy held_by = HeldBy::kJoint;    // what decides where those parts are
};

// What fits best of a spool with a wrong joint is its largest piece, but everything is measured
// from the datum. Seen from beyond any joint, is the side that holds the datum elsewhere than the
// design has it? Nothing where it is not, where it does not show or no datum is named.
// `scan`, `explanation` (explain_surface()): at the pose so far.
[[nodiscard]] std::optional<DatumSide> datum_side(const ExplainedDesign& design,
                                                  const ExplainedScan& scan,
                                                  const Explanation& explanation,
                                                  const Watch& watch = {});

// Whether T_other (T_design_scan) only puts one of the pieces where it is: no doubt about T_found.
[[nodiscard]] bool is_of_a_piece(const Pose& T_other, const Pose& T_found,
                                 const std::vector<Piece>& pieces, const ExplainedDesign& design);

}  // namespace spool
