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

namespace spool {
namespace {

struct Arguments {
  std::string scene, out;
  std::int64_t frames = 60;
};

Result<int> simulate(const Arguments& arguments) {
  const auto simulator = simulator::Simulator::open(arguments.scene);
  if (!simulator) return simulator.error();
  auto writer = sensor::DepthFolderWriter::create(arguments.out, simulator->scene().sensor.camera);
  if (!writer) return writer.error();
  Progress progress;
  for (std::int64_t n = 0; n < arguments.frames; ++n) {
    const DepthFrame frame = simulator->frame(n);
    if (const Status written = writer->write(frame); !written) return written.error();
    progress.report("simulate", static_cast<double>(n + 1) / static_cast<double>(arguments.frames));
  }
  const std::filesystem::path out = arguments.out;
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
  return spool::run_program(app, argc, argv, [&] { return spool::simulate(arguments); });
}
