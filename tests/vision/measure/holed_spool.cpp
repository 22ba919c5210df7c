// The two flanges' spool with bolt holes: in its drawing, and cut out of its scan by their circles.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/vision/measure/holed_spool.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "vision/design/design_surface.h"
#include "vision/measure/bolt_holes.h"

namespace spool::test {
namespace {

using Eigen::Vector3d;

constexpr double kBoltCircle = 0.1905;

// Where the flanges' own frames stand: in their faces, z along their axes.
Pose frame_of(int part) {
  Pose T = Pose::Identity();
  if (part == kFlangeA) {
    T.translation() = Vector3d(0, 0, -0.03);
    return T;
  }
  T.translation() = Vector3d(0.68, 0, 0.65);
  T.linear().col(0) = Vector3d::UnitY();
  T.linear().col(1) = Vector3d::UnitZ();
  T.linear().col(2) = Vector3d::UnitX();
  return T;
}

// The face round the holes, as catalogues' meshes have it: an annulus of its own in the face.
void add_annulus(DesignModel& design, int index, double inner, double outer) {
  Part& part = design.parts[static_cast<std::size_t>(index)];
  const double side = index == kFlangeA ? -1 : 1;
  const auto first = static_cast<std::uint32_t>(design.mesh.triangles.size());
  for (std::uint32_t t = 0; t < part.triangle_count; ++t)
    design.mesh.triangles.push_back(design.mesh.triangles[part.first_triangle + t]);
  constexpr int kSteps = 96;
  const auto vertex = static_cast<std::uint32_t>(design.mesh.vertices.size());
  for (int i = 0; i < kSteps; ++i)
    for (const double r : {inner, outer}) {
      const double a = side * 2 * std::numbers::pi * i / kSteps;
      design.mesh.vertices.push_back(
          (part.T_design_part * Vector3d(r * std::cos(a), r * std::sin(a), 0)).cast<float>());
    }
  for (std::uint32_t i = 0; i < kSteps; ++i) {
    const std::uint32_t a = vertex + 2 * i, b = vertex + 2 * ((i + 1) % kSteps);
    design.mesh.triangles.push_back({a, a + 1, b});
    design.mesh.triangles.push_back({a + 1, b + 1, b});
  }
  part.first_triangle = first;
  part.triangle_count = static_cast<std::uint32_t>(design.mesh.triangles.size()) - first;
  design.triangle_part.resize(design.mesh.triangles.size(), index);
}

}  // namespace

DesignModel holed_spool(int count) {
  DesignModel design = two_flange_spool();
  for (const int index : {kFlangeA, kFlangeB}) {
    Part& part = design.parts[static_cast<std::size_t>(index)];
    const Pose T_part_design = frame_of(index).inverse();
    for (Port& port : part.ports) {
      port.position = T_part_design * port.position;
      port.direction = T_part_design.linear() * port.direction;
    }
    part.T_design_part = frame_of(index);
    part.holes = BoltHoles{
        .count = count, .bolt_circle_m = kBoltCircle, .clocking_rad = std::numbers::pi / count};
    add_annulus(design, index, 0.08, 0.11);
  }
  return design;
}

PointCloud scan_of_holed(const HoledScan& built, std::uint32_t seed) {
  const PointCloud whole = scan_of_spool(built.spool, seed);
  PointCloud scan;
  std::size_t of_pipes = 0;
  for (const Eigen::Vector3f& point : whole.points) {
    bool is_hole = false, is_flange = false;
    for (const int index : {kFlangeA, kFlangeB}) {
      const Pose T_design_flange =
          built.spool.T_design_built[static_cast<std::size_t>(index)] * frame_of(index);
      const Vector3d p = T_design_flange.inverse() * point.cast<double>();
      if (std::abs(p.z()) > 0.05) continue;  // of another part
      is_flange = true;
      const double turn = index == kFlangeA ? built.turn_a_rad : built.turn_b_rad;
      for (int i = 0; i < built.count; ++i) {
        const double angle = turn + (2 * i + 1) * std::numbers::pi / built.count;
        const double x = p.x() - kBoltCircle / 2 * std::cos(angle);
        const double y = p.y() - kBoltCircle / 2 * std::sin(angle);
        is_hole = is_hole || std::hypot(x, y) < built.hole_m / 2;
      }
    }
    // A pipe's axis is sure enough with a quarter of its points.
    if (!is_flange && of_pipes++ % 4 > 0) continue;
    if (!is_hole) scan.points.push_back(point);
  }
  return scan;
}

PartFeatures holed_features(const DesignModel& design, const PointCloud& scan) {
  const Result<DesignSurface> surface = DesignSurface::build(design);
  if (!surface) throw std::runtime_error(surface.error().message);
  std::vector<PointClass> classes(scan.size(), PointClass::kObject);
  const Deviations deviations = measure_deviations(scan, classes, *surface, 0.02F);
  const FeatureScan of{scan, classes, deviations};
  PartFeatures features = measure_features(design, of);
  add_bolt_holes(design, drawing_of(design), of, features);
  return features;
}

std::optional<double> turn_read(const PartFeatures& features, int part) {
  const int index = features.holes_of(part);
  if (index < 0) return std::nullopt;
  const PartFeature& holes = features.features[static_cast<std::size_t>(index)];
  const Vector3d x =
      holes.T_design_nominal.linear().transpose() * holes.T_design_measured.linear().col(0);
  return std::atan2(x.y(), x.x());
}

}  // namespace spool::test
