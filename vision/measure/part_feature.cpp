// Pipe axes and flange faces from the points of their parts, with what patches err by together.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/measure/part_feature.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>

#include "vision/fit/cylinder.h"
#include "vision/fit/plane.h"
#include "vision/measure/part_shapes.h"
#include "vision/measure/patch_scatter.h"

namespace spool {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kLeastPoints = 30;   // fewer cannot carry five unknowns and their own noise
constexpr std::size_t kMostPoints = 8000;  // more only cost time
constexpr int kSectors = 12;               // of 30 degrees about an axis or a face's middle
constexpr double kLeastFacing = 0.4;  // cosine: beyond 66 degrees readings are lost or drawn aside

// A point of a part that its feature may be fitted to.
struct Reading {
  Eigen::Vector3f point;
  Eigen::Vector3f normal;  // of the design there
  float distance;
};

// One list a part.
std::vector<std::vector<Reading>> readings_by_part(const DesignModel& design,
                                                   const FeatureScan& scan, const Watch& watch) {
  std::vector<std::vector<Reading>> parts(design.parts.size());
  watched_loop(scan.scan_design.size(), watch, [&](std::size_t i) {
    const int part = scan.deviations.part[i];
    if (part < 0 || scan.classes[i] == PointClass::kClutter) return;
    const Eigen::Vector3f& point = scan.scan_design.points[i];
    const Eigen::Vector3f& normal = scan.deviations.normal[i];
    if (!point.allFinite() || !normal.allFinite()) return;
    if (scan.eye) {
      const Vector3d ray = (*scan.eye - point.cast<double>()).normalized();
      if (ray.dot(normal.cast<double>()) < kLeastFacing) return;
    }
    parts[static_cast<std::size_t>(part)].push_back({point, normal, scan.deviations.distance_m[i]});
  });
  return parts;
}

std::vector<Eigen::Vector3f> at_most(std::vector<Eigen::Vector3f> points, std::size_t most) {
  if (points.size() <= most) return points;
  std::vector<Eigen::Vector3f> some;
  const double step = static_cast<double>(points.size()) / static_cast<double>(most);
  for (double at = 0; at < static_cast<double>(points.size()); at += step)
    some.push_back(points[static_cast<std::size_t>(at)]);
  return some;
}

int sector_of(double x, double y) {
  const double turn = std::atan2(y, x) / (2 * std::numbers::pi) + 0.5;
  return std::min(kSectors - 1, static_cast<int>(kSectors * turn));
}

// The feature's nominal frame is its measured one, put on the design's line or plane.
struct Fitted {
  PartFeature feature;
  PatchScatter scatter;
};

// A surface so far off that its noise reaches over the bound has lost points there, and what is
// left is drawn towards the design.
bool is_cut(double off_m, double sigma_m, double bound_m) { return off_m + 3 * sigma_m > bound_m; }

// Where a point lies on a pipe: slices along it, sectors about it.
class PipePatches {
 public:
  PipePatches(const PipeShape& shape, int slices) : shape_(shape), slices_(slices) {
    x_ = shape.axis.unitOrthogonal();
    y_ = shape.axis.cross(x_);
  }
  [[nodiscard]] int of(const Eigen::Vector3f& point) const {
    const Vector3d d = point.cast<double>() - shape_.start;
    const double share = d.dot(shape_.axis) / shape_.length_m;
    const int slice = std::clamp(static_cast<int>(slices_ * share), 0, slices_ - 1);
    return slice * kSectors + sector_of(d.dot(x_), d.dot(y_));
  }

 private:
  const PipeShape& shape_;
  int slices_;
  Vector3d x_, y_;
};

// Through an open end a scanner sees the bore, a wall's thickness under the outside that points are
// compared with. Whole patches are told apart, not points: noise may be as thick as a wall, and to
// cut points at half of it would draw the outside outwards.
std::vector<Eigen::Vector3f> without_bore(const PipeShape& shape, const CylinderStart& start,
                                          const std::vector<Eigen::Vector3f>& points) {
  if (!(shape.bore_radius_m > 0)) return points;
  constexpr double kSlice = 0.015;  // m; a hub may hide the outside of as much
  const PipePatches patches(shape, std::max(1, static_cast<int>(shape.length_m / kSlice)));
  const double half_wall = (shape.radius_m - shape.bore_radius_m) / 2;
  CylinderFit fit;
  fit.T_points_cylinder.linear() =
      Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), shape.axis).toRotationMatrix();
  fit.T_points_cylinder.translation() = shape.start;
  fit.radius_m = shape.radius_m;
  std::vector<Eigen::Vector3f> outside;
  constexpr int kRounds = 6;
  for (int round = 0; round < kRounds; ++round) {
    std::map<int, std::pair<double, int>> sums;
    for (const Eigen::Vector3f& p : points) {
      auto& [sum, count] = sums[patches.of(p)];
      sum += fit.distance(p.cast<double>());
      ++count;
    }
    std::vector<Eigen::Vector3f> kept;
    for (const Eigen::Vector3f& p : points)
      if (const auto& [sum, count] = sums.at(patches.of(p)); sum > -half_wall * count)
        kept.push_back(p);
    const bool is_same = kept.size() == outside.size();
    outside = std::move(kept);
    if (is_same) break;
    const CylinderFit next = fit_cylinder(outside, start);
    if (!next.is_determined) break;
    fit = next;
  }
  return outside;
}

