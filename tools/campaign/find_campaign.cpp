// spoolsight-find-campaign: how often the finder is right, wrong or silent on scenes of known
// truth.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <numbers>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/common/cli.h"
#include "tools/campaign/scene.h"
#include "vision/core/file_io.h"
#include "vision/design/design_reader.h"
#include "vision/inspector.h"
#include "vision/scan/noise_estimate.h"

namespace spool::campaign {
namespace {

struct Row {
  std::string name;
  SceneRequest request;
};

SceneRequest laser(ObjectKind kind, std::size_t points, double clutter) {
  return {.kind = kind, .scene_points = points, .clutter_ratio = clutter};
}

// What the thesis varied in chapter 4, and what it could not do.
std::vector<Row> rows() {
  constexpr auto kSpool = ObjectKind::kPipeSpool3m;
  constexpr auto kFrame = ObjectKind::kBoxFrame;
  std::vector<Row> all{{"spool-clutter-12", laser(kSpool, 81'000, 12)},
                       {"spool-clutter-51", laser(kSpool, 322'000, 51)},
                       {"frame-clutter-3", laser(kFrame, 61'000, 3)},
                       {"frame-clutter-10", laser(kFrame, 159'000, 10)},
                       {"frame-clutter-21", laser(kFrame, 322'000, 21)}};
  for (const double ratio : {20.0, 10.0, 5.0, 2.0, 1.0}) {
    SceneRequest request = laser(kSpool, 0, 49);
    request.scene_points = static_cast<std::size_t>(ratio * kModelPoints);
    all.push_back({"spool-density-" + std::to_string(static_cast<int>(ratio)), request});
    request = laser(kFrame, request.scene_points, 49);
    all.push_back({"frame-density-" + std::to_string(static_cast<int>(ratio)), request});
  }
  for (const double completeness : {0.9, 0.7, 0.5}) {
    SceneRequest request = laser(kSpool, 81'000, 12);
    request.completeness = completeness;
    all.push_back(
        {"spool-complete-" + std::to_string(static_cast<int>(100 * completeness)), request});
  }
  for (const ObjectKind kind : {kSpool, kFrame}) {
    SceneRequest request = laser(kind, 81'000, 12);
    request.copies = 0;
    all.push_back({kind == kSpool ? "spool-absent" : "frame-absent", request});
  }
  for (const auto& [name, defect] : {std::pair("defect-turned", DefectKind::kTurned),
                                     std::pair("defect-long", DefectKind::kLong),
                                     std::pair("defect-swapped", DefectKind::kSwapped),
                                     std::pair("defect-missing", DefectKind::kMissing)}) {
    SceneRequest request = laser(kSpool, 81'000, 12);
    request.defects = {{.kind = defect, .amount = defect == DefectKind::kLong ? 80.0 : 0.0}};
    all.push_back({name, request});
  }
  return all;
}

// How far off a found pose is: displacement of the design's own points, mean, and the angle.
struct Miss {
  double mean_m = 1e9;
  double angle_rad = 4;
};

Miss miss_of(const Scene& scene, const PreparedDesign& design, const Pose& T_design_scan) {
  Miss least;
  std::vector<Pose> symmetries = scene.symmetries;
  if (symmetries.empty()) symmetries.push_back(Pose::Identity());
  for (const Instance& object : scene.objects)
    for (const Pose& symmetry : symmetries) {
      const Pose error = symmetry * T_design_scan * object.T_scan_design;
      double sum = 0;
      for (const Eigen::Vector3f& p : design.samples.cloud.points) {
        const Eigen::Vector3d q = p.cast<double>() + design.model.origin;
        sum += (error * q - q).norm();
      }
      const double mean = sum / static_cast<double>(design.samples.cloud.size());
      if (mean < least.mean_m) least = {mean, pose_size(error).rotation_rad};
    }
  return least;
}

struct Tally {
  int right = 0, wrong = 0, silent = 0, ambiguous = 0, named = 0;
  std::vector<double> seconds, mean_mm, angle_deg, vr, nr, rr;
};

double share(std::size_t part, std::size_t whole) {
  return whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole);
}

void add_classes(const Scene& scene, const Inspection& inspection, Tally& tally) {
  std::size_t object = 0, missed = 0, kept_clutter = 0;
  for (std::size_t i = 0; i < scene.labels.size(); ++i) {
    const bool is_kept = inspection.declutter.classes[i] != PointClass::kClutter;
    if (scene.labels[i] < kFloor) {
      ++object;
      missed += is_kept ? 0U : 1U;
    } else {
      kept_clutter += is_kept ? 1U : 0U;
    }
  }
  tally.vr.push_back(share(missed, object));
  tally.nr.push_back(share(kept_clutter, object));
}

Result<void> run(const Row& row, std::uint32_t seed, bool say_each, Tally& tally) {
  SceneRequest request = row.request;
  request.seed = seed;
  const Scene scene = make_scene(request);
  const auto file = std::filesystem::temp_directory_path() /
                    ("find-campaign-" + std::to_string(getpid()) + ".glb");
  if (auto written = write_file_whole(file, scene.glb()); !written) return written.error();
  auto model = read_design(file);
  std::filesystem::remove(file);
  if (!model) return model.error();
  const auto design = PreparedDesign::prepare(std::move(*model), 1, true);
  if (!design) return design.error();
  const NoiseModel noise{.constant_m = estimate_noise(scene.cloud)};
  auto inspection =
      Inspector(*design).process(scene.cloud, noise, {.align = AlignMethod::kFind, .seed = seed});
  if (!inspection) return inspection.error();
  const Alignment& alignment = inspection->alignment;
  tally.seconds.push_back(inspection->timing_s["find"]);
  std::string what = "silent: " + alignment.reason;
  if (!alignment.found) {
    ++tally.silent;
  } else {
    const Miss miss = miss_of(scene, **design, alignment.T_design_scan);
    const bool is_right = miss.mean_m < 0.01 * (*design)->finder->size_m;
    ++(is_right ? tally.right : tally.wrong);
    tally.ambiguous += alignment.ambiguous ? 1 : 0;
    if (is_right) {
      tally.mean_mm.push_back(1000 * miss.mean_m);
      tally.angle_deg.push_back(miss.angle_rad * 180 / std::numbers::pi);
      add_classes(scene, *inspection, tally);
    }
    what = (is_right ? "right" : "WRONG") + std::string(alignment.ambiguous ? ", ambiguous" : "") +
           ", " + std::to_string(1000 * miss.mean_m) + " mm";
  }
  for (const Finding& finding : inspection->findings)
    if (!finding.part.empty())
      what += "; " + finding.kind + " " + finding.part + ": " + finding.text;
  if (say_each) {
    std::printf("  %s %u: %s (object %zu of %zu)", row.name.c_str(), seed, what.c_str(),
                scene.object_points, scene.cloud.size());
    for (const Defect& defect : scene.request.defects)
      std::printf(" [defect of %s]", defect.part.c_str());
    std::printf("\n");
  }
  return {};
}

double quantile(std::vector<double> values, double q) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return values[std::min(values.size() - 1,
                         static_cast<std::size_t>(q * static_cast<double>(values.size())))];
}

Result<int> campaign(const std::string& filter, int seeds, int first, bool say_each) {
  std::printf(
      "| %-18s | right | wrong | silent | ambig | s med / max | mm med / max | deg max | VR med / "
      "max | NR med / max |\n",
      "scene");
  for (const Row& row : rows()) {
    if (row.name.find(filter) == std::string::npos) continue;
    Tally tally;
    for (int seed = first; seed < first + seeds; ++seed)
      if (auto done = run(row, static_cast<std::uint32_t>(seed), say_each, tally); !done)
        return done.error();
    std::printf(
        "| %-18s | %5d | %5d | %6d | %5d | %.2f / %.2f | %.2f / %.2f | %.3f | %.4f / %.4f | %.4f / "
        "%.4f |\n",
        row.name.c_str(), tally.right, tally.wrong, tally.silent, tally.ambiguous,
        quantile(tally.seconds, 0.5), quantile(tally.seconds, 1), quantile(tally.mean_mm, 0.5),
        quantile(tally.mean_mm, 1), quantile(tally.angle_deg, 1), quantile(tally.vr, 0.5),
        quantile(tally.vr, 1), quantile(tally.nr, 0.5), quantile(tally.nr, 1));
    std::fflush(stdout);
  }
  return 0;
}

}  // namespace
}  // namespace spool::campaign

int main(int argc, char** argv) {
  CLI::App app{"Finds designs in scenes of known truth and prints how often that was right."};
  std::string filter;
  int seeds = 10, first = 1;
  bool say_each = false;
  spool::add_common_options(app, "spoolsight-find-campaign");
  app.add_option("--rows", filter, "Only rows whose name holds this text")->type_name("TEXT");
  app.add_option("--seeds", seeds, "Scenes of each row")->capture_default_str()->type_name("N");
  app.add_option("--first", first, "First seed")->capture_default_str()->type_name("N");
  app.add_flag("--each", say_each, "A line for each scene");
  return spool::run_program(
      app, argc, argv, [&] { return spool::campaign::campaign(filter, seeds, first, say_each); });
}
