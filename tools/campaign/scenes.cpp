// spoolsight-scenes: scenes with their truth, for campaigns that measure accuracy.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <map>
#include <string>

#include <spdlog/spdlog.h>

#include "app/common/cli.h"
#include "tools/campaign/scene_files.h"

namespace {

const std::map<std::string, spool::campaign::ObjectKind> kKinds = {
    {"pipe_spool_3m", spool::campaign::ObjectKind::kPipeSpool3m},
    {"small_spool", spool::campaign::ObjectKind::kSmallSpool},
    {"box_frame", spool::campaign::ObjectKind::kBoxFrame}};

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(
      "Writes a scene: a spool or frame among clutter as a sensor sees it, and the truth.");
  spool::add_common_options(app, "spoolsight-scenes");
  spool::campaign::SceneRequest request;
  std::string out;
  bool plain = false;
  bool absent = false;
  app.add_option("--kind", request.kind, "What stands there")
      ->transform(CLI::CheckedTransformer(kKinds));
  app.add_option("--seed", request.seed, "Every number gives another scene")->capture_default_str();
  app.add_flag("--plain", plain, "A box frame without the members that break its symmetry");
  app.add_flag("--absent", absent, "The object is not there");
  app.add_option("--copies", request.copies, "How many of the object stand there")
      ->check(CLI::Range(0, 2));
  app.add_option("--noise-m", request.noise_m, "Noise along the ray, one standard deviation (m)")
      ->check(CLI::Range(0.0, 0.1))
      ->capture_default_str();
  app.add_option("--stations", request.stations, "Scanner stations")
      ->check(CLI::Range(1, 16))
      ->capture_default_str();
  app.add_option("--points", request.scene_points, "Points of the scene")
      ->check(CLI::Range(std::size_t{100}, std::size_t{20'000'000}))
      ->capture_default_str();
  app.add_option("--density-ratio", request.density_ratio,
                 "Points of the scene as a multiple of 10 000, in place of --points")
      ->check(CLI::Range(0.01, 1000.0));
  app.add_option("--clutter-ratio", request.clutter_ratio, "Points of clutter to one of the object")
      ->check(CLI::Range(0.0, 1000.0))
      ->capture_default_str();
  app.add_option("--completeness", request.completeness,
                 "Share of the object's points that is left")
      ->check(CLI::Range(0.05, 1.0))
      ->capture_default_str();
  app.add_option("--out", out, "Folder for the scene")->required();
  return spool::run_program(app, argc, argv, [&]() -> spool::Result<int> {
    request.braced = !plain;
    if (absent) request.copies = 0;
    const spool::campaign::Scene scene = spool::campaign::make_scene(request);
    if (const spool::Status s = spool::campaign::write_scene(scene, out); !s) return s.error();
    spdlog::info("{} points, {} of them on the object", scene.cloud.size(), scene.object_points);
    return 0;
  });
}
