// How long a piping file of 450 components takes: read, and read and drawn out of the catalogue.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <string>

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include "vision/design/gltf_writer.h"
#include "vision/design/readers.h"
#include "vision/piping/pcf_reader.h"

namespace spool {
namespace {

// A record of two ends, NPS 4, mm.
std::string two_ended(const char* keyword, double x0, double y0, double x1, double y1,
                      const char* more) {
  return fmt::format("{}\n    END-POINT {} {} 0 4\n    END-POINT {} {} 0 4\n{}", keyword, x0, y0,
                     x1, y1, more);
}

// Stairs of nine components a step: pipe, elbow, pipe, tee with a flanged branch, pipe with an
// olet, elbow. The sizes are B16.9's and B16.5's.
std::string stairs(int steps) {
  std::string text = "UNITS-BORE INCH\nUNITS-CO-ORDS MM\nPIPELINE-REFERENCE BENCH\n";
  const char* tee = "    CENTRE-POINT {} {} 0\n    BRANCH1-POINT {} {} 105 4\n    SKEY TEBW\n";
  for (int i = 0; i < steps; ++i) {
    const double x = 1000.0 * i;
    const double y = 2000.0 * i;
    text += two_ended("PIPE", x + 152, y, x + 848, y, "    ITEM-CODE P\n");
    text +=
        two_ended("ELBOW", x + 848, y, x + 1000, y + 152,
                  fmt::format("    CENTRE-POINT {} {} 0\n    ITEM-CODE E\n", x + 1000, y).c_str());
    text += two_ended("PIPE", x + 1000, y + 152, x + 1000, y + 895, "    ITEM-CODE P\n");
    text +=
        two_ended("TEE", x + 1000, y + 895, x + 1000, y + 1105,
                  fmt::format(fmt::runtime(tee), x + 1000, y + 1000, x + 1000, y + 1000).c_str());
    text += fmt::format("PIPE\n    END-POINT {0} {1} 105 4\n    END-POINT {0} {1} 400 4\n",
                        x + 1000, y + 1000);
    text += fmt::format(
        "FLANGE\n    END-POINT {0} {1} 400 4 BW\n    END-POINT {0} {1} 476.2 4 FL\n"
        "    SKEY FLWN\n",
        x + 1000, y + 1000);
    text += two_ended("PIPE", x + 1000, y + 1105, x + 1000, y + 1848, "    ITEM-CODE P\n");
    text += fmt::format(
        "OLET\n    CENTRE-POINT {0} {1} 0\n    BRANCH1-POINT {0} {1} 95 1\n"
        "    SKEY WTBW\n",
        x + 1000, y + 1400);
    text += two_ended(
        "ELBOW", x + 1000, y + 1848, x + 1152, y + 2000,
        fmt::format("    CENTRE-POINT {} {} 0\n    ITEM-CODE E\n", x + 1000, y + 2000).c_str());
  }
  return text +
         "MATERIALS\nITEM-CODE P\n    DESCRIPTION PIPE SCH 40\nITEM-CODE E\n    DESCRIPTION "
         "ELBOW 90 LR SCH 40\n";
}

void read_450_components(benchmark::State& state) {
  const std::string text = stairs(50);
  for (auto _ : state) {
    auto pipework = piping::read_pcf(text, "bench.pcf");
    if (!pipework || pipework->components.size() != 450) state.SkipWithError("not read");
    benchmark::DoNotOptimize(pipework);
  }
}
BENCHMARK(read_450_components)->Unit(benchmark::kMillisecond)->UseRealTime();

// The budget: under 1 s on two cores.
void read_and_mesh_450_components(benchmark::State& state) {
  const std::string text = stairs(50);
  std::size_t triangles = 0;
  for (auto _ : state) {
    auto design = read_pcf_design({"bench.pcf", text, std::nullopt});
    if (!design || design->parts.size() != 450) state.SkipWithError("not drawn");
    if (design) triangles = design->mesh.triangles.size();
    benchmark::DoNotOptimize(design);
  }
  state.counters["triangles"] = static_cast<double>(triangles);
}
BENCHMARK(read_and_mesh_450_components)->Unit(benchmark::kMillisecond)->UseRealTime();

void write_450_components_as_gltf(benchmark::State& state) {
  const auto design = read_pcf_design({"bench.pcf", stairs(50), std::nullopt});
  if (!design) {
    state.SkipWithError("not drawn");
    return;
  }
  for (auto _ : state) benchmark::DoNotOptimize(write_gltf(*design));
}
BENCHMARK(write_450_components_as_gltf)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace spool
