// How long the design's surface takes: 300 000 deviations against 100 000 triangles, building,
// sampling, its distances as a volume.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "vision/design/design_surface.h"
#include "vision/design/distance_field.h"
#include "vision/design/sampling.h"
#include "vision/inspect/deviation.h"

namespace spool {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kRing = 0.5;     // m, of a pipe bent into a ring
constexpr double kRadius = 0.05;  // m, of the pipe

Eigen::Vector3f ring_point(double along, double across, double radius) {
  return Eigen::Vector3d((kRing + radius * std::cos(across)) * std::cos(along),
                         (kRing + radius * std::cos(across)) * std::sin(along),
                         radius * std::sin(across))
      .cast<float>();
}

// A pipe bent into a ring, of 100 000 triangles.
DesignModel ring_design() {
  constexpr std::uint32_t kAlong = 500;
  constexpr std::uint32_t kAcross = 100;
  DesignModel design;
  Part part;
  part.name = "ring";
  part.triangle_count = 2 * kAlong * kAcross;
  design.parts.push_back(part);
  for (std::uint32_t i = 0; i < kAlong; ++i) {
    for (std::uint32_t j = 0; j < kAcross; ++j) {
      design.mesh.vertices.push_back(ring_point(kTurn * i / kAlong, kTurn * j / kAcross, kRadius));
      const auto at = [&](std::uint32_t a, std::uint32_t b) {
        return (i + a) % kAlong * kAcross + (j + b) % kAcross;
      };
      design.mesh.triangles.push_back({at(0, 0), at(1, 0), at(1, 1)});
      design.mesh.triangles.push_back({at(0, 0), at(1, 1), at(0, 1)});
    }
  }
  design.triangle_part.assign(design.mesh.triangles.size(), 0);
  return design;
}

// Readings on the ring with 2 mm of noise, in the order in which an image would bring them (strips
// along the pipe), or in none.
std::vector<Eigen::Vector3f> readings(bool in_order) {
  constexpr int kRows = 600;
  constexpr int kColumns = 500;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::normal_distribution<double> noise(0, 0.002);
  std::vector<Eigen::Vector3f> points;
  points.reserve(kRows * kColumns);
  for (int row = 0; row < kRows; ++row) {
    for (int column = 0; column < kColumns; ++column) {
      const double along = in_order ? static_cast<double>(row) / kRows : uniform(random);
      const double across = in_order ? static_cast<double>(column) / kColumns : uniform(random);
      points.push_back(ring_point(kTurn * along, kTurn * across, kRadius + noise(random)));
    }
  }
  return points;
}

// The budget: under 100 ms on two cores. Argument: whether the readings come in image order.
void deviation_of_300k_readings(benchmark::State& state) {
  const DesignModel design = ring_design();
  const Result<DesignSurface> surface = DesignSurface::build(design);
  const std::vector<Eigen::Vector3f> points = readings(state.range(0) != 0);
  std::vector<PointClass> classes(points.size());
  for (auto _ : state) {
    std::fill(classes.begin(), classes.end(), PointClass::kObject);
    benchmark::DoNotOptimize(measure_deviations(CloudView(points), classes, *surface, 0.02F));
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(points.size()));
}
BENCHMARK(deviation_of_300k_readings)
    ->ArgName("image_order")
    ->Arg(1)
    ->Arg(0)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

void surface_over_100k_triangles(benchmark::State& state) {
  const DesignModel design = ring_design();
  for (auto _ : state) {
    benchmark::DoNotOptimize(DesignSurface::build(design));
  }
}
BENCHMARK(surface_over_100k_triangles)->Unit(benchmark::kMillisecond)->UseRealTime();

// Once a design, beside the start of the application.
void distances_of_100k_triangles(benchmark::State& state) {
  const DesignModel design = ring_design();
  const Result<DesignSurface> surface = DesignSurface::build(design);
  std::size_t bricks = 0;
  for (auto _ : state) {
    const auto volume = make_distance_field(*surface, design.bounds());
    bricks = volume->brick_count();
    benchmark::DoNotOptimize(volume);
  }
  state.SetLabel(std::to_string(bricks) + " bricks");
}
BENCHMARK(distances_of_100k_triangles)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

void sampling_of_12000_points(benchmark::State& state) {
  const DesignModel design = ring_design();
  for (auto _ : state) {
    benchmark::DoNotOptimize(sample_surface(design, 12000));
  }
}
BENCHMARK(sampling_of_12000_points)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace spool
