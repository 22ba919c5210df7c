// Benches of app/sensor: what keeping the last seconds of a sensor costs for each frame.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <random>

#include <benchmark/benchmark.h>

#include "app/sensor/packed_depth.h"

namespace spool {
namespace {

// A wavy table at 0.8 m with a sensor's noise, and holes as large as shadows are.
DepthFrame frame_640x480() {
  std::mt19937 random{1};
  std::normal_distribution<double> noise(0, 1.5);
  DepthFrame frame{.width = 640, .height = 480};
  int hole = 0;
  for (int v = 0; v < 480; ++v)
    for (int u = 0; u < 640; ++u) {
      const double depth_mm = 800 + 30 * std::sin(u * 0.05) + 0.2 * v + noise(random);
      if (random() % 200 == 0) hole = 20;
      frame.depth.push_back(hole-- > 0 ? std::uint16_t{0} : static_cast<std::uint16_t>(depth_mm));
    }
  return frame;
}

void bench_pack(benchmark::State& state) {
  const DepthFrame frame = frame_640x480();
  for (auto _ : state) benchmark::DoNotOptimize(sensor::pack(frame));
  state.counters["bytes"] = static_cast<double>(sensor::pack(frame).bytes.size());
}
BENCHMARK(bench_pack)->Name("packing a depth image, 640x480")->Unit(benchmark::kMillisecond);

void bench_unpack(benchmark::State& state) {
  const sensor::PackedDepth packed = sensor::pack(frame_640x480());
  for (auto _ : state) benchmark::DoNotOptimize(sensor::unpack(packed));
}
BENCHMARK(bench_unpack)->Name("unpacking it")->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace spool
