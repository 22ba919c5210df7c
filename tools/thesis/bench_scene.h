// One of our scenes as the thesis's tables need it: a design to find, a cloud, and the truth.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "tools/campaign/scene.h"
#include "vision/design/design_model.h"
#include "vision/find/pair_library.h"

namespace spool::thesis {

struct BenchScene {
  DesignModel design;
  PointCloud cloud;                     // m, scan frame, no normals
  std::vector<std::uint8_t> is_object;  // one a point
  std::size_t object_points = 0;        // ||s||
  double clutter_ratio = 0, completeness = 1;
  std::vector<Pose> true_T_design_scan;  // one for each symmetry of the design
};

// Same request, same scene.
[[nodiscard]] BenchScene make_bench_scene(const campaign::SceneRequest& request);

// Models of the designs met so far, each built once, as the thesis's library is.
class Models {
 public:
  // A library with this design alone. Errors are build_pair_model()'s.
  [[nodiscard]] Result<PairLibrary> library_of(const DesignModel& design);

 private:
  PairLibrary known_;
};

}  // namespace spool::thesis
