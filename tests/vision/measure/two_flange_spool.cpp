// Flange, pipe, elbow, pipe, flange: a spool with a drawing, scanned as drawn or as built.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/vision/measure/two_flange_spool.h"

#include <numbers>
#include <stdexcept>

#include "vision/design/design_surface.h"

namespace spool::test {
namespace {

using Eigen::Vector3d;

constexpr double kRadius = 0.05715, kFlangeRadius = 0.1143;

std::vector<Rod> rods() {
  return {{{0, 0, -0.03}, Vector3d::UnitZ(), kFlangeRadius, 0.03},
          {{0, 0, 0}, Vector3d::UnitZ(), kRadius, 0.5},
          {{0.15, 0, 0.65}, Vector3d::UnitX(), kRadius, 0.5},
          {{0.65, 0, 0.65}, Vector3d::UnitX(), kFlangeRadius, 0.03}};
}

Port port(const char* name, const Vector3d& position, const Vector3d& direction, EndType end) {
  return {name, position, direction, 4, end};
}

}  // namespace

DesignModel two_flange_spool() {
  DesignModel design = design_of(rods(), 192);
  for (Part& part : design.parts) part.T_design_part = Pose::Identity();
  Part elbow;
  elbow.kind = PartKind::kElbow;
  design.parts.insert(design.parts.begin() + kElbow, elbow);
  for (std::int32_t& part : design.triangle_part) part += part >= kElbow ? 1 : 0;
  const char* const names[] = {"flange_a", "pipe_1", "elbow_1", "pipe_2", "flange_b"};
  for (std::size_t p = 0; p < design.parts.size(); ++p) {
    design.parts[p].name = names[p];
    design.parts[p].nps = 4;
  }
  // The rods' triangles follow each other.
  std::uint32_t first = 0;
  for (const int p : {kFlangeA, kPipe1, kPipe2, kFlangeB}) {
    Part& part = design.parts[static_cast<std::size_t>(p)];
    part.first_triangle = first;
    part.triangle_count = static_cast<std::uint32_t>(design.mesh.triangles.size() / 4);
    first += part.triangle_count;
  }
  const Vector3d x = Vector3d::UnitX(), z = Vector3d::UnitZ();
  const auto part = [&](int p) -> Part& { return design.parts[static_cast<std::size_t>(p)]; };
  const EndType weld = EndType::kButtWeld;
  part(kFlangeA).kind = part(kFlangeB).kind = PartKind::kFlange;
  part(kPipe1).kind = part(kPipe2).kind = PartKind::kPipe;
  part(kFlangeA).ports = {port("face", {0, 0, -0.03}, -z, EndType::kFlanged),
                          port("weld", {0, 0, 0}, z, weld)};
  part(kPipe1).ports = {port("in", {0, 0, 0}, -z, weld), port("out", {0, 0, 0.5}, z, weld)};
  part(kElbow).ports = {port("in", {0, 0, 0.5}, -z, weld), port("out", {0.15, 0, 0.65}, x, weld)};
  part(kPipe2).ports = {port("in", {0.15, 0, 0.65}, -x, weld),
                        port("out", {0.65, 0, 0.65}, x, weld)};
  part(kFlangeB).ports = {port("face", {0.68, 0, 0.65}, x, EndType::kFlanged),
                          port("weld", {0.65, 0, 0.65}, -x, weld)};
  design.joints = {{"W1", kFlangeA, 1, kPipe1, 0},
                   {"W2", kPipe1, 1, kElbow, 0},
                   {"W3", kElbow, 1, kPipe2, 0},
                   {"W4", kPipe2, 1, kFlangeB, 1}};
  return design;
}

PointCloud scan_of_spool(const SpoolScan& built, std::uint32_t seed) {
  std::mt19937 random{seed};
  std::vector<Rod> all = rods();
  all[2].radius = built.pipe_2_radius_m;
  PointCloud scan;
  for (std::size_t r = 0; r < all.size(); ++r) {
    const std::size_t p = r < kElbow ? r : r + 1;
    if (!built.is_there[p]) continue;
    const double area = 2 * std::numbers::pi * all[r].radius * (all[r].length + all[r].radius);
    const PointCloud part =
        scan_of({all[r]}, built.T_design_built[p],
                {.points = static_cast<std::size_t>(area * built.per_square_metre),
                 .noise_m = built.noise_m},
                random);
    scan.points.insert(scan.points.end(), part.points.begin(), part.points.end());
  }
  for (Eigen::Vector3f& point : scan.points) point *= static_cast<float>(built.scale);
  return scan;
}

PartFeatures features_of(const DesignModel& design, const PointCloud& scan, double warp_u_m,
                         const std::optional<Eigen::Vector3d>& eye) {
  const Result<DesignSurface> surface = DesignSurface::build(design);
  if (!surface) throw std::runtime_error(surface.error().message);
  std::vector<PointClass> classes(scan.size(), PointClass::kObject);
  const Deviations deviations = measure_deviations(scan, classes, *surface, 0.02F);
  return measure_features(design, {scan, classes, deviations, eye, 1, warp_u_m});
}

PartFeatures features_of(const DesignModel& design, const SpoolScan& built, std::uint32_t seed,
                         double warp_u_m) {
  return features_of(design, scan_of_spool(built, seed), warp_u_m);
}

}  // namespace spool::test
