// Coarse registration by principal axes, every axis combination tried (thesis 3.3.2).
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "vision/align/icp.h"
#include "vision/core/cancel.h"
#include "vision/core/cloud_view.h"
#include "vision/core/pose.h"
#include "vision/design/design_surface.h"

namespace spool {

struct PrincipalAxesResult {
  IcpResult best;  // after ICP
  std::vector<IcpResult>
      alternatives;        // other combinations that end as well within the noise, best first
  bool ambiguous = false;  // alternatives is not empty
  int combinations = 24;   // proper rotations tried
};

// Centres and principal axes of both clouds brought together in each of the 24 proper signed axis
// permutations, each refined by ICP, the one with the least trimmed point-to-surface error kept.
// The scan has to be the object alone or nearly (the thesis cleans it by hand first).
[[nodiscard]] PrincipalAxesResult align_principal_axes(const CloudView& scan,
                                                       const CloudView& design,
                                                       const DesignSurface& surface,
                                                       const IcpOptions& options = {},
                                                       const Watch& watch = {});

}  // namespace spool
