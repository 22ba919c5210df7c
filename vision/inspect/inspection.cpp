// The names of methods.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/inspect/inspection.h"

#include <cassert>

namespace spool {
std::string_view name(AlignMethod method) {
  switch (method) {
    case AlignMethod::kPose:
      return "pose";
    case AlignMethod::kThreePoint:
      return "three-point";
    case AlignMethod::kPrincipalAxes:
      return "principal-axes";
    case AlignMethod::kFind:
      return "find";
  }
  assert(false && "every method has a name");
  return "pose";
}

std::optional<AlignMethod> parse_align_method(std::string_view text) {
  for (const AlignMethod method : {AlignMethod::kPose, AlignMethod::kThreePoint,
                                   AlignMethod::kPrincipalAxes, AlignMethod::kFind})
    if (name(method) == text) return method;
  return std::nullopt;
}

}  // namespace spool
