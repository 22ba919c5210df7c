// ICP, principal axes and the whole main path, on a flanged tee made here.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <memory>
#include <numbers>
#include <random>

#include <benchmark/benchmark.h>

#include "vision/align/icp.h"
#include "vision/align/three_point.h"
#include "vision/inspector.h"

namespace spool {
namespace {

struct Tube {
  Eigen::Vector3d base, axis;
  double radius, length;
};

const std::vector<Tube>& tee() {
  static const std::vector<Tube> tubes = {
      {{0, 0, 0}, Eigen::Vector3d::UnitZ(), 0.057, 1.2},
      {{0, 0, 0.8}, Eigen::Vector3d::UnitX(), 0.044, 0.5},
      {{0, 0, -0.03}, Eigen::Vector3d::UnitZ(), 0.115, 0.03},
      {{0.5, 0, 0.8}, Eigen::Vector3d::UnitX(), 0.095, 0.03},
  };
  return tubes;
}

Eigen::Vector3d on_tube(const Tube& tube, double angle, double along, double radius) {
  const Eigen::Vector3d x = tube.axis.unitOrthogonal();
  return tube.base + along * tube.axis +
         radius * (std::cos(angle) * x + std::sin(angle) * tube.axis.cross(x));
}

// About 100 000 triangles.
DesignModel tee_model() {
  DesignModel model;
  constexpr int kAround = 128, kAlong = 96;
  for (const Tube& tube : tee()) {
    Part part;
    part.name = "tube_" + std::to_string(model.parts.size() + 1);
    part.first_triangle = static_cast<std::uint32_t>(model.mesh.triangles.size());
    const auto first = static_cast<std::uint32_t>(model.mesh.vertices.size());
    for (int j = 0; j <= kAlong; ++j)
      for (int i = 0; i < kAround; ++i)
        model.mesh.vertices.push_back(
            on_tube(tube, 2 * std::numbers::pi * i / kAround, tube.length * j / kAlong, tube.radius)
                .cast<float>());
    for (std::uint32_t j = 0; j < kAlong; ++j)
      for (std::uint32_t i = 0; i < kAround; ++i) {
        const std::uint32_t a = first + j * kAround + i;
        const std::uint32_t b = first + j * kAround + (i + 1) % kAround;
        model.mesh.triangles.push_back({a, b, b + kAround});
        model.mesh.triangles.push_back({a, b + kAround, a + kAround});
      }
    part.triangle_count =
        static_cast<std::uint32_t>(model.mesh.triangles.size()) - part.first_triangle;
    model.triangle_part.resize(model.mesh.triangles.size(),
                               static_cast<std::int32_t>(model.parts.size()));
    model.parts.push_back(part);
  }
  return model;
}

const std::shared_ptr<const PreparedDesign>& prepared_tee() {
  static const auto design = *PreparedDesign::prepare(tee_model());
  return design;
}

// `object` points on the tee with 2 mm of noise, then `clutter` points of a floor and a wall.
PointCloud scan_of_tee(std::size_t object, std::size_t clutter, bool normals) {
  std::mt19937 random{1};
  std::uniform_real_distribution<double> unit(0, 1);
  std::normal_distribution<double> noise(0, 0.002);
  PointCloud scan;
  for (std::size_t i = 0; i < object; ++i) {
    const Tube& tube = tee()[i % 8 < 5 ? 0 : i % 8 < 7 ? 1 : i % 2 == 0 ? 2 : 3];
    const double angle = 2 * std::numbers::pi * unit(random);
    const Eigen::Vector3d p =
        on_tube(tube, angle, tube.length * unit(random), tube.radius + noise(random));
    scan.points.push_back(p.cast<float>());
    const Eigen::Vector3d axis = tube.base + (p - tube.base).dot(tube.axis) * tube.axis;
    if (normals) scan.normals.push_back((p - axis).normalized().cast<float>());
  }
  for (std::size_t i = 0; i < clutter; ++i) {
    const bool floor = i % 2 == 0;
    const double a = 4 * unit(random) - 2, b = 4 * unit(random) - 2;
    scan.points.emplace_back(Eigen::Vector3d(a, floor ? b : 0.4, floor ? -0.03 : b).cast<float>());
    if (normals)
      scan.normals.push_back(floor ? Eigen::Vector3f::UnitZ() : Eigen::Vector3f::UnitY());
  }
  return scan;
}

Pose three_degrees_and_thirty_millimetres() {
  Vector6d off;
  off << 0.02, -0.02, 0.01, 0.03, 0.03, -0.03;
  return pose_from_small(off);
}

void icp(benchmark::State& state) {
  const PointCloud scan = scan_of_tee(static_cast<std::size_t>(state.range(0)), 0, true);
  const auto& design = prepared_tee();
  double iterations = 0;
  for (auto _ : state) {
    const IcpResult found =
        refine_icp(scan, *design->surface, three_degrees_and_thirty_millimetres(),
                   {.start_distance_m = 0.1, .noise_m = 0.002});
    iterations += found.iterations;
    benchmark::DoNotOptimize(found.rms_m);
  }
  state.counters["iterations"] = iterations / static_cast<double>(state.iterations());
  state.counters["s_per_iteration"] =
      benchmark::Counter(iterations, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK(icp)->Arg(20000)->Arg(300000)->Unit(benchmark::kMillisecond)->UseRealTime();

// Every point compared in every iteration: the gate is at its last width from the start.
void icp_full_iterations(benchmark::State& state) {
  const PointCloud scan = scan_of_tee(static_cast<std::size_t>(state.range(0)), 0, true);
  const auto& design = prepared_tee();
  Vector6d off;
  off << 0.001, -0.001, 0.001, 0.001, 0.001, -0.001;
  double iterations = 0;
  for (auto _ : state) {
    const IcpResult found = refine_icp(scan, *design->surface, pose_from_small(off),
                                       {.max_iterations = 10,
                                        .start_distance_m = 0.006,
                                        .noise_m = 0.002,
                                        .stop_translation_m = 1e-12,
                                        .stop_rotation_rad = 1e-12});
    iterations += found.iterations;
    benchmark::DoNotOptimize(found.rms_m);
  }
  state.counters["s_per_iteration"] =
      benchmark::Counter(iterations, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK(icp_full_iterations)
    ->Arg(20000)
    ->Arg(300000)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

// Bump to numbers: 6 000 points of the spool in 75 000 of a room, three picks off by 10 mm.
void inspect_from_picks(benchmark::State& state) {
  const PointCloud scan = scan_of_tee(6000, 75000, false);
  const Inspector inspector(prepared_tee());
  InspectorOptions options;
  options.align = AlignMethod::kThreePoint;
  options.pairs = {{{0.057, 0, 0.1}, {0.067, 0, 0.1}},
                   {{0, 0.057, 1.15}, {0, 0.057, 1.16}},
                   {{0.5, 0.095, 0.81}, {0.5, 0.105, 0.81}}};
  for (auto _ : state) {
    const auto found = inspector.process(scan, {.constant_m = 0.002}, options);
    benchmark::DoNotOptimize(found->scan_rms_m);
  }
}
BENCHMARK(inspect_from_picks)->Unit(benchmark::kMillisecond)->UseRealTime();

void inspect_by_principal_axes(benchmark::State& state) {
  const PointCloud scan = scan_of_tee(80000, 0, false);
  const Inspector inspector(prepared_tee());
  for (auto _ : state) {
    const auto found = inspector.process(scan, {.constant_m = 0.002}, {});
    benchmark::DoNotOptimize(found->scan_rms_m);
  }
}
BENCHMARK(inspect_by_principal_axes)->Unit(benchmark::kMillisecond)->UseRealTime();

// Once a design: what no sensor sees, surface and samples.
void prepare_design(benchmark::State& state) {
  const DesignModel model = tee_model();
  for (auto _ : state) {
    const auto design = PreparedDesign::prepare(model);
    benchmark::DoNotOptimize(design.has_value());
  }
}
BENCHMARK(prepare_design)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace spool
