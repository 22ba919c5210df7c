// spoolsight-simulate: a scene's frames as a depth folder, and the truth about them.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <string>

#include <nlohmann/json.hpp>

#include "app/common/cli.h"
#include "app/common/json_file.h"
#include "app/common/progress.h"
#include "app/sensor/depth_folder.h"
#include "tools/simulator/simulator.h"
#include "tools/simulator/truth.h"
#include "vision/core/file_io.h"
#include "vision/scan/back_projection.h"
#include "vision/scan/cloud_file.h"

namespace spool {
namespace {

struct Arguments {
  std::string scene, out;
  std::int64_t frames = 60;
  bool merged = false;
};

// The measured points of a frame in the map frame, with the part that each pixel really shows.
struct Merged {
  PointCloud cloud;
  PlyColumn part{.name = "part", .type = PlyColumn::Type::kInt};

  Status add(const simulator::Simulator& simulator, const DepthFrame& frame) {
    const auto organised = back_project(frame, simulator.scene().sensor.camera);
    if (!organised) return organised.error();
    const PointCloud points = measured_points(*organised);
    const simulator::IdealImage ideal = simulator.ideal(frame.index);
    const Eigen::Isometry3f T_map_camera = simulator.T_map_camera(frame.index).cast<float>();
    for (std::size_t i = 0; i < points.size(); ++i) {
      cloud.points.push_back(T_map_camera * points.points[i]);
      part.ints.push_back(ideal.part[points.pixels[i]]);
    }
    return {};
  }
};

Result<int> simulate(const Arguments& arguments) {
  const auto simulator = simulator::Simulator::open(arguments.scene);
  if (!simulator) return simulator.error();
  auto writer = sensor::DepthFolderWriter::create(arguments.out, simulator->scene().sensor.camera);
  if (!writer) return writer.error();
  Progress progress;
  Merged merged;
  simulator::FrameBuffers buffers;
  DepthFrame frame;
  for (std::int64_t n = 0; n < arguments.frames; ++n) {
    simulator->frame(n, buffers, frame);
    if (const Status written = writer->write(frame); !written) return written.error();
    if (arguments.merged)
      if (const Status added = merged.add(*simulator, frame); !added) return added.error();
    progress.report("simulate", static_cast<double>(n + 1) / static_cast<double>(arguments.frames));
  }
  const std::filesystem::path out = arguments.out;
  if (arguments.merged)
    if (const Status s = write_ply(out / "cloud.ply", merged.cloud, {merged.part}); !s)
      return s.error();
  const std::string truth = json_text(simulator::truth_json(*simulator, arguments.frames));
  if (const Status written = write_file_whole(out / "truth.json", truth); !written)
    return written.error();
  return 0;
}

}  // namespace
}  // namespace spool

int main(int argc, char** argv) {
  CLI::App app(
      "Writes the frames of a simulated scene as a depth folder, with truth.json beside them.");
  spool::add_common_options(app, "spoolsight-simulate");
  spool::Arguments arguments;
  app.add_option("--scene", arguments.scene, "Scene file (JSON)")->required();
  app.add_option("--frames", arguments.frames, "How many frames")
      ->check(CLI::Range(std::int64_t{1}, std::int64_t{1000000}))
      ->capture_default_str();
  app.add_option("--out", arguments.out, "New folder for the recording")->required();
  app.add_flag("--merged-cloud", arguments.merged,
               "Also cloud.ply: all frames in the map frame by their true poses, with true parts");
  return spool::run_program(app, argc, argv, [&] { return spool::simulate(arguments); });
}
