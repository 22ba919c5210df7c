// The error of every joint against the one before it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/measure/joint_errors.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "vision/measure/part_shapes.h"

namespace spool {
namespace {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

std::size_t at(int index) { return static_cast<std::size_t>(index); }

// A variance under this (m^2, rad^2) is of what is not observed.
constexpr double kNothing = 1e-20;

Pose motion_of(const Pose& T_design_joint, const Vector6d& error) {
  Pose E = Pose::Identity();
  E.linear() = rotation_from_vector(error.tail<3>());
  E.translation() = error.head<3>();
  return T_design_joint * E * T_design_joint.inverse();
}

class Measuring {
 public:
  Measuring(const DesignModel& design, const Drawing& drawing, const PartFeatures& features,
            const RuleSet& rules, double scale_u, const Watch& watch)
      : design_(design),
        features_(features),
        rules_(rules),
        scale_u_(scale_u),
        watch_(watch),
        chain_(joint_chain(design, drawing, features)) {}

  ChainResult all() {
    result_.datum = chain_.text;
    result_.is_turn_held = chain_.turn.holes >= 0;
    if (chain_.root < 0) {
      for (std::size_t j = 0; j < design_.joints.size(); ++j)
        refuse(static_cast<int>(j), design_.joints[j].part_a, design_.joints[j].part_b,
               result_.datum);
      return std::move(result_);
    }
    find_ends();
    propagate_all();
    if (watch_.cancelled()) return {};
    for (std::size_t l = 0; l < chain_.links.size(); ++l) add_joint(static_cast<int>(l));
    for (std::size_t e = 0; e < result_.ends.size(); ++e) add_end(e);
    weigh();
    for (const LooseJoint& loose : chain_.loose)
      refuse(loose.joint, loose.part_near, loose.part_far,
             "beyond it no pipe's axis and no face is known: " + why_not(loose.part_far));
    refuse_unreached();
    return std::move(result_);
  }

 private:
  [[nodiscard]] const PartFeature& feature(int index) const {
    return features_.features[at(index)];
  }

  [[nodiscard]] std::string why_not(int part) const {
    const std::string& why = features_.why_not[at(part)];
    const std::string& name = design_.parts[at(part)].name;
    return why.empty() ? name + " ends there" : name + ": " + why;
  }

  // Links that no other hangs on.
  void find_ends() {
    for (std::size_t l = 0; l < chain_.links.size(); ++l) {
      const bool is_last = std::ranges::none_of(chain_.links, [&](const ChainLink& other) {
        return other.before == static_cast<int>(l);
      });
      if (!is_last) continue;
      const ChainLink& link = chain_.links[l];
      const int p = feature(link.to).part;
      const Part& part = design_.parts[at(p)];
      int port = face_port(part);
      if (port < 0) {  // the one that lies furthest from the joint
        double most = -1;
        for (std::size_t i = 0; i < part.ports.size(); ++i) {
          const double away =
              (part.T_design_part * part.ports[i].position - link.T_design_joint.translation())
                  .norm();
          if (away <= most) continue;
          most = away;
          port = static_cast<int>(i);
        }
      }
      if (port < 0) continue;
      ChainEnd end{.end = part.name + "/" + part.ports[at(port)].name, .part = p};
      end.place = part.T_design_part * part.ports[at(port)].position;
      const auto tolerance = length_tolerance(
          rules_, part.nps,
          (end.place - feature(chain_.root).T_design_nominal.translation()).norm());
      end.tolerance_m = tolerance ? tolerance->value : 0;
      end_links_.push_back(static_cast<int>(l));
      result_.ends.push_back(std::move(end));
    }
  }

  // Every link's error, then every end's displacement.
  [[nodiscard]] VectorXd numbers(const FeatureState& state) const {
    const ChainState motions = chain_state(chain_, features_, state);
    VectorXd all(6 * links() + 3 * static_cast<Eigen::Index>(end_links_.size()));
    for (Eigen::Index l = 0; l < links(); ++l)
      all.segment<6>(6 * l) = link_error(chain_, static_cast<int>(l), motions);
    for (std::size_t e = 0; e < end_links_.size(); ++e)
      all.segment<3>(6 * links() + 3 * static_cast<Eigen::Index>(e)) =
          motions.root.inverse() * motions.links[at(end_links_[e])] * result_.ends[e].place -
          result_.ends[e].place;
    return all;
  }

