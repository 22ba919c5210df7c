// Where each part stands against the drawing, by the features at it, the measured datum aligned.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/measure/part_poses.h"

#include <algorithm>
#include <array>
#include <optional>

#include <Eigen/Cholesky>

#include "vision/measure/feature_geometry.h"
#include "vision/measure/pose_datum.h"
#include "vision/measure/pose_evidence.h"
#include "vision/measure/weak_motions.h"

namespace spool {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

std::size_t at(int index) { return static_cast<std::size_t>(index); }

constexpr double kStep = 1e-5;  // m, rad, 1: all is straight over it

Vector6d small_of(const Pose& pose) {
  Vector6d small;
  small << pose.translation(), rotation_vector(pose.linear());
  return small;
}

// What chi-squared of so many components exceeds once in a thousand times.
double chance_limit(std::size_t components) {
  constexpr std::array<double, 7> kLimits = {0, 10.83, 13.82, 16.27, 18.47, 20.52, 22.46};
  return kLimits[components];
}

class Measuring {
 public:
  Measuring(const DesignModel& design, const Drawing& drawing, const PartFeatures& features,
            const RuleSet& rules, double scale_u)
      : design_(design),
        features_(features),
        rules_(rules),
        scale_u_(scale_u),
        geometry_(design, drawing, features),
        datum_(pose_datum(design, drawing, features, geometry_)),
        measured_(geometry_.measured()) {
    if (!datum_.T_design_datum) return;
    T_design_datum_ = datum_.T_design_datum(geometry_.nominal());
    find_features_of_datum();
  }

  [[nodiscard]] PartPose pose_of(int part) const {
    PartPose pose;
    if (!datum_.T_design_datum) {
      pose.reason = datum_.text;
      return pose;
    }
    const std::vector<PoseEvidence> evidence = pose_evidence(design_, features_, rules_, part);
    if (evidence.empty()) {
      pose.reason = why_not(part);
      return pose;
    }
    pose.is_measured = true;
    pose.datum = datum_.text;
    for (const PoseEvidence& each : evidence) pose.rests_on.push_back(each.text);
    estimate(part, evidence, pose);
    tell_weak(part, evidence, pose);
    const std::size_t held = 6 - pose.weak.size();
    pose.is_off =
        held > 0 && pose.error.dot(pose.covariance.ldlt().solve(pose.error)) > chance_limit(held);
    return pose;
  }

 private:
  // Those that move the datum frame.
  void find_features_of_datum() {
    const Pose before = datum_.T_design_datum(measured_);
    FeatureState moved = measured_;
    for (std::size_t f = 0; f < measured_.size(); ++f) {
      const Vector6d any = Vector6d::Constant(1e-3);
      moved[f] = measured_[f] * pose_from_small(any);
      if (!datum_.T_design_datum(moved).isApprox(before, 1e-12))
        of_datum_.push_back(static_cast<int>(f));
      moved[f] = measured_[f];
    }
  }

  [[nodiscard]] std::string why_not(int part) const {
    const std::string& why = features_.why_not[at(part)];
    if (!why.empty()) return "Not measured: " + why;
    return "Not measured: neither it nor what is welded to it has an axis or a face that is known";
  }

  // Maps the design frame, as features in `state` are in it, into the part's nominal frame.
  [[nodiscard]] Pose T_part_state(int part, const FeatureState& state) const {
    return design_.parts[at(part)].T_design_part.inverse() * T_design_datum_ *
           datum_.T_design_datum(state).inverse();
  }

  [[nodiscard]] VectorXd residuals(int part, const std::vector<PoseEvidence>& evidence,
                                   const Pose& error, const FeatureState& state) const {
    Eigen::Index rows = 0;
    for (const PoseEvidence& each : evidence) rows += each.rows();
    VectorXd all(rows);
    const Pose T = T_part_state(part, state);
    Eigen::Index row = 0;
    for (const PoseEvidence& each : evidence) {
      all.segment(row, each.rows()) = residual_of(each, error, T, state);
      row += each.rows();
    }
    return all;
  }

  // Of the residuals: features, scale, welds.
  [[nodiscard]] MatrixXd covariance(int part, const std::vector<PoseEvidence>& evidence,
                                    const Pose& error) const {
    std::vector<int> features = of_datum_;
    for (const PoseEvidence& each : evidence)
      for (const int f : {each.feature, each.own_axis})
        if (f >= 0 && std::ranges::find(features, f) == features.end()) features.push_back(f);
    const Propagated of_features = propagate(
        [&](const FeatureState& state) { return residuals(part, evidence, error, state); },
        features_, measured_, features);
    const auto scaled = [&](double by) {
      FeatureState state = measured_;
      for (Pose& each : state) each.translation() *= 1 + by;
      return residuals(part, evidence, error, state);
    };
    const VectorXd scale = scale_u_ * (scaled(kStep) - scaled(-kStep)) / (2 * kStep);
    MatrixXd sum = of_features.fit + of_features.warp + scale * scale.transpose();
    // What defines the datum is known beyond doubt and would have no inverse: nothing is known
    // better than a micrometre and a microradian.
    sum.diagonal().array() += 1e-12;
    Eigen::Index row = 0;
    for (const PoseEvidence& each : evidence) {
      for (Eigen::Index k = 0; k < each.rows(); ++k) {
        const Eigen::Index lengths = each.kind == PoseHold::kLine    ? 2
                                     : each.kind == PoseHold::kPlane ? 1
                                     : each.kind == PoseHold::kStop  ? 1
                                                                     : 0;
        const double u = k < lengths ? each.weld_u_m : each.weld_u_rad;
        sum(row + k, row + k) += u * u;
      }
      row += each.rows();
    }
    return sum;
  }

