// Where the datum is, from the readings on all parts: each counts as far as its joints hold it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/inspect/datum_fit.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/LU>

namespace spool {
namespace {

constexpr float kTukey = 4.685F;            // standard deviations (Holland & Welsch 1977)
constexpr float kLeastAlike = 0.7F;         // cosine between a reading's normal and the surface's
constexpr double kContradiction = 16.81;    // chi-squared, 6 degrees of freedom, 1 %
constexpr std::size_t kFewestOfAPart = 10;  // readings; fewer say nothing of its place

// Of motions at `at` with these standard deviations, those along and about `free` not held.
Matrix6d information_of(const Eigen::Vector3d& at, double sigma_m, double sigma_rad,
                        const Eigen::Vector3d& free = Eigen::Vector3d::Zero()) {
  constexpr double kLeft = 1e-6;  // of the information along `free`: as good as none
  const Eigen::Matrix3d held = Eigen::Matrix3d::Identity() - (1 - kLeft) * free * free.transpose();
  Matrix6d there = Matrix6d::Zero();
  there.topLeftCorner<3, 3>() = held / (sigma_m * sigma_m);
  there.bottomRightCorner<3, 3>() = held / (sigma_rad * sigma_rad);
  const Matrix6d a = motion_told_at(at);
  return a.transpose() * there * a;
}

// What is left of b^T information^-1 b for the best motion: the squared misfit that one explains.
double explained(const Matrix6d& information, const Vector6d& gradient) {
  return gradient.dot(information.ldlt().solve(gradient));
}

// What is known of a place along one axis, averaged over the axes: 1/m^2, the same at any origin.
double along_one_axis(const MotionKnowledge& knowledge) {
  return knowledge.information.topLeftCorner<3, 3>().trace() / 3;
}

// The mean of a part's corners; of a part without a mesh where its frame stands.
Eigen::Vector3d middle_of(const DesignModel& design, int part) {
  const Part& it = design.parts[static_cast<std::size_t>(part)];
  if (it.triangle_count == 0) return it.T_design_part.translation();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::uint32_t t = 0; t < it.triangle_count; ++t)
    for (const std::uint32_t vertex : design.mesh.triangles[it.first_triangle + t])
      sum += design.mesh.vertices[vertex].cast<double>();
  return sum / (3.0 * it.triangle_count);
}

}  // namespace

DatumFit::DatumFit(const DesignModel& design, const DatumFitOptions& options)
    : options_(options),
      allowance2_(design.parts.size(), 0.0F),
      prior_{information_of(design.bounds().center(), options.prior_m, options.prior_rad)},
      own_(design.parts.size()),
      matches_(design.parts.size()) {
  if (design.datums.empty()) return;
  tree_ = joint_tree(design);
  root_ = design.datums.front();
  const Part& datum = design.parts[static_cast<std::size_t>(root_)];
  if (datum.holes && datum.holes->count > 0 && datum.holes->bolt_circle_m > 0) {
    holes_.emplace(*datum.holes, BoltPhaseOptions{.look_s = options.look_s});
    hole_axis_ = datum.T_design_part.linear().col(2);
  }
  for (const JointBranch& branch : tree_) {
    // Breadth first, so the nearer part's allowance is known. A joint's angle tells at the far
    // part's middle.
    const double lever =
        (middle_of(design, branch.part_far) - branch.frame.point.cast<double>()).norm();
    const double joint2 =
        options.joint_m * options.joint_m + lever * lever * options.joint_rad * options.joint_rad;
    allowance2_[static_cast<std::size_t>(branch.part_far)] =
        allowance2_[static_cast<std::size_t>(branch.part_near)] + static_cast<float>(joint2);
  }
}

void DatumFit::clear() {
  std::fill(own_.begin(), own_.end(), MotionKnowledge{});
  prior_.gradient.setZero();
  if (holes_) holes_->clear();
}

