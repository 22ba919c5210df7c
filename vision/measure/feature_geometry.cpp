// Points and directions of the drawing as functions of the fitted features.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/measure/feature_geometry.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace spool {
namespace {

using Eigen::Vector3d;

// Legs whose directions are within 17 degrees of parallel do not cross anywhere certain.
constexpr double kParallel = 0.956;

Vector3d axis_of(const Pose& pose) { return pose.linear().col(2); }

std::size_t at(int index) { return static_cast<std::size_t>(index); }

}  // namespace

Vector3d line_meets_plane(const Pose& line, const Pose& plane) {
  const Vector3d n = axis_of(plane), d = axis_of(line);
  const double along = n.dot(plane.translation() - line.translation()) / n.dot(d);
  return line.translation() + along * d;
}

Vector3d nearest_on(const Pose& a, const Pose& b) {
  const Vector3d u = axis_of(a), v = axis_of(b), w = b.translation() - a.translation();
  const double c = u.dot(v);
  return a.translation() + (u.dot(w) - c * v.dot(w)) / (1 - c * c) * u;
}

int FeatureGeometry::axis_near(int node, int leg) const {
  const DrawingLeg& along = drawing_.legs[at(leg)];
  std::vector<int> pipes = along.pipes;  // from -> to
  if (along.from != node) std::ranges::reverse(pipes);
  for (const int pipe : pipes)
    if (const int feature = features_.of(pipe); feature >= 0) return feature;
  return -1;
}

std::string FeatureGeometry::why_no_axis(int leg) const {
  const std::vector<int>& pipes = drawing_.legs[at(leg)].pipes;
  if (pipes.empty()) return "no pipe lies between, so nothing holds an axis there";
  const int pipe = pipes.front();
  return "the axis of " + design_.parts[at(pipe)].name +
         " is not known: " + features_.why_not[at(pipe)];
}

double FeatureGeometry::sign_along(int feature, int leg) const {
  const Vector3d nominal = axis_of(features_.features[at(feature)].T_design_nominal);
  return nominal.dot(drawing_.legs[at(leg)].direction) < 0 ? -1 : 1;
}

int FeatureGeometry::crossing(int node, int leg) const {
  for (const int other : drawing_.nodes[at(node)].legs) {
    if (other == leg || axis_near(node, other) < 0) continue;
    const double c = drawing_.legs[at(leg)].direction.dot(drawing_.legs[at(other)].direction);
    if (std::abs(c) < kParallel) return other;
  }
  return -1;
}

FeaturePoint FeatureGeometry::point(int node, int leg) const {
  const int axis = axis_near(node, leg);
  if (axis < 0) return {{}, why_no_axis(leg)};
  const DrawingNode& where = drawing_.nodes[at(node)];
  const std::string& part = design_.parts[at(where.part)].name;
  if (where.kind == NodeKind::kFace) {
    const int face = features_.of(where.part);
    if (face < 0)
      return {{}, "the face of " + part + " is not known: " + features_.why_not[at(where.part)]};
    return {[axis, face](const FeatureState& state) {
              return line_meets_plane(state[at(axis)], state[at(face)]);
            },
            ""};
  }
  if (where.kind == NodeKind::kEnd) return {{}, "where " + part + " ends is not measured"};
  const int other = crossing(node, leg);
  if (other < 0) {
    for (const int each : where.legs)
      if (each != leg && axis_near(node, each) < 0)
        return {{}, "the centre of " + part + " is not known: " + why_no_axis(each)};
    return {{}, "no other centreline crosses at " + part};
  }
  const int second = axis_near(node, other);
  return {[axis, second](const FeatureState& state) {
            return nearest_on(state[at(axis)], state[at(second)]);
          },
          ""};
}

FeaturePoint FeatureGeometry::direction(int leg) const {
  int best = -1;
  for (const int pipe : drawing_.legs[at(leg)].pipes) {
    const int feature = features_.of(pipe);
    if (feature < 0) continue;
    const auto lean = [&](int f) {
      return features_.features[at(f)].fit_covariance.diagonal().tail<3>().sum();
    };
    if (best < 0 || lean(feature) < lean(best)) best = feature;
  }
  if (best < 0) return {{}, why_no_axis(leg)};
  const double sign = sign_along(best, leg);
  return {[best, sign](const FeatureState& state) -> Vector3d {
            return sign * axis_of(state[at(best)]);
          },
          ""};
}

FeaturePoint FeatureGeometry::outward(int node, int leg) const {
  const int axis = axis_near(node, leg);
  if (axis < 0) return {{}, why_no_axis(leg)};
  const double sign = sign_along(axis, leg) * (drawing_.legs[at(leg)].from == node ? 1 : -1);
  return {[axis, sign](const FeatureState& state) -> Vector3d {
            return sign * axis_of(state[at(axis)]);
          },
          ""};
}

FeatureState FeatureGeometry::nominal() const {
  FeatureState state;
  for (const PartFeature& feature : features_.features) state.push_back(feature.T_design_nominal);
  return state;
}

FeatureState FeatureGeometry::measured() const {
  FeatureState state;
  for (const PartFeature& feature : features_.features) state.push_back(feature.T_design_measured);
  return state;
}

std::function<double(const FeatureState&)> turn_of_holes(int feature, const FrameFunction& frame,
                                                         const FeatureState& nominal) {
  // Where the frame has the part's x.
  const Vector3d x = frame(nominal).linear().transpose() * nominal[at(feature)].linear().col(0);
  return [feature, frame, x](const FeatureState& state) {
    const Eigen::Matrix3d holes = state[at(feature)].linear();
    const Vector3d drawn = holes.transpose() * frame(state).linear() * x;
    return -std::atan2(drawn.y(), drawn.x());
  };
}

Propagated propagate(const std::function<Eigen::VectorXd(const FeatureState&)>& function,
                     const PartFeatures& features, const FeatureState& measured,
                     std::span<const int> only) {
  Propagated result;
  result.value = function(measured);
  const auto rows = result.value.size();
  result.fit = result.warp = Eigen::MatrixXd::Zero(rows, rows);
  constexpr double kStep = 1e-5;   // m, rad: functions of metres are straight over it
  constexpr double kHolds = 1e-6;  // a slope under it is none
  FeatureState moved = measured;
  const std::size_t count = only.empty() ? features.features.size() : only.size();
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t f = only.empty() ? i : at(only[i]);
    const PartFeature& feature = features.features[f];
    Eigen::MatrixXd slope(rows, 6);
    for (int k = 0; k < 6; ++k) {
      moved[f] = measured[f] * pose_from_small(kStep * Vector6d::Unit(k));
      const Eigen::VectorXd there = function(moved);
      moved[f] = measured[f] * pose_from_small(-kStep * Vector6d::Unit(k));
      slope.col(k) = (there - function(moved)) / (2 * kStep);
      if (!feature.is_observed[static_cast<std::size_t>(k)] &&
          slope.col(k).cwiseAbs().maxCoeff() > kHolds)
        result.is_determined = false;
    }
    moved[f] = measured[f];
    result.fit += slope * feature.fit_covariance * slope.transpose();
    result.warp += slope * feature.warp_covariance * slope.transpose();
  }
  return result;
}

}  // namespace spool
