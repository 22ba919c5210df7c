// spoolsight-find-campaign: how often the finder is right, wrong or silent on scenes of known
// truth.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdio>
#include <numbers>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/common/cli.h"
#include "tools/campaign/campaign_options.h"
#include "tools/campaign/find_rows.h"
#include "tools/campaign/find_trial.h"
#include "tools/campaign/quantile.h"
#include "vision/find/finder.h"
#include "vision/scan/point_index.h"

namespace spool::campaign {
namespace {

struct Tally {
  int right = 0, wrong = 0, silent = 0, ambiguous = 0;
  int at_fault = 0;             // scenes found right in which a part is at fault:
  int named = 0, misnamed = 0;  // where those parts and no others were named; where others were
  std::vector<double> seconds, mean_mm, angle_deg, vr, nr;
};

double share(std::size_t part, std::size_t whole) {
  return whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole);
}

// Which points touch the other kind: within three standard deviations nobody can tell them apart.
std::vector<std::uint8_t> touching(const Scene& scene, double noise_m) {
  std::vector<Eigen::Vector3f> object, clutter;
  for (std::size_t i = 0; i < scene.labels.size(); ++i)
    (scene.labels[i] < kFloor ? object : clutter).push_back(scene.cloud.points[i]);
  const PointIndex of_object(object), of_clutter(clutter);
  const auto near = static_cast<float>(3 * noise_m);
  std::vector<std::uint8_t> touches(scene.labels.size(), 0);
  for (std::size_t i = 0; i < touches.size(); ++i) {
    const PointIndex& other = scene.labels[i] < kFloor ? of_clutter : of_object;
    touches[i] = other.nearest(scene.cloud.points[i], near).has_value() ? 1 : 0;
  }
  return touches;
}

// VR and NR (DOMAIN A2: both over the object's points).
void add_classes(const Scene& scene, const Inspection& inspection, double noise_m, Tally& tally) {
  std::size_t object = 0, missed = 0, kept_clutter = 0;
  const std::vector<std::uint8_t> touches = touching(scene, noise_m);
  for (std::size_t i = 0; i < scene.labels.size(); ++i) {
    const bool is_object = scene.labels[i] < kFloor;
    object += is_object ? 1U : 0U;
    if (touches[i] != 0) continue;
    const bool is_kept = inspection.declutter.classes[i] != PointClass::kClutter;
    missed += is_object && !is_kept ? 1U : 0U;
    kept_clutter += !is_object && is_kept ? 1U : 0U;
  }
  tally.vr.push_back(share(missed, object));
  tally.nr.push_back(share(kept_clutter, object));
}

void add_names(const Scene& scene, const Inspection& inspection, Tally& tally) {
  std::set<std::string> at_fault, named;
  for (const Defect& defect : scene.request.defects) {
    at_fault.insert(defect.part);
    if (!defect.other.empty()) at_fault.insert(defect.other);
  }
  for (const Finding& finding : inspection.findings)
    if (!finding.part.empty()) named.insert(finding.part);
  tally.at_fault += at_fault.empty() ? 0 : 1;
  tally.named += !at_fault.empty() && named == at_fault ? 1 : 0;
  tally.misnamed +=
      std::includes(at_fault.begin(), at_fault.end(), named.begin(), named.end()) ? 0 : 1;
}

// The poses that were weighed, and what speaks for each.
void print_tried(const FindTrial& trial, std::uint32_t seed) {
  const FindResult result = find_design(*trial.design->finder, trial.scene.cloud.points,
                                        {.noise_m = trial.noise_m, .seed = seed});
  std::printf("    noise %.2f mm, %zu points thinned, %d planes, %d rounds\n", 1000 * trial.noise_m,
              result.thinned_to, result.planes, result.rounds);
  for (std::size_t i = 0; i < std::min<std::size_t>(8, result.tried.size()); ++i) {
    const PoseEvidence& pose = result.tried[i];
    const Pose T = Eigen::Translation3d(trial.design->model.origin) * pose.T_design_scan;
    std::printf(
        "    off %7.1f mm: explains %zu, %.0f by chance, coverage %.2f, free %d, scale %.2f mm, "
        "drawn %d; parts",
        1000 * miss_of(trial, T).mean_m, pose.explained, pose.chance, pose.coverage,
        pose.free_motions, 1000 * pose.scale_m, pose.hits);
    for (const std::uint32_t points : pose.per_part) std::printf(" %u", points);
    std::printf("\n");
  }
}

// Nothing shows of some faults: what is turned hangs on a straight run alone, which looks the same
// when it is turned as well.
bool is_moot(const Scene& scene) {
  for (const Defect& defect : scene.request.defects) {
    if (defect.kind != DefectKind::kTurned) continue;
    int part = 0;
    const auto& members = scene.design.members;
    while (members[static_cast<std::size_t>(part)].spec.name != defect.part) ++part;
    bool is_straight = true;
    for (std::size_t i = 0; i < members.size(); ++i) {
      const PartKind kind = members[i].spec.kind;
      if (hangs_on(scene.design, static_cast<int>(i), part)) continue;
      is_straight = is_straight && (kind == PartKind::kPipe || kind == PartKind::kFlange);
    }
    if (is_straight) return true;
  }
  return false;
}

struct Wanted : CampaignOptions {
  std::optional<double> station_error_m;  // instead of the rows' own
  bool tried = false;                     // the poses that were weighed as well
};

Result<void> run(const FindRow& row, std::uint32_t seed, const Wanted& wanted, Tally& tally) {
  SceneRequest request = row.request;
  request.station_error_m = wanted.station_error_m.value_or(request.station_error_m);
  request.seed = seed;
  auto trial = make_find_trial(make_scene(request));
  if (!trial) return trial.error();
  const Scene& scene = trial->scene;
  if (is_moot(scene)) {
    if (wanted.each)
      std::printf("  %s %u: left out, nothing of it shows\n", row.name.c_str(), seed);
    return {};
  }
  const NoiseModel noise{.constant_m = trial->noise_m};
  auto inspection = Inspector(trial->design)
                        .process(scene.cloud, noise, {.align = AlignMethod::kFind, .seed = seed});
  if (!inspection) return inspection.error();
  const Alignment& alignment = inspection->alignment;
  tally.seconds.push_back(inspection->timing_s["find"]);
  std::string what = "silent: " + alignment.reason;
  if (!alignment.found) {
    ++tally.silent;
  } else {
    const Miss miss = miss_of(*trial, alignment.T_design_scan);
    const bool is_right = miss.mean_m < 0.01 * trial->design->finder->size_m;
    ++(is_right ? tally.right : tally.wrong);
    tally.ambiguous += alignment.ambiguous && !alignment.is_symmetric ? 1 : 0;
    if (is_right) {
      tally.mean_mm.push_back(1000 * miss.mean_m);
      tally.angle_deg.push_back(miss.angle_rad * 180 / std::numbers::pi);
      add_classes(scene, *inspection, noise.constant_m, tally);
      add_names(scene, *inspection, tally);
    }
    what = (is_right ? "right" : "WRONG") + std::string(alignment.ambiguous ? ", ambiguous" : "") +
           ", " + std::to_string(1000 * miss.mean_m) + " mm";
    if (is_right)
      what += ", VR " + std::to_string(tally.vr.back()) + ", NR " + std::to_string(tally.nr.back());
  }
  for (const Finding& finding : inspection->findings)
    if (!finding.part.empty())
      what += "; " + finding.kind + " " + finding.part + ": " + finding.text;
  if (wanted.each) {
    std::printf("  %s %u: %s (object %zu of %zu)", row.name.c_str(), seed, what.c_str(),
                scene.object_points, scene.cloud.size());
    for (const Defect& defect : scene.request.defects)
      std::printf(" [%s: %s %s]", name(defect.kind), defect.part.c_str(), defect.other.c_str());
    std::printf("\n");
  }
  if (wanted.tried) print_tried(*trial, seed);
  return {};
}

Result<int> campaign(const Wanted& wanted) {
  std::printf(
      "| %-21s | right | wrong | silent | ambig | named / of | misnamed | s med / max | mm med / "
      "max | "
      "deg max | VR med / "
      "max | NR med / max |\n",
      "scene");
  for (const FindRow& row : find_rows()) {
    if (!wanted.wants(row.name)) continue;
    Tally tally;
    for (int seed = wanted.first; seed < wanted.past_last(); ++seed)
      if (auto done = run(row, static_cast<std::uint32_t>(seed), wanted, tally); !done)
        return done.error();
    std::printf(
        "| %-21s | %5d | %5d | %6d | %5d | %5d / %2d | %8d | %.2f / %.2f | %.2f / %.2f | %.3f | "
        "%.4f / "
        "%.4f | %.4f / "
        "%.4f |\n",
        row.name.c_str(), tally.right, tally.wrong, tally.silent, tally.ambiguous, tally.named,
        tally.at_fault, tally.misnamed, quantile(tally.seconds, 0.5), quantile(tally.seconds, 1),
        quantile(tally.mean_mm, 0.5), quantile(tally.mean_mm, 1), quantile(tally.angle_deg, 1),
        quantile(tally.vr, 0.5), quantile(tally.vr, 1), quantile(tally.nr, 0.5),
        quantile(tally.nr, 1));
    std::fflush(stdout);
  }
  return 0;
}

}  // namespace
}  // namespace spool::campaign

int main(int argc, char** argv) {
  CLI::App app{"Finds designs in scenes of known truth and prints how often that was right."};
  spool::campaign::Wanted wanted;
  wanted.seeds = 10;
  spool::add_common_options(app, "spoolsight-find-campaign");
  spool::campaign::add_campaign_options(app, "scene", wanted);
  app.add_option("--station-error-m", wanted.station_error_m,
                 "Error of each laser station's registration, instead of 0.0006; 0: noise alone")
      ->type_name("M");
  app.add_flag("--tried", wanted.tried, "The poses that were weighed in each scene as well");
  return spool::run_program(app, argc, argv, [&] { return spool::campaign::campaign(wanted); });
}
