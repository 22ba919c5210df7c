// A spool of rods with joints, built right or wrong.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/vision/inspect/jointed_spool.h"

#include <numbers>
#include <stdexcept>
#include <utility>

namespace spool::test {
namespace {

using Eigen::Vector3d;

constexpr double kPerSquareMetre = 12000;

std::vector<Rod> all_rods() {
  return {{{0, 0, 0}, Vector3d::UnitZ(), 0.03, 0.8},
          {{0, 0.03, 0.1}, Vector3d::UnitY(), 0.03, 0.3},
          {{0.03, 0, 0.8}, Vector3d::UnitX(), 0.03, 0.6},
          {{0.6, 0, 0.83}, Vector3d::UnitZ(), 0.03, 0.35},
          {{0, -0.03, 0.4}, -Vector3d::UnitY(), 0.03, 0.45},
          {{0, -0.45, 0.37}, -Vector3d::UnitZ(), 0.03, 0.2}};
}

void join(DesignModel& design, int near, int far, const Vector3d& at, const Vector3d& outward) {
  Part& a = design.parts[static_cast<std::size_t>(near)];
  Part& b = design.parts[static_cast<std::size_t>(far)];
  Joint joint;
  joint.part_a = near;
  joint.port_a = static_cast<int>(a.ports.size());
  joint.part_b = far;
  joint.port_b = static_cast<int>(b.ports.size());
  joint.weld = "W" + std::to_string(design.joints.size() + 1);
  a.ports.push_back(
      {"out", a.T_design_part.inverse() * at, a.T_design_part.linear().transpose() * outward});
  b.ports.push_back(
      {"in", b.T_design_part.inverse() * at, b.T_design_part.linear().transpose() * -outward});
  design.joints.push_back(joint);
}

DesignModel jointed_design(const std::vector<Rod>& rods) {
  DesignModel design = design_of(rods);
  const char* const names[] = {"riser", "foot", "arm", "tip", "side", "end"};
  for (std::size_t p = 0; p < design.parts.size(); ++p) {
    design.parts[p].name = names[p];
    design.parts[p].kind = PartKind::kPipe;
  }
  design.datums = {kRiser};
  join(design, kRiser, kFoot, {0, 0.03, 0.1}, Vector3d::UnitY());
  join(design, kRiser, kArm, {0, 0, 0.8}, Vector3d::UnitZ());
  join(design, kArm, kTip, {0.63, 0, 0.8}, Vector3d::UnitX());
  join(design, kRiser, kSide, {0, -0.03, 0.4}, -Vector3d::UnitY());
  join(design, kSide, kEnd, {0, -0.45, 0.4}, -Vector3d::UnitY());
  return design;
}

DesignSurface built(const DesignModel& design) {
  Result<DesignSurface> surface = DesignSurface::build(design);
  if (!surface) throw std::runtime_error(surface.error().message);
  return std::move(*surface);
}

}  // namespace

JointedSpool::JointedSpool()
    : rods(all_rods()),
      design(jointed_design(rods)),
      surface(built(design)),
      samples(sample_surface(design, 6000)) {}

const JointedSpool& jointed() {
  static const JointedSpool spool;
  return spool;
}

PointCloud JointedSpool::scan(const std::vector<Pose>& T_design_built,
                              const std::vector<bool>& is_there, std::uint32_t seed) const {
  std::mt19937 random{seed};
  PointCloud scan;
  for (std::size_t p = 0; p < rods.size(); ++p) {
    if (!is_there[p]) continue;
    const double area = 2 * std::numbers::pi * rods[p].radius * rods[p].length;
    const PointCloud part = scan_of(
        {rods[p]}, T_design_built[p],
        {.points = static_cast<std::size_t>(area * kPerSquareMetre), .noise_m = 0.001}, random);
    scan.points.insert(scan.points.end(), part.points.begin(), part.points.end());
    scan.normals.insert(scan.normals.end(), part.normals.begin(), part.normals.end());
  }
  return scan;
}

std::vector<Pose> JointedSpool::as_designed() const {
  return std::vector<Pose>(rods.size(), Pose::Identity());
}

Pose turned_about(const Vector3d& point, const Vector3d& axis, double degrees) {
  Pose pose = Pose::Identity();
  pose.linear() =
      Eigen::AngleAxisd(degrees * std::numbers::pi / 180, axis.normalized()).toRotationMatrix();
  pose.translation() = point - pose.linear() * point;
  return pose;
}

Pose moved(const Vector3d& by) {
  Pose pose = Pose::Identity();
  pose.translation() = by;
  return pose;
}

}  // namespace spool::test
