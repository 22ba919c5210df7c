// Points and directions of the drawing as functions of the fitted features.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "vision/core/pose.h"
#include "vision/measure/drawing.h"
#include "vision/measure/part_feature.h"

namespace spool {

// The features' frames in the order of PartFeatures::features: nominal, measured, or moved a
// little.
using FeatureState = std::vector<Pose>;
using PointFunction = std::function<Eigen::Vector3d(const FeatureState&)>;

using FrameFunction = std::function<Pose(const FeatureState&)>;

// Which features make a point or direction; without them, why.
struct FeaturePoint {
  PointFunction at;  // m or unit, design frame; empty: not measured
  std::string why_not;
};

// All outlive it.
class FeatureGeometry {
 public:
  FeatureGeometry(const DesignModel& design, const Drawing& drawing, const PartFeatures& features)
      : design_(design), drawing_(drawing), features_(features) {}

  // The feature of the pipe of `leg` that is measured and nearest to `node`; -1: none.
  [[nodiscard]] int axis_near(int node, int leg) const;
  // Where `node` is, seen along `leg`: a face's plane met by the leg's axis; the point of the leg's
  // axis that is nearest to the axis of another leg there.
  [[nodiscard]] FeaturePoint point(int node, int leg) const;
  // Unit, the leg's way: its longest measured pipe's axis.
  [[nodiscard]] FeaturePoint direction(int leg) const;
  // Unit, from `node` outward along `leg`: of the pipe nearest to it.
  [[nodiscard]] FeaturePoint outward(int node, int leg) const;

  [[nodiscard]] FeatureState nominal() const;
  [[nodiscard]] FeatureState measured() const;

 private:
  [[nodiscard]] std::string why_no_axis(int leg) const;
  // A leg at `node` that is not parallel to `leg` and has an axis; -1: none.
  [[nodiscard]] int crossing(int node, int leg) const;
  [[nodiscard]] double sign_along(int feature, int leg) const;

  const DesignModel& design_;
  const Drawing& drawing_;
  const PartFeatures& features_;
};

// Where the z axis of `line` meets the plane across z of `plane`; the point of the z axis of `a`
// that is nearest to that of `b`. In the frame of both, m; nothing finite where they are parallel.
[[nodiscard]] Eigen::Vector3d line_meets_plane(const Pose& line, const Pose& plane);
[[nodiscard]] Eigen::Vector3d nearest_on(const Pose& a, const Pose& b);

// How far (rad) the feature of holes stands turned from where the drawing has it in `frame`,
// right-handed about the feature's z and between -pi and pi: of what is read modulo their pitch, as
// if the first hole had been known. 0 of the nominal state.
[[nodiscard]] std::function<double(const FeatureState&)> turn_of_holes(int feature,
                                                                       const FrameFunction& frame,
                                                                       const FeatureState& nominal);

// A number, or two of them, of the features, and what their covariances make of it.
struct Propagated {
  Eigen::VectorXd value;
  Eigen::MatrixXd fit, warp;
  bool is_determined = true;  // false: it moves with something that no feature holds
};
// `only`: the features that it depends on; empty: all are tried.
[[nodiscard]] Propagated propagate(
    const std::function<Eigen::VectorXd(const FeatureState&)>& function,
    const PartFeatures& features, const FeatureState& measured, std::span<const int> only = {});

}  // namespace spool
