// Flange, three pipes with two elbows in two planes between them, flange.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/vision/measure/three_leg_spool.h"

#include <numbers>

namespace spool::test {
namespace {

using Eigen::Vector3d;

constexpr double kRadius = 0.05715, kFlangeRadius = 0.1143;

bool has_surface(int part) { return part != kElbow1 && part != kElbow2; }

std::vector<Rod> rods() {
  const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(), z = Vector3d::UnitZ();
  return {{{0, 0, -0.03}, z, kFlangeRadius, 0.03},
          {{0, 0, 0}, z, kRadius, 0.5},
          {{0.15, 0, 0.65}, x, kRadius, 0.5},
          {{0.8, 0.15, 0.65}, y, kRadius, 0.5},
          {{0.8, 0.65, 0.65}, y, kFlangeRadius, 0.03}};
}

Port port(const char* name, const Vector3d& position, const Vector3d& direction, EndType end) {
  return {name, position, direction, 4, end};
}

}  // namespace

DesignModel three_leg_spool() {
  DesignModel design = design_of(rods(), 192);
  const std::vector<Part> made = design.parts;
  const auto each = static_cast<std::uint32_t>(design.mesh.triangles.size() / made.size());
  const int of_rod[] = {kLegFlangeA, kLeg1, kLeg2, kLeg3, kLegFlangeB};
  for (std::int32_t& part : design.triangle_part) part = of_rod[part];
  design.parts.assign(kLegParts, Part{});
  const char* const names[] = {"flange_a", "pipe_1", "elbow_1", "pipe_2",
                               "elbow_2",  "pipe_3", "flange_b"};
  const auto part = [&](int p) -> Part& { return design.parts[static_cast<std::size_t>(p)]; };
  std::uint32_t first = 0;
  for (int p = 0; p < kLegParts; ++p) {
    part(p).name = names[p];
    part(p).nps = 4;
    part(p).kind = has_surface(p) ? PartKind::kPipe : PartKind::kElbow;
    if (!has_surface(p)) continue;
    part(p).first_triangle = first;
    part(p).triangle_count = each;
    first += each;
  }
  part(kLegFlangeA).kind = part(kLegFlangeB).kind = PartKind::kFlange;
  const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(), z = Vector3d::UnitZ();
  const EndType weld = EndType::kButtWeld;
  part(kLegFlangeA).ports = {port("face", {0, 0, -0.03}, -z, EndType::kFlanged),
                             port("weld", {0, 0, 0}, z, weld)};
  part(kLeg1).ports = {port("in", {0, 0, 0}, -z, weld), port("out", {0, 0, 0.5}, z, weld)};
  part(kElbow1).ports = {port("in", {0, 0, 0.5}, -z, weld), port("out", {0.15, 0, 0.65}, x, weld)};
  part(kLeg2).ports = {port("in", {0.15, 0, 0.65}, -x, weld),
                       port("out", {0.65, 0, 0.65}, x, weld)};
  part(kElbow2).ports = {port("in", {0.65, 0, 0.65}, -x, weld),
                         port("out", {0.8, 0.15, 0.65}, y, weld)};
  part(kLeg3).ports = {port("in", {0.8, 0.15, 0.65}, -y, weld),
                       port("out", {0.8, 0.65, 0.65}, y, weld)};
  part(kLegFlangeB).ports = {port("face", {0.8, 0.68, 0.65}, y, EndType::kFlanged),
                             port("weld", {0.8, 0.65, 0.65}, -y, weld)};
  design.joints = {{"W1", kLegFlangeA, 1, kLeg1, 0}, {"W2", kLeg1, 1, kElbow1, 0},
                   {"W3", kElbow1, 1, kLeg2, 0},     {"W4", kLeg2, 1, kElbow2, 0},
                   {"W5", kElbow2, 1, kLeg3, 0},     {"W6", kLeg3, 1, kLegFlangeB, 1}};
  design.datums = {kLegFlangeA};
  return design;
}

PartFeatures features_of_legs(const DesignModel& design, const std::vector<Pose>& T_design_built,
                              std::uint32_t seed, double noise_m) {
  std::mt19937 random{seed};
  const std::vector<Rod> all = rods();
  PointCloud scan;
  constexpr double kPerSquareMetre = 40000;  // 5 mm apart
  std::size_t r = 0;
  for (int p = 0; p < kLegParts; ++p) {
    if (!has_surface(p)) continue;
    const Rod& rod = all[r++];
    const double area = 2 * std::numbers::pi * rod.radius * (rod.length + rod.radius);
    const PointCloud part = scan_of(
        {rod}, T_design_built[static_cast<std::size_t>(p)],
        {.points = static_cast<std::size_t>(area * kPerSquareMetre), .noise_m = noise_m}, random);
    scan.points.insert(scan.points.end(), part.points.begin(), part.points.end());
  }
  return features_of(design, scan);
}

std::vector<Pose> legs_moved_from(int first, const Pose& motion) {
  std::vector<Pose> built(kLegParts, Pose::Identity());
  for (int p = first; p < kLegParts; ++p) built[static_cast<std::size_t>(p)] = motion;
  return built;
}

}  // namespace spool::test
