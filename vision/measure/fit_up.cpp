// How two pipes meet at a butt weld.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/measure/fit_up.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "vision/measure/feature_geometry.h"
#include "vision/measure/part_shapes.h"

namespace spool {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

std::size_t at(int index) { return static_cast<std::size_t>(index); }

// A feature's axis where it passes the plane through `place` across `z`.
Vector3d passes(const Pose& axis, const Vector3d& place, const Vector3d& z) {
  const Vector3d d = axis.linear().col(2);
  return axis.translation() + z.dot(place - axis.translation()) / z.dot(d) * d;
}

std::string why_no_cylinder(const DesignModel& design, const PartFeatures& features, int part) {
  const Part& which = design.parts[at(part)];
  if (which.kind != PartKind::kPipe)
    return which.name + " has no cylinder that is measured at the joint";
  return "the axis of " + which.name + " is not known: " + features.why_not[at(part)];
}

void measure(const DesignModel& design, const PartFeatures& features, const Joint& joint,
             FitUp& fit_up) {
  const int a = features.of(joint.part_a), b = features.of(joint.part_b);
  const PartFeature& one = features.features[at(a)];
  const PartFeature& other = features.features[at(b)];
  const Part& part = design.parts[at(joint.part_a)];
  const Port& port = part.ports[at(joint.port_a)];
  // Where the weld is, the drawing and a's own place say: along the axes it hardly matters.
  const Pose built = one.T_design_measured * one.T_design_nominal.inverse() * part.T_design_part;
  const Vector3d place = built * port.position;
  FeatureState measured;
  for (const PartFeature& feature : features.features)
    measured.push_back(feature.T_design_measured);
  const Vector3d za = one.T_design_measured.linear().col(2);
  Vector3d zb = other.T_design_measured.linear().col(2);
  if (za.dot(zb) < 0) zb = -zb;
  const Vector3d z = (za + zb).normalized();
  const Vector3d x = z.unitOrthogonal(), y = z.cross(x);
  const Propagated offset = propagate(
      [&](const FeatureState& state) -> Eigen::VectorXd {
        const Vector3d off = passes(state[at(b)], place, z) - passes(state[at(a)], place, z);
        return Vector2d(off.dot(x), off.dot(y));
      },
      features, measured);
  const Vector2d off = offset.value;
  const Eigen::Matrix2d covariance = offset.fit + offset.warp;
  const Vector2d way = off.norm() > 0 ? Vector2d(off.normalized()) : Vector2d(Vector2d::UnitX());
  fit_up.is_measured = true;
  fit_up.offset_m = std::sqrt(std::max(0.0, off.squaredNorm() - covariance.trace()));
  fit_up.radius_step_m = other.radius_m - one.radius_m;
  fit_up.hi_lo_m = fit_up.offset_m + std::abs(fit_up.radius_step_m);
  fit_up.u_m = std::sqrt(way.dot(covariance * way) + one.radius_u_m * one.radius_u_m +
                         other.radius_u_m * other.radius_u_m);
}

}  // namespace

std::vector<FitUp> fit_ups(const DesignModel& design, const PartFeatures& features) {
  std::vector<FitUp> all;
  for (std::size_t j = 0; j < design.joints.size(); ++j) {
    const Joint& joint = design.joints[j];
    const Part& a = design.parts[at(joint.part_a)];
    const Part& b = design.parts[at(joint.part_b)];
    if (a.ports[at(joint.port_a)].end != EndType::kButtWeld ||
        b.ports[at(joint.port_b)].end != EndType::kButtWeld)
      continue;
    FitUp fit_up{.joint = static_cast<int>(j), .weld = joint.weld, .a = a.name, .b = b.name};
    fit_up.root_gap =
        "The root gap is not measured: no camera sees into it. Check it with a feeler gauge or a "
        "wire of its size.";
    for (const int part : {joint.part_a, joint.part_b}) {
      const int feature = features.of(part);
      if (feature >= 0 && features.features[at(feature)].kind == FeatureKind::kAxis) continue;
      fit_up.reason = "Not measured: " + why_no_cylinder(design, features, part) +
                      ". Check it with a hi-lo gauge.";
      break;
    }
    if (fit_up.reason.empty()) measure(design, features, joint, fit_up);
    all.push_back(std::move(fit_up));
  }
  return all;
}

}  // namespace spool