  [[nodiscard]] Eigen::Index links() const {
    return static_cast<Eigen::Index>(chain_.links.size());
  }

  // As propagate(), with the columns kept: a link's covariance is taken of its own rows alone, that
  // of a long line would not fit. The last column is the scale's.
  void propagate_all() {
    FeatureState measured;
    for (const PartFeature& each : features_.features) measured.push_back(each.T_design_measured);
    motions_ = chain_state(chain_, features_, measured);
    values_ = numbers(measured);
    const auto count = static_cast<Eigen::Index>(measured.size());
    slope_ = MatrixXd::Zero(values_.size(), 6 * count + 1);
    constexpr double kStep = 1e-5;  // m, rad, 1: all is straight over it
    FeatureState moved = measured;
    for (std::size_t f = 0; f < measured.size() && !watch_.cancelled(); ++f) {
      for (int k = 0; k < 6; ++k) {
        if (!feature(static_cast<int>(f)).is_observed[at(k)]) continue;
        moved[f] = measured[f] * pose_from_small(kStep * Vector6d::Unit(k));
        const VectorXd there = numbers(moved);
        moved[f] = measured[f] * pose_from_small(-kStep * Vector6d::Unit(k));
        slope_.col(6 * static_cast<Eigen::Index>(f) + k) = (there - numbers(moved)) / (2 * kStep);
      }
      moved[f] = measured[f];
    }
    const auto scaled = [&](double by) {
      for (std::size_t f = 0; f < measured.size(); ++f)
        moved[f].translation() = (1 + by) * measured[f].translation();
      return numbers(moved);
    };
    slope_.col(6 * count) = (scaled(kStep) - scaled(-kStep)) / (2 * kStep);
  }

  [[nodiscard]] MatrixXd covariance(Eigen::Index first, Eigen::Index rows) const {
    MatrixXd sum = MatrixXd::Zero(rows, rows);
    for (std::size_t f = 0; f < features_.features.size(); ++f) {
      const auto part = slope_.block(first, 6 * static_cast<Eigen::Index>(f), rows, 6);
      const PartFeature& each = features_.features[f];
      sum += part * (each.fit_covariance + each.warp_covariance) * part.transpose();
    }
    const VectorXd scale = slope_.col(slope_.cols() - 1).segment(first, rows);
    return sum + scale_u_ * scale_u_ * scale * scale.transpose();
  }

  void add_joint(int l) {
    const ChainLink& link = chain_.links[at(l)];
    JointError joint = named(link.joints, feature(link.from).part, feature(link.to).part);
    joint.is_measured = true;
    joint.T_design_joint = link.T_design_joint;
    joint.T_design_near =
        (link.before < 0 ? motions_.root : motions_.links[at(link.before)]) * link.T_design_joint;
    joint.parts = link.parts;
    joint.error = values_.segment<6>(6 * l);
    joint.covariance = covariance(6 * l, 6);
    find_unobserved(link, joint);
    for (int k = 0; k < 6; ++k) {
      if (!is_chosen(link, k) && joint.covariance(k, k) > kNothing) continue;
      joint.covariance.row(k).setZero();
      joint.covariance.col(k).setZero();
      joint.error[k] = 0;
    }
    result_.joints.push_back(std::move(joint));
  }

  // Whether chain_state() chose that component of the error to be none; what is left of it is of
  // second order and says nothing.
  [[nodiscard]] bool is_chosen(const ChainLink& link, int k) const {
    const PartFeature& to = feature(link.to);
    const Matrix3d R_joint_design = link.T_design_joint.linear().transpose();
    const auto is_along = [&](const PartFeature& which) {
      return std::abs((R_joint_design * which.T_design_nominal.linear().col(2))[k % 3]) > 0.7;
    };
    const bool is_turn = k >= 3;
    if (link.is_clock && is_along(feature(chain_.root)) && (is_turn || chain_.face < 0))
      return true;
    if (to.kind == FeatureKind::kAxis) {
      const Vector3d p = R_joint_design * to.T_design_nominal.linear().col(2);
      return k % 3 == (is_bend(p) ? 0 : 2);
    }
    return is_turn ? is_along(to) && link.turn.holes < 0 : !is_along(to);
  }