  void estimate(int part, const std::vector<PoseEvidence>& evidence, PartPose& pose) const {
    Pose error = Pose::Identity();
    constexpr double kPrior = 1 / (kUnobservedSigma * kUnobservedSigma);
    Matrix6d information = Matrix6d::Zero();
    for (int round = 0; round < 2; ++round) {  // the covariance where the part really stands
      const MatrixXd doubt = covariance(part, evidence, error);
      const MatrixXd weight = doubt.ldlt().solve(MatrixXd::Identity(doubt.rows(), doubt.cols()));
      for (int step = 0; step < 8; ++step) {
        const VectorXd off = residuals(part, evidence, error, measured_);
        MatrixXd slope(off.size(), 6);
        for (int k = 0; k < 6; ++k) {
          const auto moved = [&](double by) {
            return residuals(part, evidence, error * pose_from_small(by * Vector6d::Unit(k)),
                             measured_);
          };
          slope.col(k) = (moved(kStep) - moved(-kStep)) / (2 * kStep);
        }
        information = slope.transpose() * weight * slope + kPrior * Matrix6d::Identity();
        const Vector6d pull = -slope.transpose() * weight * off - kPrior * small_of(error);
        const Vector6d move = information.ldlt().solve(pull);
        error = error * pose_from_small(move);
        if (move.norm() < 1e-10) break;
      }
    }
    pose.error = small_of(error);
    pose.covariance = information.ldlt().solve(Matrix6d::Identity());
    if (!datum_.is_turn_held) {
      const Vector6d turn = turn_about_datum(part);
      pose.covariance += kUnobservedSigma * kUnobservedSigma * turn * turn.transpose();
    }
    pose.covariance = 0.5 * (pose.covariance + pose.covariance.transpose()).eval();
  }

  [[nodiscard]] Vector6d turn_about_datum(int part) const {
    return turn_about(design_.parts[at(part)].T_design_part.inverse() * T_design_datum_);
  }

  void tell_weak(int part, const std::vector<PoseEvidence>& evidence, PartPose& pose) const {
    std::vector<NamedMotion> named;
    if (!datum_.is_turn_held)
      named.push_back({turn_about_datum(part),
                       "a turn about the datum's axis, which nothing that was measured holds"});
    for (const PoseEvidence& each : evidence) {
      const PartFeature& feature = features_.features[at(each.feature)];
      const bool is_own = feature.part == part;
      const std::string of = is_own ? std::string() : " of " + design_.parts[at(feature.part)].name;
      const Pose& frame = each.T_part_nominal;
      if (each.kind == PoseHold::kLine) {
        named.push_back({shift_along(frame, 2), "a slide along " + axis_words(is_own, of)});
        named.push_back({turn_about(frame), "a turn about " + axis_words(is_own, of)});
      } else if (each.kind == PoseHold::kPlane) {
        for (const int k : {0, 1})
          named.push_back(
              {shift_along(frame, k),
               "a shift in the plane of " + std::string(is_own ? "its face" : "the face") + of});
        named.push_back(
            {turn_about(frame), "a turn in " + std::string(is_own ? "its face" : "the face") + of});
      }
    }
    pose.weak = weak_motions(pose.covariance, named);
  }

  [[nodiscard]] static std::string axis_words(bool is_own, const std::string& of) {
    return is_own ? "its axis" : "the axis" + of;
  }

  const DesignModel& design_;
  const PartFeatures& features_;
  const RuleSet& rules_;
  double scale_u_ = 0;
  FeatureGeometry geometry_;
  PoseDatum datum_;
  FeatureState measured_;
  Pose T_design_datum_ = Pose::Identity();  // nominal
  std::vector<int> of_datum_;
};

}  // namespace

std::vector<PartPose> measure_part_poses(const DesignModel& design, const Drawing& drawing,
                                         const PartFeatures& features, const RuleSet& rules,
                                         double scale_u, const Watch& watch) {
  const Measuring measuring(design, drawing, features, rules, scale_u);
  std::vector<PartPose> poses;
  for (std::size_t part = 0; part < design.parts.size(); ++part) {
    if (watch.cancelled()) return {};
    poses.push_back(measuring.pose_of(static_cast<int>(part)));
  }
  return poses;
}

}  // namespace spool