void DatumFit::add(const DatumReadings& readings) {
  const Deviations& deviations = readings.deviations;
  const std::size_t count = deviations.part.size();
  assert(readings.scan_design.points.size() == count && readings.variance_m2.size() == count);
  fade(options_.drift_m * options_.drift_m * std::max(0.0, readings.passed_s));
  // Of what a look tells, as much as it lasts. What comes after a while is a look of its own.
  const double fresh = std::min(1.0, readings.passed_s / options_.look_s);

  std::size_t near = 0;
  for (const std::int32_t part : deviations.part) near += part >= 0 ? 1U : 0U;
  const std::size_t step = near / options_.most_points + 1;
  constexpr float kUnit = 1e-6F;  // m^2, what a weight of one stands for
  for (auto& of_part : matches_) of_part.clear();
  std::size_t seen = 0;
  const bool has_normals = !readings.scan_design.normals.empty();
  for (std::size_t i = 0; i < count; ++i) {
    const std::int32_t part = deviations.part[i];
    if (part < 0 || seen++ % step != 0) continue;
    const float variance = readings.variance_m2[i];
    const float width2 =
        kTukey * kTukey * (variance + allowance2_[static_cast<std::size_t>(part)]) +
        static_cast<float>(readings.wide_m * readings.wide_m);
    const float u2 = deviations.distance_m[i] * deviations.distance_m[i] / width2;
    if (!(u2 < 1)) continue;
    // Beyond an edge the nearest surface is not the one that was seen.
    if (has_normals && readings.scan_design.normals[i].dot(deviations.normal[i]) < kLeastAlike)
      continue;
    const float weight = (1 - u2) * (1 - u2) * kUnit / variance;
    matches_[static_cast<std::size_t>(part)].push_back(
        {readings.scan_design.points[i], deviations.normal[i], deviations.distance_m[i], weight});
  }
  const double worth = std::max(1.0, readings.correlated / static_cast<double>(step));
  for (std::size_t part = 0; part < own_.size(); ++part) {
    if (matches_[part].size() < kFewestOfAPart) continue;
    const NormalEquations equations = build_normal_equations(matches_[part]);
    if (equations.weight <= 0) continue;
    MotionKnowledge look =
        held_knowledge(equations, held_motions(equations, matches_[part]), double{kUnit} * worth);
    look *= fresh / (1 + options_.bias_m * options_.bias_m * along_one_axis(look));
    own_[part] += look;
  }
  if (holes_ && readings.holes != nullptr) holes_->add(*readings.holes, readings.passed_s);
}

// What the datum's bolt holes say of its turn about its axis.
MotionKnowledge DatumFit::turn_of_datum() const {
  MotionKnowledge told;
  if (!holes_) return told;
  const std::optional<BoltTurn> turn = holes_->turn();
  if (!turn) return told;
  const double weight = 1 / (turn->sigma_rad * turn->sigma_rad);
  told.information.bottomRightCorner<3, 3>() = weight * hole_axis_ * hole_axis_.transpose();
  told.gradient.tail<3>() = -weight * turn->turn_rad * hole_axis_;
  return told;
}

// 1 / (v + variance) in place of 1 / v of each part's place along an axis.
void DatumFit::fade(double variance_m2) {
  for (MotionKnowledge& knowledge : own_)
    knowledge *= 1 / (1 + variance_m2 * along_one_axis(knowledge));
}

// What the far side says of the near one: the joint adds its own variance.
MotionKnowledge DatumFit::through(const JointBranch& joint, Hold hold,
                                  const MotionKnowledge& beyond) const {
  if (hold == Hold::kNone) return {};
  const Eigen::Vector3d axis = hold == Hold::kButAxis ? joint.frame.outward.cast<double>()
                                                      : Eigen::Vector3d(Eigen::Vector3d::Zero());
  const Matrix6d stiffness =
      information_of(joint.frame.point.cast<double>(), options_.joint_m, options_.joint_rad, axis);
  // (information^-1 + stiffness^-1)^-1 without inverting what may be singular.
  const Matrix6d lost = beyond.information * (beyond.information + stiffness).inverse();
  MotionKnowledge told;
  told.information = beyond.information - lost * beyond.information;
  told.information = 0.5 * (told.information + told.information.transpose()).eval();
  told.gradient = beyond.gradient - lost * beyond.gradient;
  return told;
}