std::optional<Fitted> fit_axis(const PipeShape& shape, const std::vector<Reading>& readings,
                               bool is_from_one_side, double correlated, double bound_m,
                               std::string& why) {
  // Near a weld points may be the neighbour's, and the neighbour may be off.
  const double margin = std::min(0.010, shape.length_m / 4);
  std::vector<Eigen::Vector3f> points;
  for (const Reading& each : readings) {
    const Vector3d d = each.point.cast<double>() - shape.start;
    const double along = d.dot(shape.axis);
    const Vector3d aside = d - along * shape.axis;
    const Vector3d normal = each.normal.cast<double>();
    if (along < margin || along > shape.length_m - margin) continue;
    if (normal.dot(aside) < 0.9 * aside.norm()) continue;  // an end's face
    points.push_back(each.point);
  }
  points = at_most(std::move(points), kMostPoints);
  const CylinderStart start{shape.start, shape.axis, shape.radius_m, mill_radius_u(shape.radius_m)};
  // One camera's readings that face away were left out already.
  if (!is_from_one_side) points = without_bore(shape, start, points);
  if (points.size() < kLeastPoints) {
    why = "only " + std::to_string(points.size()) + " points lie on its outside";
    return std::nullopt;
  }
  CylinderStart free_start = start;
  free_start.radius_u_m = std::numeric_limits<double>::infinity();
  const CylinderFit freed = fit_cylinder(points, free_start);
  CylinderFit fit = fit_cylinder(points, start);
  // Of another size: the catalogue's tolerance is of another pipe.
  const double off_m = 2 * std::abs(freed.radius_m - shape.radius_m);
  if (freed.is_determined &&
      off_m - 2 * 2 * std::sqrt(correlated) * freed.error.u(4) > size_tolerance_m(shape.radius_m))
    fit = freed;
  if (!fit.is_determined) {
    why = "its points do not hold one axis";
    return std::nullopt;
  }
  Fitted fitted;
  const PipePatches patches(shape, std::clamp(static_cast<int>(shape.length_m / 0.05), 1, 8));
  for (const std::uint32_t i : fit.inliers)
    fitted.scatter.add(patches.of(points[i]), fit.distance(points[i].cast<double>()));
  fitted.scatter.finish(5, correlated);
  const Vector3d off = (fit.centre() - shape.start).cross(shape.axis);
  const double lean = fit.axis().cross(shape.axis).norm();
  if (is_cut(off.norm() + lean * shape.length_m / 2, fit.sigma_m, bound_m)) {
    why = "it lies too far from where the design has it";
    return std::nullopt;
  }
  PartFeature& feature = fitted.feature;
  if (freed.is_determined) {
    feature.radius_m = freed.radius_m;
    feature.radius_u_m = std::sqrt(correlated) * freed.error.u(4);
  }
  feature.kind = FeatureKind::kAxis;
  feature.T_design_measured = fit.T_points_cylinder;
  feature.T_design_nominal = fit.T_points_cylinder;
  feature.T_design_nominal.linear() =
      Eigen::Quaterniond::FromTwoVectors(fit.axis(), shape.axis) * fit.T_points_cylinder.linear();
  feature.T_design_nominal.translation() =
      shape.start + (fit.centre() - shape.start).dot(shape.axis) * shape.axis;
  const std::array<int, 4> of_motion = {0, 1, 3, 4};
  for (int r = 0; r < 4; ++r)
    for (int c = 0; c < 4; ++c)
      feature.fit_covariance(of_motion[static_cast<std::size_t>(r)],
                             of_motion[static_cast<std::size_t>(c)]) =
          correlated * fit.error.covariance(r, c);
  feature.is_observed = {true, true, false, true, true, false};
  feature.points = fit.inliers.size();
  return fitted;
}

