// The thesis's declutter as its chapter 5 tells it: Algorithm 1 isolates, Algorithm 2 tries every
// K.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "vision/core/cancel.h"
#include "vision/core/cloud_view.h"
#include "vision/core/pose.h"
#include "vision/find/measures.h"
#include "vision/inspect/declutter.h"

namespace spool {

struct ThesisIsolation {
  Pose T_design_scan = Pose::Identity();  // after ICP
  DeclutterResult kept;                   // one class a scan point
  // N over K M: how little of the K x M list is not a repetition (THESIS.md, A9).
  double unique_share = 0;
};

struct ThesisIsolationOptions {
  DeclutterOptions declutter;
  int icp_iterations = 50;    // appendix A; 0: the pose as given
  double icp_reach_m = 0.05;  // m; how far a model point looks for its scan point
};

// Algorithm 1 of chapter 5: superimposes the model on the scan by the pose, refines it by ICP, and
// keeps the K nearest scan points of every model point, each once. Scan in m, scan frame; model
// points in m, design frame. Cancelled: the pose as far as it came and nothing kept.
[[nodiscard]] ThesisIsolation isolate_by_neighbours(const CloudView& scan, const CloudView& model,
                                                    const Pose& T_design_scan,
                                                    const ThesisIsolationOptions& options = {},
                                                    const Watch& watch = {});

// The K that Algorithm 2 of chapter 5 tries: 1, S/M (printed M/S), 10, 50, root of M and of S;
// rounded, ascending, each once, at least 1.
[[nodiscard]] std::vector<int> thesis_ks(std::size_t scene_points, std::size_t model_points);

// What one K keeps.
struct RateAtK {
  int k = 0;
  KeptCounts counts;  // measures.h makes VR, NR, recall, precision and F1 of them
};

// Algorithm 2 of chapter 5, with the truth in place of the thesis's trimming by hand: one flag a
// scan point says whether it is the object's. Both clouds in the design frame, m. Cancelled: the
// rows so far.
[[nodiscard]] std::vector<RateAtK> rates_by_k(const CloudView& scan, const CloudView& model,
                                              std::span<const std::uint8_t> is_object,
                                              std::span<const int> ks, const Watch& watch = {});

}  // namespace spool
