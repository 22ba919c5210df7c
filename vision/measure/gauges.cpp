// The pieces of known size on a spool that a scan measured, for the check of the sensor's scale.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/measure/gauges.h"

#include <algorithm>
#include <cmath>

#include "vision/measure/flange_rim.h"
#include "vision/measure/part_shapes.h"

namespace spool {
namespace {

// Mill scale, rust and paint are 0.1 to 0.3 mm thick, on all pieces alike: as a standard
// uncertainty of a diameter estimated as 0.2 mm.
constexpr double kCoating_u_m = 0.0002;

// ASME B16.5, 6.7: an outside diameter to NPS 24 may be off by 1/16 in, above by 1/8 in. As a
// rectangle.
double rim_tolerance_u(double diameter_m) {
  return (diameter_m <= 0.8128 ? 0.0016 : 0.0032) / std::sqrt(3.0);
}

// Of a diameter. A patch error shifts a whole surface, which its axis takes; what is left of it is
// that opposite sides are off apart from each other, over two sides or more about as much as one
// is.
double diameter_u(double radius_u_m, double patch_error_m) {
  const double fit2 = radius_u_m * radius_u_m - patch_error_m * patch_error_m;
  return std::sqrt(4 * std::max(0.0, fit2) + patch_error_m * patch_error_m);
}

std::optional<double> range_of(const FeatureScan& scan, const Eigen::Vector3d& at) {
  if (!scan.eye) return std::nullopt;
  return (*scan.eye - at).norm();
}

}  // namespace

std::vector<Gauge> gauges_of(const DesignModel& design, const FeatureScan& scan,
                             const PartFeatures& features, const Watch& watch) {
  std::vector<Gauge> gauges;
  for (const PartFeature& feature : features.features) {
    if (feature.kind != FeatureKind::kAxis || !(feature.radius_m > 0)) continue;
    const auto shape = pipe_shape(design, feature.part);
    if (!shape) continue;
    gauges.push_back({.kind = GaugeKind::kPipeDiameter,
                      .part = feature.part,
                      .nominal_m = 2 * shape->radius_m,
                      .tolerance_u_m = 2 * mill_radius_u(shape->radius_m),
                      .measured_m = 2 * feature.radius_m,
                      .u_m = diameter_u(feature.radius_u_m, features.patch_error_m),
                      .shared_u_m = kCoating_u_m,
                      .range_m = range_of(scan, feature.T_design_measured.translation())});
  }
  for (std::size_t p = 0; p < design.parts.size() && !watch.cancelled(); ++p) {
    const auto rim = measure_rim(design, scan, features, static_cast<int>(p), watch);
    if (!rim) continue;
    gauges.push_back({.kind = GaugeKind::kFlangeDiameter,
                      .part = static_cast<int>(p),
                      .nominal_m = rim->nominal_m,
                      .tolerance_u_m = rim_tolerance_u(rim->nominal_m),
                      .measured_m = rim->diameter_m,
                      .u_m = rim->u_m,
                      .shared_u_m = kCoating_u_m,
                      .range_m = range_of(scan, rim->centre)});
  }
  return gauges;
}

}  // namespace spool
