// What a shop may have done wrong: the design's assembly with one joint or part changed.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tools/campaign/assembly.h"
#include "tools/campaign/random.h"

namespace spool::campaign {

// All that hangs on a part moves with it.
enum class DefectKind {
  kTurned,   // an elbow turned about its inlet by `amount` degrees (90)
  kLong,     // a pipe or tube longer by `amount` millimetres (100)
  kSwapped,  // what hangs on two joints changed places
  kMissing,  // a flange, or of a frame a tube, is not there
  kExtra,    // a branch, or of a frame a tube, that the design does not know
  kTilted,   // a flange leans by `amount` degrees (1)
  kClocked,  // a flange's holes are turned by `amount` degrees (half their pitch)
  kOffset    // a pipe is welded on aside by `amount` millimetres (3)
};
[[nodiscard]] const char* name(DefectKind kind);  // turned, long, ...

struct Defect {
  DefectKind kind = DefectKind::kTurned;
  double amount = 0;       // 0: the one in brackets above
  std::string part = "";   // "": one that fits, at random
  std::string other = "";  // the second of kSwapped
};

// The design with the defects done to it one after another. `defects` come back with the parts and
// amounts that were chosen; a kind that this design has no part for is taken out. Extra parts stand
// behind the design's.
[[nodiscard]] Assembly with_defects(const Assembly& design, Random random,
                                    std::vector<Defect>& defects);

}  // namespace spool::campaign
