// Which scan points are the object: the thesis's K nearest neighbours (5.3.2, appendix A).
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "vision/core/cancel.h"
#include "vision/core/cloud_view.h"

namespace spool {

enum class PointClass : std::uint8_t { kClutter = 0, kObject = 1, kContradicting = 2 };

enum class DeclutterMethod {
  kThreeClasses,   // by distance, normal and connectedness (explanation.h)
  kKnnClosedForm,  // K by eq. 5.5 on standardised sizes
  kKnnRatio,       // K = S / M, rounded (appendix A)
};

struct DeclutterOptions {
  DeclutterMethod method = DeclutterMethod::kThreeClasses;
  int k = 0;  // over 0: this K, whatever the method says

  [[nodiscard]] bool is_thesis() const { return method != DeclutterMethod::kThreeClasses || k > 0; }
};

struct DeclutterResult {
  DeclutterMethod method = DeclutterMethod::kThreeClasses;
  int k = 0;                        // of the thesis's methods
  std::vector<PointClass> classes;  // one a scan point
  std::size_t object = 0, clutter = 0, contradicting = 0;
};

// K of eq. 5.5 with its standardised inputs: 9.14 + 2.706 S' + 2.05 M' (2.706 belongs to the
// scene: ARCHITECTURE, The thesis's numbers), at least 1.
[[nodiscard]] int k_closed_form(std::size_t scene_points, std::size_t model_points);
// K = S / M rounded, at least 1 (appendix A; the thesis's table writes it M/S).
[[nodiscard]] int k_ratio(std::size_t scene_points, std::size_t model_points);

// The union of the K nearest scan points of every model point, each once. Both clouds in
// the design frame. Points that are not finite are clutter. Of a cancelled run nothing is kept.
[[nodiscard]] DeclutterResult declutter_knn(const CloudView& scan, const CloudView& model_samples,
                                            const DeclutterOptions& options = {},
                                            const Watch& watch = {});

// The result where there is no pose: every point is clutter.
[[nodiscard]] DeclutterResult nothing_kept(std::size_t scan_points,
                                           const DeclutterOptions& options = {});

// Counts `classes` again after a later step changed them.
void count_classes(DeclutterResult& result);

}  // namespace spool