  void find_unobserved(const ChainLink& link, JointError& joint) const {
    const PartFeature& to = feature(link.to);
    const Matrix3d R_joint_design = link.T_design_joint.linear().transpose();
    const Matrix3d R = R_joint_design * to.T_design_nominal.linear();
    const std::string& name = design_.parts[at(to.part)].name;
    const auto add = [&](const Vector3d& way, bool is_turn, std::string text) {
      Vector6d direction = Vector6d::Zero();
      direction.segment<3>(is_turn ? 3 : 0) = way;
      joint.unobserved.push_back({direction, std::move(text)});
    };
    const bool is_axis = to.kind == FeatureKind::kAxis;
    for (int k = 0; k < 3; ++k)
      if (!to.is_observed[at(k)])
        add(R.col(k), false,
            is_axis ? "a shift along " + name + " (it counts as cut length, where the pipe ends)"
                    : "a shift of " + name + " in the plane of its face");
    if (link.turn.holes < 0)
      add(R.col(2), true, "a turn of " + name + (is_axis ? " about itself" : " in its face"));
    const std::string& root = design_.parts[at(feature(chain_.root).part)].name;
    const Vector3d root_axis =
        R_joint_design * feature(chain_.root).T_design_nominal.linear().col(2);
    if (link.is_clock) add(root_axis, true, "a turn about " + root + ": nothing nearer holds it");
    if (chain_.face < 0 && link.is_clock)
      add(root_axis, false, "a shift along " + root + ": its end is not known");
  }

  [[nodiscard]] JointError named(const std::vector<int>& joints, int near, int far) const {
    JointError joint;
    joint.joints = joints;
    joint.part_near = near;
    joint.part_far = far;
    for (const int j : joints) {
      const std::string& weld = design_.joints[at(j)].weld;
      joint.weld += (joint.weld.empty() ? "" : "+") + (weld.empty() ? "?" : weld);
    }
    const auto port = [&](int j, int part) {
      const Joint& here = design_.joints[at(j)];
      const Part& of = design_.parts[at(part)];
      return of.name + "/" + of.ports[at(here.part_a == part ? here.port_a : here.port_b)].name;
    };
    joint.near_port = port(joints.front(), near);
    joint.far_port = port(joints.back(), far);
    return joint;
  }

  void refuse(int joint, int near, int far, const std::string& why) {
    JointError error = named({joint}, near, far);
    error.reason = "Not measured: " + why;
    result_.joints.push_back(std::move(error));
  }

  void refuse_unreached() {
    std::vector<bool> is_said(design_.joints.size(), false);
    for (const JointError& error : result_.joints)
      for (const int j : error.joints) is_said[at(j)] = true;
    for (std::size_t j = 0; j < is_said.size(); ++j)
      if (!is_said[j])
        refuse(static_cast<int>(j), design_.joints[j].part_a, design_.joints[j].part_b,
               "it lies in a loop, or nothing joins it to the datum");
  }

  void add_end(std::size_t e) {
    ChainEnd& end = result_.ends[e];
    const Eigen::Index row = 6 * links() + 3 * static_cast<Eigen::Index>(e);
    end.displacement_m = values_.segment<3>(row);
    end.displacement_covariance = covariance(row, 3);
    end.tilt_rad = rotation_vector(motions_.root.linear().transpose() *
                                   motions_.links[at(end_links_[e])].linear());
    for (int l = end_links_[e]; l >= 0; l = chain_.links[at(l)].before) {
      JointError& joint = result_.joints[at(l)];
      EndEffect effect{.end = end.end};
      const Pose motion = error_motion(joint, joint.error);
      effect.displacement_m = motion * end.place - end.place;
      effect.tilt_rad = rotation_vector(motion.linear());
      // d (t + w x r): r from the joint to the end.
      const Matrix3d R = joint.T_design_joint.linear();
      const Vector3d r = end.place - joint.T_design_joint.translation();
      Matrix3d cross;
      cross << 0, -r.z(), r.y(), r.z(), 0, -r.x(), -r.y(), r.x(), 0;
      Eigen::Matrix<double, 3, 6> slope;
      slope << R, -cross * R;
      effect.displacement_covariance = slope * joint.covariance * slope.transpose();
      joint.ends.push_back(std::move(effect));
    }
  }

