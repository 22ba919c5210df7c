// What the points of a part say of its own feature: a pipe's axis, a flange's face and its holes.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "vision/core/cancel.h"
#include "vision/core/pose.h"
#include "vision/design/design_model.h"
#include "vision/inspect/declutter.h"
#include "vision/inspect/deviation.h"

namespace spool {

enum class FeatureKind : std::uint8_t { kAxis, kFace, kHoles };

struct PartFeature {
  int part = -1;
  FeatureKind kind = FeatureKind::kAxis;
  // z: a pipe's axis from its first port to its second, or a face's outward normal; the origin on
  // the axis or in the face, at the middle of the points. Of holes the part's own frame moved into
  // its face: x as the holes stand, modulo their pitch. Nominal: where the design has it.
  Pose T_design_nominal = Pose::Identity();
  Pose T_design_measured = Pose::Identity();
  // Of a small motion of the measured frame in itself: what random noise and its correlation leave
  // (fit) and what the sensor's warp does (warp). Zero along what is not observed.
  Matrix6d fit_covariance = Matrix6d::Zero();
  Matrix6d warp_covariance = Matrix6d::Zero();
  // Which of the six motions the points hold: an axis neither slides nor turns about itself, a face
  // neither shifts in its plane nor turns in it, holes tell how a face turns and leans.
  std::array<bool, 6> is_observed = {};
  std::size_t points = 0;
  // Of an axis, its radius left free: m, and its standard uncertainty.
  double radius_m = 0, radius_u_m = 0;
};

// One scan as features are fitted to it; all outlive the call.
struct FeatureScan {
  const PointCloud& scan_design;        // every point, m, design frame
  std::span<const PointClass> classes;  // one a point
  const Deviations& deviations;         // one a point
  std::optional<Eigen::Vector3d> eye;   // of a single camera, m, design frame
  double correlated = 1;                // readings that are worth one
  double warp_u_m = 0;                  // of the sensor
  double bound_m = 0.02;                // further from the design no point is a part's
};

struct PartFeatures {
  std::vector<PartFeature> features;
  std::vector<std::string> why_not;  // one a part: why it has no feature; else empty
  // One a part: why nothing is known of its holes, and empty too where it has none.
  std::vector<std::string> why_no_holes;
  // m: what patches of a surface err by together, over all features (see measure_features()).
  double patch_error_m = 0;

  // Into features, of a part's axis or face, and of its holes; -1: none.
  [[nodiscard]] int of(int part) const;
  [[nodiscard]] int holes_of(int part) const;
};

// The axes of pipes and the faces of flanges that enough readings lie on (their holes:
// add_bolt_holes()). A pipe's radius is the design's with the mill's
// tolerance (ASTM A999) as prior, unless it is proved to be of another size. Readings err together
// (a sensor's correlation windows, stations that were merged): each surface is cut into patches,
// and where the patches' means scatter by more than independent readings would let them, the
// feature's covariance grows by as much (Birge's ratio) and, as that is seen within features only,
// the whole feature may be off by the same.
// Of a cancelled run nothing is known.
[[nodiscard]] PartFeatures measure_features(const DesignModel& design, const FeatureScan& scan,
                                            const Watch& watch = {});

}  // namespace spool