// A flange that stands off by its own thickness shows its back where the design has its face; then
// its face is in front. `face`: as it was fitted, z outward.
bool is_steel_in_front(const PartFeature& face, const FaceShape& shape, const PointCloud& scan,
                       const Watch& watch) {
  constexpr double kNear = 0.008, kFar = 0.045;  // m; a gasket is thinner, flanges mostly are not
  constexpr double kShare = 0.3;                 // of as many points as the face has
  const Eigen::Isometry3f T_face = face.T_design_measured.inverse().cast<float>();
  const Eigen::Vector3f middle = T_face * shape.point.cast<float>();
  const auto reach = static_cast<float>(0.45 * shape.face_diameter_m);
  std::size_t count = 0;
  watched_loop(scan.size(), watch, [&](std::size_t i) {
    const Eigen::Vector3f local = T_face * scan.points[i];  // NaN is nowhere
    if (local.z() > static_cast<float>(kNear) && local.z() < static_cast<float>(kFar) &&
        (local - middle).head<2>().norm() < reach)
      ++count;
  });
  return static_cast<double>(count) > kShare * static_cast<double>(face.points);
}

std::optional<Fitted> fit_face(const FaceShape& shape, const std::vector<Reading>& readings,
                               double correlated, double bound_m, const PointCloud& scan,
                               const Watch& watch, std::string& why) {
  constexpr double kRim = 0.005;     // m; of a face that stands off, points there may be the rim's
  constexpr double kOnLevel = 2e-4;  // m
  std::vector<Eigen::Vector3f> points;
  for (const Reading& each : readings) {
    if (each.normal.cast<double>().dot(shape.normal) < 0.999) continue;
    // Where the point's foot on the design lies along the normal: on one of the forward planes, or
    // on an edge between them.
    const Vector3d d = each.point.cast<double>() - shape.point;
    const double foot = d.dot(shape.normal) - static_cast<double>(each.distance);
    const auto level = std::ranges::find_if(
        shape.levels, [&](double at) { return std::abs(foot - at) < kOnLevel; });
    if (level == shape.levels.end()) continue;
    if ((d - d.dot(shape.normal) * shape.normal).norm() > shape.flange_radius_m - kRim) continue;
    // All planes as one, in the face.
    points.push_back(each.point - (*level * shape.normal).cast<float>());
  }
  points = at_most(std::move(points), kMostPoints);
  if (points.size() < kLeastPoints) {
    why = "only " + std::to_string(points.size()) + " points lie on its face";
    return std::nullopt;
  }
  const PlaneFit fit = fit_plane_robustly(points);
  if (!fit.is_determined || std::abs(fit.normal().dot(shape.normal)) < 0.9) {
    why = "its points do not hold one plane";
    return std::nullopt;
  }
  Fitted fitted;
  PartFeature& feature = fitted.feature;
  feature.kind = FeatureKind::kFace;
  feature.T_design_measured = fit.T_points_plane;
  if (fit.normal().dot(shape.normal) < 0)  // half a turn about x
    feature.T_design_measured.linear() =
        fit.T_points_plane.linear() * Vector3d(1, -1, -1).asDiagonal();
  const Vector3d centre = shape.point - fit.distance(shape.point) * fit.normal();
  for (const std::uint32_t i : fit.inliers) {
    const Vector3d local =
        feature.T_design_measured.linear().transpose() * (points[i].cast<double>() - centre);
    fitted.scatter.add(sector_of(local.x(), local.y()), fit.distance(points[i].cast<double>()));
  }
  fitted.scatter.finish(3, correlated);
  if (fitted.scatter.patches() < 4) {
    why = "too little of its face was seen to know how it leans";
    return std::nullopt;
  }
  feature.T_design_nominal = feature.T_design_measured;
  feature.T_design_nominal.linear() =
      Eigen::Quaterniond::FromTwoVectors(feature.T_design_measured.linear().col(2), shape.normal) *
      feature.T_design_measured.linear();
  const Vector3d off = fit.centre() - shape.point;
  feature.T_design_nominal.translation() = fit.centre() - off.dot(shape.normal) * shape.normal;
  const std::array<int, 3> of_motion = {2, 3, 4};
  for (int k = 0; k < 3; ++k) {
    const int at = of_motion[static_cast<std::size_t>(k)];
    feature.fit_covariance(at, at) = correlated * fit.error.covariance(k, k);
  }
  feature.is_observed = {false, false, true, true, true, false};
  feature.points = fit.inliers.size();
  const double lean = fit.normal().cross(shape.normal).norm();
  if (is_cut(std::abs(off.dot(shape.normal)) + lean * shape.flange_radius_m, fit.sigma_m,
             bound_m)) {
    why = "it lies too far from where the design has it";
    return std::nullopt;
  }
  if (is_steel_in_front(feature, shape, scan, watch)) {
    why = "steel stands in front of what lies where its face should be";
    return std::nullopt;
  }
  return fitted;
}

