// spoolsight-scenes: scenes with their truth, for campaigns that measure accuracy.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <charconv>
#include <map>
#include <string>
#include <system_error>
#include <vector>

#include <spdlog/spdlog.h>

#include "app/common/cli.h"
#include "tools/campaign/scene_files.h"

namespace {

using spool::campaign::DefectKind;
using spool::campaign::ObjectKind;
using spool::campaign::SensorKind;

const std::map<std::string, ObjectKind> kKinds = {{"pipe_spool_3m", ObjectKind::kPipeSpool3m},
                                                  {"small_spool", ObjectKind::kSmallSpool},
                                                  {"box_frame", ObjectKind::kBoxFrame},
                                                  {"four_branch", ObjectKind::kFourBranch},
                                                  {"random_spool", ObjectKind::kRandomSpool}};

const std::map<std::string, SensorKind> kSensors = {{"laser", SensorKind::kLaser},
                                                    {"handheld", SensorKind::kHandheld}};

// "turned", "turned:4" or "turned:4:elbow_2": the kind, how much of it, to which part.
spool::Result<spool::campaign::Defect> parse_defect(const std::string& text) {
  const std::size_t colon = text.find(':');
  const std::size_t second = colon == std::string::npos ? colon : text.find(':', colon + 1);
  spool::campaign::Defect defect;
  bool known = false;
  for (int i = 0; i <= static_cast<int>(DefectKind::kOffset); ++i) {
    const auto kind = static_cast<DefectKind>(i);
    if (text.substr(0, colon) != name(kind)) continue;
    defect.kind = kind;
    known = true;
  }
  if (colon != std::string::npos) {
    const std::string amount = text.substr(colon + 1, second - colon - 1);
    const auto [end, error] =
        std::from_chars(amount.data(), amount.data() + amount.size(), defect.amount);
    known = known && error == std::errc() && end == amount.data() + amount.size();
  }
  if (second != std::string::npos) defect.part = text.substr(second + 1);
  if (!known)
    return spool::Error{spool::ErrorCode::kUsage,
                        "--defect " + text +
                            ": give KIND[:AMOUNT[:PART]], KIND one of turned, "
                            "long, swapped, missing, extra, tilted, clocked, offset"};
  return defect;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(
      "Writes a scene: a spool or frame among clutter as a sensor sees it, and the truth.");
  spool::add_common_options(app, "spoolsight-scenes");
  spool::campaign::SceneRequest request;
  std::string out;
  std::vector<std::string> defects;
  bool plain = false;
  bool absent = false;
  app.add_option("--kind", request.kind,
                 "pipe_spool_3m (the default), small_spool, box_frame, four_branch or random_spool")
      ->transform(CLI::CheckedTransformer(kKinds).description(""));
  app.add_option("--seed", request.seed, "Every number gives another scene")->capture_default_str();
  app.add_flag("--plain", plain, "A box frame without the members that break its symmetry");
  app.add_flag("--absent", absent, "The object is not there");
  app.add_option("--copies", request.copies, "How many of the object stand there")
      ->check(CLI::Range(0, 2));
  app.add_option("--noise-m", request.noise_m, "Noise along the ray, one standard deviation (m)")
      ->check(CLI::Range(0.0, 0.1))
      ->capture_default_str();
  app.add_option("--sensor", request.sensor, "laser (the default) or handheld")
      ->transform(CLI::CheckedTransformer(kSensors).description(""));
  app.add_option("--frames", request.frames, "Frames of the hand-held sensor")
      ->check(CLI::Range(1, 255))
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
  app.add_option(
      "--defect", defects,
      "KIND[:AMOUNT[:PART]], any number: turned, tilted, clocked (degrees), long, offset "
      "(millimetres), swapped, missing, extra");
  app.add_option("--out", out, "Folder for the scene")->required();
  return spool::run_program(app, argc, argv, [&]() -> spool::Result<int> {
    request.braced = !plain;
    if (absent) request.copies = 0;
    for (const std::string& text : defects) {
      const auto defect = parse_defect(text);
      if (!defect) return defect.error();
      request.defects.push_back(*defect);
    }
    const spool::campaign::Scene scene = spool::campaign::make_scene(request);
    if (const spool::Status s = spool::campaign::write_scene(scene, out); !s) return s.error();
    if (scene.request.defects.size() < defects.size())
      spdlog::warn("this object has no part for {} of the defects asked for",
                   defects.size() - scene.request.defects.size());
    spdlog::info("{} points, {} of them on the object", scene.cloud.size(), scene.object_points);
    return 0;
  });
}
