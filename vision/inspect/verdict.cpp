// The names of the statuses, and which of two is worse.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/inspect/verdict.h"

#include <cassert>

namespace spool {
namespace {

// Place in the order of ARCHITECTURE, Command lines, the worst first.
int rank(Verdict verdict) {
  switch (verdict) {
    case Verdict::kNotOk:
      return 0;
    case Verdict::kSuspicious:
      return 1;
    case Verdict::kNotMeasured:
      return 2;
    case Verdict::kOk:
      return 3;
  }
  assert(false && "every verdict has its place");
  return 0;
}

}  // namespace

std::string_view name(Verdict verdict) {
  switch (verdict) {
    case Verdict::kOk:
      return "ok";
    case Verdict::kSuspicious:
      return "suspicious";
    case Verdict::kNotOk:
      return "not_ok";
    case Verdict::kNotMeasured:
      return "not_measured";
  }
  assert(false && "every verdict has a name");
  return "not_measured";
}

Verdict worse(Verdict a, Verdict b) { return rank(a) <= rank(b) ? a : b; }

}  // namespace spool