  [[nodiscard]] double against_tolerance(const JointError& joint) const {
    double most = 0;
    const auto against = [&](double size, double tolerance) {
      if (tolerance > 0) most = std::max(most, size / tolerance);
    };
    const Part& part = design_.parts[at(joint.part_far)];
    double long_m = 0;  // the pipe that is cut, else the one that it is cut for
    for (const int p : {joint.part_far, joint.part_near})
      if (const auto pipe = pipe_shape(design_, p)) long_m = pipe->length_m;
    if (const auto length = length_tolerance(rules_, part.nps, long_m)) {
      against(std::abs(joint.error[2]), length->value);
      against(joint.error.head<2>().norm(), length->value);
    }
    std::optional<Tolerance> angle;
    if (const auto face = face_shape(design_, joint.part_far))
      angle = alignment_tolerance(rules_, face->face_diameter_m);
    else if (const auto pipe = pipe_shape(design_, joint.part_far))
      angle = angle_tolerance(rules_, pipe->length_m, 2 * pipe->radius_m);
    if (angle) against(joint.error.segment<2>(3).norm(), angle->value);
    for (const EndEffect& effect : joint.ends)
      for (const ChainEnd& end : result_.ends)
        if (end.end == effect.end) against(effect.displacement_m.norm(), end.tolerance_m);
    return most;
  }

  void weigh() {
    const int count = observed_groups(result_.joints);
    double all = 0;
    JointError* worst = nullptr;
    for (JointError& joint : result_.joints) {
      joint.against_tolerance = against_tolerance(joint);
      for (const ErrorGroup& group : error_groups())
        joint.is_significant =
            joint.is_significant || chance_of(joint, group) < kJointLevel / count;
      if (!joint.is_significant) continue;
      all += joint.against_tolerance;
      if (worst == nullptr || joint.against_tolerance > worst->against_tolerance) worst = &joint;
    }
    if (worst == nullptr || !(all > 0)) return;  // no rule says what it could be too much for
    worst->is_to_blame = true;
    for (JointError& joint : result_.joints)
      if (joint.is_significant) joint.blame = joint.against_tolerance / all;
  }

  const DesignModel& design_;
  const PartFeatures& features_;
  const RuleSet& rules_;
  double scale_u_ = 0;
  const Watch& watch_;
  JointChain chain_;
  ChainResult result_;
  std::vector<int> end_links_;  // one an end
  ChainState motions_;
  VectorXd values_;
  MatrixXd slope_;
};

}  // namespace

ChainResult measure_joints(const DesignModel& design, const Drawing& drawing,
                           const PartFeatures& features, const RuleSet& rules, double scale_u,
                           const Watch& watch) {
  return Measuring(design, drawing, features, rules, scale_u, watch).all();
}

const std::vector<ErrorGroup>& error_groups() {
  static const std::vector<ErrorGroup> kGroups = {{BumpKind::kShift, {0, 1}},
                                                  {BumpKind::kLength, {2}},
                                                  {BumpKind::kTilt, {3, 4}},
                                                  {BumpKind::kTurn, {5}}};
  return kGroups;
}

double chance_of(const JointError& error, const ErrorGroup& group) {
  std::vector<int> seen;
  for (const int k : group.components)
    if (error.covariance(k, k) > kNothing) seen.push_back(k);
  if (!error.is_measured || seen.empty()) return 1;
  if (seen.size() == 1) {
    const int k = seen.front();
    return std::erfc(std::abs(error.error[k]) / std::sqrt(2 * error.covariance(k, k)));
  }
  Eigen::Vector2d e(error.error[seen[0]], error.error[seen[1]]);
  Eigen::Matrix2d C;
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) C(i, j) = error.covariance(seen[at(i)], seen[at(j)]);
  return std::exp(-0.5 * e.dot(C.inverse() * e));  // chi-squared of two degrees of freedom
}

int observed_groups(const std::vector<JointError>& errors) {
  int count = 0;
  for (const JointError& error : errors)
    for (const ErrorGroup& group : error_groups())
      for (const int k : group.components)
        if (error.is_measured && error.covariance(k, k) > kNothing) {
          ++count;
          break;
        }
  return count;
}

Pose error_motion(const JointError& joint, const Vector6d& error) {
  return motion_of(joint.T_design_joint, error);
}

}  // namespace spool
