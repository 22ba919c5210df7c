// The datum frame that parts' poses are relative to.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/measure/pose_datum.h"

#include <algorithm>
#include <cmath>

namespace spool {
namespace {

using Eigen::Vector3d;

constexpr double kParallel = 0.956;  // as in FeatureGeometry

// The feature of the first pipe that leaves `axis`; -1: none does.
int first_leg_off(const Vector3d& axis, const PartFeatures& features) {
  int best = -1;
  for (std::size_t f = 0; f < features.features.size(); ++f) {
    const PartFeature& each = features.features[f];
    if (each.kind != FeatureKind::kAxis ||
        std::abs(each.T_design_nominal.linear().col(2).dot(axis)) >= kParallel)
      continue;
    if (best < 0 || each.part < features.features[static_cast<std::size_t>(best)].part)
      best = static_cast<int>(f);
  }
  return best;
}

}  // namespace

PoseDatum pose_datum(const DesignModel& design, const Drawing& drawing,
                     const PartFeatures& features, const FeatureGeometry& geometry) {
  const DatumFrame datum = datum_frame(design, drawing, features, geometry);
  PoseDatum result{.T_design_datum = datum.T_design_datum, .text = datum.text};
  if (datum.node < 0) return result;
  result.is_turn_held = datum.is_clocked();
  if (result.is_turn_held) return result;
  const int leg = first_leg_off(datum.T_design_datum(geometry.nominal()).linear().col(2), features);
  if (leg < 0) return result;
  const PartFeature& by = features.features[static_cast<std::size_t>(leg)];
  result.is_turn_held = true;
  result.text +=
      ", turned about it by the axis of " + design.parts[static_cast<std::size_t>(by.part)].name;
  result.T_design_datum = [T_design_datum = datum.T_design_datum, leg](const FeatureState& state) {
    Pose T = T_design_datum(state);
    const Vector3d z = T.linear().col(2);
    const Vector3d way = state[static_cast<std::size_t>(leg)].linear().col(2);
    const Vector3d x = (way - way.dot(z) * z).normalized();
    T.linear().col(0) = x;
    T.linear().col(1) = z.cross(x);
    return T;
  };
  return result;
}

}  // namespace spool
