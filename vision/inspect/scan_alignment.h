// From what the user gave (a pose, picked pairs, nothing) to where the scan lies on the design.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "vision/align/three_point.h"
#include "vision/core/cancel.h"
#include "vision/design/design_model.h"
#include "vision/design/design_surface.h"
#include "vision/design/sampling.h"
#include "vision/find/finder_model.h"
#include "vision/inspect/inspection.h"
#include "vision/inspect/piece_shape.h"
#include "vision/scan/noise_model.h"

namespace spool {

// Pairs and pose are in the files' own coordinates.
struct AlignRequest {
  AlignMethod method = AlignMethod::kPrincipalAxes;
  std::vector<PointPair> pairs;
  std::optional<Pose> T_design_scan;
  const FinderModel* finder = nullptr;  // for kFind
  std::uint32_t seed = 1;               // of its draws
  bool is_depth_image = false;          // the scan is what a camera at its origin sees along +z
  std::optional<AlignMethod> posed_by;  // how the pose was come by, if it was refined on this scan
};

// A first placement, between the origin-free frames that everything inside computes in.
struct Placement {
  bool found = false;
  std::string reason;
  Pose T_design_scan = Pose::Identity();
  std::optional<double> reach_m;  // m; how far off it may be; nothing: not placed yet, anywhere
  std::vector<double> pair_residual_m;
  std::vector<Pose> alternatives;     // that explain the scan about as well, refined no further
  bool is_symmetric = false;          // all of them by the design's own symmetry
  double noise_m = 0;                 // m, of a scan point: what is given, or what the pose shows
  std::vector<std::uint8_t> is_held;  // parts that the pose may be taken from; empty: all
  HeldBy held_by = HeldBy::kJoint;    // what decides where those are
};

// What the method itself gives before anything is refined. Reach of pairs: what picks some 10 mm
// off (5-20 mm: ARCHITECTURE, Taps) do to the far end of the design.
[[nodiscard]] Placement place_scan(const AlignRequest& request, const DesignModel& design,
                                   const PointCloud& scan, double noise_m, const Watch& watch = {});

// The points that a refinement looks at: those within reach of the held parts, at most some 30 000,
// with normals (estimated and of no sign where the scan has none). Points are the scan's own, not
// means.
[[nodiscard]] PointCloud refinement_cloud(const PointCloud& scan, const DesignSurface& surface,
                                          const Placement& placement);

// Standard deviation (m) of the readings at the scan's median depth (m along z, head on).
[[nodiscard]] double typical_noise_m(const PointCloud& scan, const NoiseModel& noise);

// Refines the placement over `near` (refinement_cloud()) and says how sure it is. A given pose is
// only measured. The pose comes back between the files' frames.
[[nodiscard]] Alignment align_scan(const AlignRequest& request, const Placement& placement,
                                   const PointCloud& near, bool oriented_normals, double noise_m,
                                   const DesignModel& design, const DesignSurface& surface,
                                   const SurfaceSamples& samples, const Watch& watch);

// Says of the alignment of a cancelled run that nothing hangs on it.
void mark_stopped(Alignment& alignment);

// A pose between origin-free frames as one between the files' frames, and back.
[[nodiscard]] Pose between_files(const Pose& T_design_scan, const Eigen::Vector3d& design_origin,
                                 const Eigen::Vector3d& scan_origin);
[[nodiscard]] Pose between_local(const Pose& T_design_scan, const Eigen::Vector3d& design_origin,
                                 const Eigen::Vector3d& scan_origin);

// Every point (and normal) of the scan in the design frame, in input order; the pose between the
// files.
[[nodiscard]] PointCloud to_design_frame(const PointCloud& scan, const DesignModel& design,
                                         const Pose& T_design_scan);

}  // namespace spool
