// The thesis's object finder (chapter 4, Algorithm 2): random scene pairs, looked up in the
// library.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "vision/core/cancel.h"
#include "vision/core/cloud_view.h"
#include "vision/core/pose.h"
#include "vision/core/result.h"
#include "vision/find/pair_library.h"

namespace spool {

// The first three are the thesis's (Table 4-2); d and the cells are the library's. The seed alone
// decides the result as long as the time does not run out.
struct ThesisFinderOptions {
  double min_support = 0.15;  // lambda_s: share of model points near the scene; less is not found
  double time_limit_s = 20;   // s a design; the thesis's remedy where none is found: 40
  int icp_iterations = 5;
  // The search for a design ends where this much of it is supported ("a pre-defined portion",
  // 4.3.4). 1: the thesis's times say that it went on.
  double enough_support = 1.0;
  std::size_t max_iterations = 0;  // first points s1 tried; 0: every point of the thinned scene
  double near_over_leaf = 0.4;     // near the scene: within this many leaves of the model's octree
  std::uint32_t seed = 1;
};

// What makes no sense in `options`, kUsage; nothing where all is well.
[[nodiscard]] std::optional<Error> validate(const ThesisFinderOptions& options);

// How the search for one design went.
struct ThesisSearch {
  bool found = false;  // support >= min_support; the pose is the best met, even so
  Pose T_design_scan = Pose::Identity();  // after ICP
  double support = 0;                     // lambda_s at that pose, against every scan point
  double near_m = 0;                      // what counts as near
  std::size_t iterations = 0;             // first points tried
  std::size_t hypotheses = 0;             // poses tested
  double seconds = 0;  // matching alone, as the thesis counts: no library, no ICP
  bool out_of_time = false;
  bool cancelled = false;
};

// Algorithm 2 of thesis chapter 4 for each design of the library: thins the scan by the weighted
// octree, fits normals to neighbours, draws s1, pairs it with every s2 at distance d, looks the
// pair's angles up, aligns four points to four (the pair and the ends of its normals) and keeps the
// pose with the most support; then ICP, point to point. Scan in m, any frame; normals, where it has
// them, only say which side is outside. Points that are not finite are left out. One search a
// design, in the library's order. Same seed, same result on any number of threads, unless the time
// ran out.
[[nodiscard]] std::vector<ThesisSearch> find_as_thesis(const CloudView& scan,
                                                       const PairLibrary& library,
                                                       const ThesisFinderOptions& options = {},
                                                       const Watch& watch = {});

// The scan points that correspond to the posed model, S_i of Algorithm 2: those whose nearest model
// point (`model`, m, design frame) is within `distance_m`; ascending places in the scan.
[[nodiscard]] std::vector<std::uint32_t> isolate(const CloudView& scan, const CloudView& model,
                                                 const Pose& T_design_scan, double distance_m,
                                                 const Watch& watch = {});

}  // namespace spool
