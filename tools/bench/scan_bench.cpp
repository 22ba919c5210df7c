// Benches of vision/scan: one 640x480 frame from counts to normals, the index, thinning, files.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>
#include <random>

#include <benchmark/benchmark.h>

#include "vision/scan/back_projection.h"
#include "vision/scan/normals.h"
#include "vision/scan/point_index.h"
#include "vision/scan/thinning.h"

namespace spool {
namespace {

const Camera kCamera{.width = 640, .height = 480, .fx = 575, .fy = 575, .cx = 319.5, .cy = 239.5};

// A wavy table at 0.8 m with the sensor's noise and a tenth of the readings missing.
DepthFrame frame_640x480() {
  std::mt19937 random{1};
  std::normal_distribution<double> noise(0, 1.5);
  DepthFrame frame{.width = 640, .height = 480};
  for (int v = 0; v < 480; ++v)
    for (int u = 0; u < 640; ++u) {
      const double depth_mm = 800 + 30 * std::sin(u * 0.05) + 0.2 * v + noise(random);
      frame.depth.push_back(random() % 10 == 0 ? std::uint16_t{0}
                                               : static_cast<std::uint16_t>(depth_mm));
    }
  return frame;
}

// Points on 3 m of NPS 4 pipe, `lift_m` off its surface.
std::vector<Eigen::Vector3f> pipe(std::size_t count, float lift_m, bool in_order) {
  std::mt19937 random{2};
  std::uniform_real_distribution<float> unit(0, 1);
  const float radius = 0.05715F + lift_m;
  std::vector<Eigen::Vector3f> points;
  for (std::size_t i = 0; i < count; ++i) {
    const float share = static_cast<float>(i) / static_cast<float>(count);
    const float angle =
        2 * std::numbers::pi_v<float> * (in_order ? std::fmod(share * 600, 1.0F) : unit(random));
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle),
                        3 * (in_order ? share : unit(random)));
  }
  return points;
}

void bench_back_projection(benchmark::State& state) {
  const DepthFrame frame = frame_640x480();
  for (auto _ : state) benchmark::DoNotOptimize(back_project(frame, kCamera));
}
BENCHMARK(bench_back_projection)
    ->Name("back-projection, 640x480")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void bench_organised_normals(benchmark::State& state) {
  PointCloud cloud = *back_project(frame_640x480(), kCamera);
  for (auto _ : state) {
    estimate_organised_normals(cloud, kCamera, {});
    benchmark::DoNotOptimize(cloud.normals.data());
  }
}
BENCHMARK(bench_organised_normals)
    ->Name("organised normals, 640x480")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void bench_index_build(benchmark::State& state) {
  const auto points = pipe(100000, 0, false);
  for (auto _ : state) benchmark::DoNotOptimize(PointIndex(points).size());
}
BENCHMARK(bench_index_build)
    ->Name("index build, 100 000 points")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

// One thread: the callers' own loops are parallel.
void bench_index_nearest(benchmark::State& state) {
  const auto points = pipe(100000, 0, false);
  const auto queries = pipe(300000, 0.003F, true);
  const PointIndex index(points);
  for (auto _ : state) {
    std::size_t found = 0;
    for (const Eigen::Vector3f& query : queries)
      found += index.nearest(query, 0.05F).has_value() ? 1U : 0U;
    benchmark::DoNotOptimize(found);
  }
}
BENCHMARK(bench_index_nearest)
    ->Name("300 000 nearest within 50 mm of 100 000 points")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void bench_neighbour_normals(benchmark::State& state) {
  PointCloud cloud;
  cloud.points = pipe(100000, 0, false);
  const PointIndex index(cloud.points);
  for (auto _ : state) estimate_neighbour_normals(cloud, index, 10, std::nullopt);
}
BENCHMARK(bench_neighbour_normals)
    ->Name("neighbour normals, 100 000 points, k 10")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void bench_thinning(benchmark::State& state) {
  PointCloud cloud = *back_project(frame_640x480(), kCamera);
  estimate_organised_normals(cloud, kCamera, {});
  for (auto _ : state) benchmark::DoNotOptimize(thin_to_voxels(cloud, 0.005).points.data());
}
BENCHMARK(bench_thinning)
    ->Name("thinning to 5 mm, 640x480")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void bench_voxel_size(benchmark::State& state) {
  const PointCloud cloud = *back_project(frame_640x480(), kCamera);
  for (auto _ : state) benchmark::DoNotOptimize(voxel_size_for(cloud, 20000));
}
BENCHMARK(bench_voxel_size)
    ->Name("voxel size for 20 000 points, 640x480")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace
}  // namespace spool
