// The motions that put the joint to blame right.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/measure/bumps.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "vision/measure/joint_errors.h"

namespace spool {
namespace {

using Eigen::Vector3d;

std::size_t at(int index) { return static_cast<std::size_t>(index); }

Pose pose_of(const Vector6d& error) {
  Pose E = Pose::Identity();
  E.linear() = rotation_from_vector(error.tail<3>());
  E.translation() = error.head<3>();
  return E;
}

// The part that is taken hold of: the first beyond the joint, of a length the pipe before it.
int part_of(const DesignModel& design, const JointError& joint, BumpKind kind) {
  if (kind == BumpKind::kLength && design.parts[at(joint.part_near)].kind == PartKind::kPipe)
    return joint.part_near;
  const Joint& first = design.joints[at(joint.joints.front())];
  return first.part_a == joint.part_near ? first.part_b : first.part_a;
}

// What the end is moved most by it, and how far.
void find_end(const JointError& joint, const Vector6d& correction, const ChainResult& chain,
              Bump& bump) {
  const Pose motion = error_motion(joint, correction);
  for (const ChainEnd& end : chain.ends) {
    if (std::ranges::find(joint.ends, end.end, &EndEffect::end) == joint.ends.end()) continue;
    const Vector3d moved = motion * end.place - end.place;
    if (!(moved.norm() > bump.at_end_m)) continue;
    bump.end = end.end;
    bump.at_end_m = moved.norm();
    bump.at_end_way = moved.normalized();
  }
}

}  // namespace

std::vector<Bump> bumps_for(const DesignModel& design, const ChainResult& chain) {
  std::vector<Bump> bumps;
  const auto blamed = std::ranges::find_if(chain.joints, &JointError::is_to_blame);
  if (blamed == chain.joints.end() || !(blamed->against_tolerance > 1)) return bumps;
  const double level = kJointLevel / observed_groups(chain.joints);
  Vector6d left = blamed->error;
  // Turned and tilted first: what is then still off sideways or along is seen straight.
  constexpr std::array kOrder = {BumpKind::kTurn, BumpKind::kTilt, BumpKind::kShift,
                                 BumpKind::kLength};
  for (const BumpKind kind : kOrder) {
    const ErrorGroup& group = *std::ranges::find(error_groups(), kind, &ErrorGroup::kind);
    if (!(chance_of(*blamed, group) < level)) continue;
    Vector6d correction = Vector6d::Zero(), next = left;
    for (const int k : group.components) {
      correction[k] = -left[k];
      next[k] = 0;
    }
    const Vector6d way = correction.normalized();
    const bool is_signed = group.components.size() == 1;
    Bump bump{.part = part_of(design, *blamed, kind),
              .joint_error = static_cast<int>(blamed - chain.joints.begin()),
              .weld = blamed->weld,
              .kind = kind};
    const Vector3d in_joint = is_signed                 ? Vector3d::UnitZ()
                              : kind == BumpKind::kTilt ? Vector3d(way.tail<3>())
                                                        : Vector3d(way.head<3>());
    bump.axis = blamed->T_design_joint.linear() * in_joint;
    bump.amount = is_signed ? correction[group.components.front()] : correction.norm();
    bump.u = std::sqrt(way.dot(blamed->covariance * way));
    bump.seen_from = design.parts[at(blamed->part_near)].name;
    bump.T_design_bumped = blamed->T_design_near * pose_of(next) * pose_of(left).inverse() *
                           blamed->T_design_near.inverse();
    find_end(*blamed, correction, chain, bump);
    left = next;
    bumps.push_back(std::move(bump));
  }
  return bumps;
}

PartFeatures after(const Bump& bump, const ChainResult& chain, const PartFeatures& features) {
  PartFeatures moved = features;
  const std::vector<int>& parts = chain.joints[at(bump.joint_error)].parts;
  for (PartFeature& feature : moved.features)
    if (std::ranges::find(parts, feature.part) != parts.end())
      feature.T_design_measured = bump.T_design_bumped * feature.T_design_measured;
  return moved;
}

}  // namespace spool
