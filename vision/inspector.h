// The main path: design and scan in, everything that was found out.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "vision/align/three_point.h"
#include "vision/core/cancel.h"
#include "vision/core/result.h"
#include "vision/design/design_model.h"
#include "vision/design/design_surface.h"
#include "vision/design/sampling.h"
#include "vision/find/finder_model.h"
#include "vision/inspect/inspection.h"
#include "vision/measure/rules.h"
#include "vision/scan/noise_model.h"

namespace spool {

struct InspectorOptions {
  AlignMethod align = AlignMethod::kPrincipalAxes;
  std::vector<PointPair> pairs;       // for kThreePoint, files' own coordinates (m)
  std::optional<Pose> T_design_scan;  // for kPose, files' own coordinates; taken as given
  // The given pose was come by in this way and refined on this scan: the report names it, and how
  // well the scan holds the pose.
  std::optional<AlignMethod> posed_by;
  DeclutterOptions declutter;
  bool units_confirmed = true;  // false: a unit was inferred, nothing may be ok
  // The scan is one frame of a sequence, in the frame of its camera, which looks along +z. Said in
  // the report.
  bool single_frame = false;
  std::uint32_t seed = 1;
  RuleSet rules = pfi_es3();  // tolerances that dimensions are judged by
  // What the sensor's calibration says, and how many neighbouring readings are worth one (of a
  // depth image, correlated_readings(); of a cloud, 1).
  double scale_u = 0.005, warp_u_m = 0, correlated = 1;
  std::vector<Gauge> scale_bars;  // laid beside the spool and measured in this scan
};

// What is prepared once a design. Shared by threads, immutable.
struct PreparedDesign {
  DesignModel model;
  DesignModel exterior;                    // `model` without the triangles that no sensor can see
  std::unique_ptr<DesignSurface> surface;  // over `exterior`
  SurfaceSamples samples;                  // of `exterior`
  std::unique_ptr<FinderModel> finder;     // where it was asked for: takes about a second

  // `to_be_found`: kFind needs what is prepared for it besides.
  [[nodiscard]] static Result<std::shared_ptr<const PreparedDesign>> prepare(
      DesignModel model, std::uint32_t seed = 1, bool to_be_found = false);
};

// One scan: align, declutter, measure, judge. Synchronous; const
// and reentrant apart from the scratch it owns, so one inspector a thread.
class Inspector {
 public:
  explicit Inspector(std::shared_ptr<const PreparedDesign> design) : design_(std::move(design)) {}

  // `scan`: metres in the scan's own frame, NaN allowed, normals optional (estimated where needed).
  // The mathematics' doubts are in the result; an Error is only for input that cannot be used at
  // all.
  [[nodiscard]] Result<Inspection> process(const PointCloud& scan, const NoiseModel& noise,
                                           const InspectorOptions& options,
                                           const Watch& watch = {}) const;

 private:
  std::shared_ptr<const PreparedDesign> design_;
};

}  // namespace spool
