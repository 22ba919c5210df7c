// A room to find a spool in: floor, wall, table, boxes, and pipes of the spool's own sizes.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/vision/find/room.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "vision/design/design_surface.h"
#include "vision/design/sampling.h"

namespace spool::test {
namespace {

using Eigen::Vector3d;

const Vector3d kTowards(0.5, -0.6, 0.7);  // the sensor stands there

double area(const std::vector<Rod>& rods) {
  double sum = 0;
  for (const Rod& rod : rods) sum += 2 * std::numbers::pi * rod.radius * (rod.length + rod.radius);
  return sum;
}

// Half of the surface is seen.
void add_rods(std::vector<Eigen::Vector3f>& points, const std::vector<Rod>& rods,
              const Pose& T_scan_design, const RoomOptions& options, std::mt19937& random) {
  const PointCloud some =
      scan_of(rods, T_scan_design,
              {.points = static_cast<std::size_t>(0.45 * area(rods) * options.points_per_m2),
               .noise_m = options.noise_m,
               .towards = T_scan_design.linear().transpose() * kTowards},
              random);
  points.insert(points.end(), some.points.begin(), some.points.end());
}

}  // namespace

void add_rectangle(std::vector<Eigen::Vector3f>& points, const Vector3d& corner, const Vector3d& u,
                   const Vector3d& v, double points_per_m2, double noise_m, std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  std::normal_distribution<double> gauss(0, noise_m);
  const Vector3d normal = u.cross(v);
  const auto count = static_cast<std::size_t>(points_per_m2 * normal.norm());
  for (std::size_t i = 0; i < count; ++i) {
    const double a = unit(random), b = unit(random), off = gauss(random);
    points.push_back((corner + a * u + b * v + off * normal.normalized()).cast<float>());
  }
}

Room make_room(const std::vector<Rod>& object, const RoomOptions& options, std::mt19937& random) {
  Room room;
  const double fine = options.points_per_m2, noise = options.noise_m;
  // Floor and wall are seen from further off; the table is 0.8 m high.
  add_rectangle(room.points, {-3, -2, 0}, {6, 0, 0}, {0, 4, 0}, fine / 10, noise, random);
  add_rectangle(room.points, {-3, 2, 0}, {6, 0, 0}, {0, 0, 2.5}, fine / 10, noise, random);
  add_rectangle(room.points, {-1.5, -0.7, 0.8}, {3, 0, 0}, {0, 1.4, 0}, fine, noise, random);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int box = 0; box < 4; ++box) {
    const Vector3d corner(-1.4 + 0.75 * box, -0.65 + 0.1 * unit(random), 0.8);
    const double w = 0.1 + 0.2 * unit(random), h = 0.1 + 0.2 * unit(random);
    add_rectangle(room.points, corner, {w, 0, 0}, {0, 0, h}, fine, noise, random);
    add_rectangle(room.points, corner + Vector3d(w, 0, 0), {0, w, 0}, {0, 0, h}, fine, noise,
                  random);
    add_rectangle(room.points, corner + Vector3d(0, 0, h), {w, 0, 0}, {0, w, 0}, fine, noise,
                  random);
  }
  if (options.with_pipes) {
    for (int pipe = 0; pipe < 4; ++pipe) {
      const Rod& like =
          object[static_cast<std::size_t>(pipe) % std::min<std::size_t>(2, object.size())];
      const double turn = 0.4 * unit(random);
      const Rod rod{{-1.4 + 0.7 * unit(random), 0.35 + 0.12 * pipe, 0.8 + like.radius},
                    {std::cos(turn), 0.3 * std::sin(turn), 0},
                    like.radius,
                    0.5 + unit(random)};
      add_rods(room.points, {{rod.base, rod.direction.normalized(), rod.radius, rod.length}},
               Pose::Identity(), options, random);
    }
  }
  for (int copy = 0; copy < options.copies; ++copy) {
    Pose T = random_motion(0, std::numbers::pi * unit(random), random);
    // So high that its lowest point lies on the table.
    double lowest = 0;
    Vector3d middle = Vector3d::Zero();
    const DesignModel design = design_of(object, 24);
    for (const Eigen::Vector3f& p : design.mesh.vertices)
      middle += p.cast<double>() / static_cast<double>(design.mesh.vertices.size());
    for (const Eigen::Vector3f& p : design.mesh.vertices)
      lowest = std::min(lowest, (T.linear() * (p.cast<double>() - middle)).z());
    T.translation() = Vector3d(-0.65 + 1.3 * copy, 0, 0.8 - lowest) - T.linear() * middle;
    add_rods(room.points, object, T, options, random);
    room.T_scan_design.push_back(T);
  }
  std::shuffle(room.points.begin(), room.points.end(), random);
  return room;
}

FinderModel finder_of(const DesignModel& design, std::size_t samples) {
  const Result<DesignSurface> surface = DesignSurface::build(design);
  EXPECT_TRUE(surface);
  return FinderModel::prepare(design, *surface, sample_surface(design, samples));
}

double pose_distance(const FinderModel& model, const Pose& T_a, const Pose& T_b) {
  const Pose between = T_b * T_a.inverse();
  double worst = 0;
  for (const Eigen::Vector3f& sample : model.samples.points) {
    const Vector3d p = sample.cast<double>();
    worst = std::max(worst, (between * p - p).norm());
  }
  return worst;
}

}  // namespace spool::test
