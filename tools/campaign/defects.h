// What a shop may have done wrong: the design's assembly with one joint or part changed.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tools/campaign/assembly.h"

namespace spool::campaign {

enum class DefectKind {
  kTurned,   // an elbow turned about its inlet by `amount` degrees, all that hangs on it with it
  kLong,     // a pipe longer by `amount` millimetres
  kSwapped,  // what hangs on two branches changed places
  kMissing,  // a flange is not there
  kExtra     // a branch that the design does not know
};

struct Defect {
  DefectKind kind = DefectKind::kTurned;
  double amount = 0;      // 0: 90 degrees, 100 millimetres
  std::string part = "";  // "": the seed chooses one that fits
};

}  // namespace spool::campaign
