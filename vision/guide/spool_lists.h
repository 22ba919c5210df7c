// The lists of a cut sheet: pipes to saw, material, welds.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "vision/guide/cut_length.h"
#include "vision/guide/roll_welds.h"

namespace spool::guide {

struct CutRow {
  std::string piece;                 // the part's name
  std::string nps, schedule, heat;   // as the design says; "" nothing does
  double cut_m = 0;                  // to be sawn
  double centre_to_centre_m = 0;     // on the drawing
  double take_off_m = 0, gap_m = 0;  // of both ends together
};
[[nodiscard]] std::vector<CutRow> cut_rows(const DesignModel& design, const GapPolicy& policy);

struct MaterialRow {
  std::string text;           // "elbow 90\u00b0", "flange class 150"
  std::string nps, schedule;  // "3 x 2"
  int pieces = 0;
  double length_m = 0;  // of pipe: cut lengths together; 0 of pieces
};
// What is alike together, in the order of first mention. Pipes by their cut lengths.
[[nodiscard]] std::vector<MaterialRow> material_rows(const DesignModel& design,
                                                     const GapPolicy& policy);

struct WeldRow {
  std::string number;
  JointType type = JointType::kFab;
  std::string nps, schedule;
  std::string between;         // "flange-1, pipe-1"
  std::string heat_a, heat_b;  // of these two, where the design says
  bool can_roll = false;
  std::string why_not;
  int turn = 0;  // from 1: when it is welded in the plan
};
// In the design's order of joints.
[[nodiscard]] std::vector<WeldRow> weld_rows(const DesignModel& design, const RollPlan& plan);

// All of these are pure; any thread.

}  // namespace spool::guide