// What the sensor's warp does to a feature. Taken for a bulge w (r / h)^2 that is `warp_u_m` at the
// edge h of the field, and a feature for anywhere in it, it shifts it by w / sqrt(3) and leans it
// by w / h about each axis (root mean squares over the disc).
Matrix6d warp_of(double warp_u_m, double half_width_m) {
  Matrix6d covariance = Matrix6d::Zero();
  const double shift2 = warp_u_m * warp_u_m / 3;
  const double lean = half_width_m > 0 ? warp_u_m / half_width_m : 0;
  covariance.diagonal() << shift2, shift2, shift2, lean * lean, lean * lean, lean * lean;
  return covariance;
}

void hold(const std::array<bool, 6>& is_observed, Matrix6d& covariance) {
  for (int i = 0; i < 6; ++i)
    if (!is_observed[static_cast<std::size_t>(i)]) {
      covariance.row(i).setZero();
      covariance.col(i).setZero();
    }
}

// Beyond these standard uncertainties an answer is none, and what is computed from it is no longer
// proportional to its error.
bool is_hardly_held(const PartFeature& feature) {
  constexpr double kMostM = 0.01, kMostRad = 0.05;
  const Vector6d u = feature.fit_covariance.diagonal().cwiseSqrt();
  return u.head<3>().maxCoeff() > kMostM || u.tail<3>().maxCoeff() > kMostRad;
}

std::size_t at(int index) { return static_cast<std::size_t>(index); }

}  // namespace

int PartFeatures::of(int part) const {
  for (std::size_t i = 0; i < features.size(); ++i)
    if (features[i].part == part && features[i].kind != FeatureKind::kHoles)
      return static_cast<int>(i);
  return -1;
}

int PartFeatures::holes_of(int part) const {
  for (std::size_t i = 0; i < features.size(); ++i)
    if (features[i].part == part && features[i].kind == FeatureKind::kHoles)
      return static_cast<int>(i);
  return -1;
}

PartFeatures measure_features(const DesignModel& design, const FeatureScan& scan,
                              const Watch& watch) {
  PartFeatures all;
  all.why_not.resize(design.parts.size());
  all.why_no_holes.resize(design.parts.size());
  const auto readings = readings_by_part(design, scan, watch);
  ScatterPool pool;
  std::vector<Fitted> fits;
  for (std::size_t p = 0; p < design.parts.size() && !watch.cancelled(); ++p) {
    std::optional<Fitted> fitted;
    if (const auto pipe = pipe_shape(design, static_cast<int>(p)))
      fitted = fit_axis(*pipe, readings[p], scan.eye.has_value(), scan.correlated, scan.bound_m,
                        all.why_not[p]);
    else if (const auto face = face_shape(design, static_cast<int>(p)))
      fitted = fit_face(*face, readings[p], scan.correlated, scan.bound_m, scan.scan_design, watch,
                        all.why_not[p]);
    if (!fitted) continue;
    fitted->feature.part = static_cast<int>(p);
    pool.add(fitted->scatter);
    fits.push_back(std::move(*fitted));
  }
  all.patch_error_m = pool.error_m();
  const double together = all.patch_error_m * all.patch_error_m;
  const double half_width = 0.5 * design.bounds().diagonal().norm();
  for (Fitted& fitted : fits) {
    PartFeature& feature = fitted.feature;
    const double birge = std::max(pool.birge(), fitted.scatter.birge());
    feature.fit_covariance *= birge;
    feature.fit_covariance.diagonal().head<3>().array() += together;
    feature.radius_u_m = std::hypot(std::sqrt(birge) * feature.radius_u_m, all.patch_error_m);
    feature.warp_covariance = warp_of(scan.warp_u_m, half_width);
    hold(feature.is_observed, feature.fit_covariance);
    hold(feature.is_observed, feature.warp_covariance);
    if (is_hardly_held(feature))
      all.why_not[at(feature.part)] = "too little of it was seen to know how it lies";
    else
      all.features.push_back(feature);
  }
  return all;
}

}  // namespace spool