// The squared misfit, in standard deviations, that no one motion explains for both.
double DatumFit::contradiction(const MotionKnowledge& a, const MotionKnowledge& b) const {
  // What holds nothing would make the sums singular; this is next to nothing.
  const Matrix6d ridge = 1e-3 * prior_.information;
  return explained(a.information + ridge, a.gradient) +
         explained(b.information + ridge, b.gradient) -
         explained(a.information + b.information + 2 * ridge, a.gradient + b.gradient);
}

DatumEstimate DatumFit::solve() const {
  DatumEstimate estimate;
  estimate.counts.assign(own_.size(), tree_.empty() ? 1 : 0);
  const MotionKnowledge turn = turn_of_datum();
  MotionKnowledge all;
  if (tree_.empty()) {
    for (const MotionKnowledge& knowledge : own_) all += knowledge;
  } else {
    std::vector<MotionKnowledge> belief = own_;
    belief[static_cast<std::size_t>(root_)] += turn;
    std::vector<std::uint8_t> is_as_drawn(tree_.size(), 1);
    for (std::size_t i = tree_.size(); i-- > 0;) {
      const MotionKnowledge& far = belief[static_cast<std::size_t>(tree_[i].part_far)];
      MotionKnowledge& near = belief[static_cast<std::size_t>(tree_[i].part_near)];
      for (const Hold hold : {Hold::kAsDrawn, Hold::kButAxis, Hold::kNone}) {
        const MotionKnowledge told = through(tree_[i], hold, far);
        is_as_drawn[i] = hold == Hold::kAsDrawn ? 1 : 0;
        if (hold != Hold::kNone && contradiction(told, near) > kContradiction) continue;
        near += told;
        break;
      }
    }
    estimate.counts[static_cast<std::size_t>(root_)] = 1;
    for (std::size_t i = 0; i < tree_.size(); ++i)
      estimate.counts[static_cast<std::size_t>(tree_[i].part_far)] =
          is_as_drawn[i] != 0 ? estimate.counts[static_cast<std::size_t>(tree_[i].part_near)] : 0;
    all = belief[static_cast<std::size_t>(root_)];
  }
  // As designed: the same without the joints' variance, and of parts that are as drawn alone.
  MotionKnowledge rigid = prior_;
  rigid += turn;
  for (std::size_t part = 0; part < own_.size(); ++part)
    if (estimate.counts[part] != 0) rigid += own_[part];
  estimate.covariance_as_designed = rigid.information.ldlt().solve(Matrix6d::Identity());
  if (!own_.empty()) {
    const double joint2 = options_.joint_m * options_.joint_m;
    const double own =
        tree_.empty() ? along_one_axis(all) : along_one_axis(own_[static_cast<std::size_t>(root_)]);
    // A datum that was read at all shows whether it stands where its joints have it. That it is the
    // square is a choice: without it the sample's pose took 1.7 s to be good at 1.4 mm off.
    estimate.through_joints = 1 / ((1 + own * joint2) * (1 + own * joint2));
  }
  all += prior_;
  const Eigen::LDLT<Matrix6d> solver(all.information);
  estimate.step = solver.solve(all.gradient);
  estimate.covariance = solver.solve(Matrix6d::Identity());
  return estimate;
}

void DatumFit::follow(const Vector6d& step) {
  for (MotionKnowledge& knowledge : own_) knowledge.gradient -= knowledge.information * step;
  prior_.gradient -= prior_.information * step;
  if (holes_) holes_->follow(hole_axis_.dot(step.tail<3>()));
}

}  // namespace spool
