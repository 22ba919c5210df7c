// Tables 4-5 to 4-12 from scenes of our own, the printed numbers beside them.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/thesis/finding_tables.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <span>

#include <fmt/core.h>

#include "tools/thesis/bench_scene.h"
#include "tools/thesis/printed_tables.h"
#include "vision/find/measures.h"

namespace spool::thesis {
namespace {

using campaign::ObjectKind;
using campaign::SceneRequest;

// What chapter 4 measures of one scene.
struct Finding {
  std::size_t points = 0;
  double clutter_ratio = 0, completeness = 1;
  int success = 0;
  double rr = 0, point_rms_m = 0, surface_rms_m = 0, seconds = 0, support = 0;
};

class Bench {
 public:
  Bench(const FindingBench& bench, const Watch& watch) : bench_(bench), watch_(watch) {}

  Result<Finding> find(const SceneRequest& request, double time_limit_s) {
    const BenchScene scene = make_bench_scene(request);
    const auto library = models_.library_of(scene.design);
    if (!library) return library.error();
    const PairModel& model = library->models.front();
    ThesisFinderOptions options = bench_.finder;
    options.seed = bench_.seed;
    options.time_limit_s = time_limit_s;
    const ThesisSearch search = find_as_thesis(scene.cloud, *library, options, watch_).front();
    Finding finding{.points = scene.cloud.size(),
                    .clutter_ratio = scene.clutter_ratio,
                    .completeness = scene.completeness,
                    .seconds = search.seconds,
                    .support = search.support};
    Eigen::AlignedBox3d box = scene.design.bounds();
    for (const Pose& truth : scene.true_T_design_scan)
      finding.success = std::max(
          finding.success,
          search.found ? success(search.T_design_scan, truth, box, bench_.success_limit_m) : 0);
    if (finding.success == 0) return finding;
    const auto places =
        isolate(scene.cloud, model.points, search.T_design_scan, search.near_m, watch_);
    std::vector<std::uint8_t> is_kept(scene.cloud.size(), 0);
    std::vector<Eigen::Vector3f> isolated, in_design;
    const Eigen::Isometry3f T = search.T_design_scan.cast<float>();
    for (const std::uint32_t place : places) {
      is_kept[place] = 1;
      isolated.push_back(scene.cloud.points[place]);
      in_design.push_back(T * scene.cloud.points[place]);
    }
    finding.rr = recognition_rate(count_kept(scene.is_object, is_kept));
    finding.point_rms_m = rms_point_to_point(model.points, CloudView(in_design), watch_).rms_m;
    const auto surface = DesignSurface::build(scene.design);
    if (!surface) return surface.error();
    finding.surface_rms_m = rms_point_to_surface(CloudView(isolated), *surface,
                                                 search.T_design_scan, search.near_m, watch_)
                                .rms_m;
    return finding;
  }

  [[nodiscard]] const FindingBench& settings() const { return bench_; }

 private:
  const FindingBench& bench_;
  const Watch& watch_;
  Models models_;
};

std::string text(const std::optional<double>& value, int digits) {
  return value ? fmt::format("{:.{}f}", *value, digits) : "failed";
}
std::optional<double> if_found(const Finding& finding, double value) {
  return finding.success != 0 ? std::optional(value) : std::nullopt;
}

SceneRequest request_of(ObjectKind kind, std::uint32_t seed) {
  SceneRequest request;
  request.kind = kind;
  request.seed = seed;
  return request;
}

// Tables 4-5 to 4-8: over density or over clutter.
Status print_variation(Bench& bench, ObjectKind kind, bool over_density,
                       std::span<const FindingRow> printed, std::ostream& out) {
  out << fmt::format("{:>9}{:>9} |{:>7}{:>9}{:>9}{:>8}{:>9} | printed{:>7}{:>9}{:>8}\n",
                     over_density ? "density" : "clutter", "points", "RR", "RMS cm", "s", "support",
                     "surf. cm", "RR", "RMS cm", "s");
  for (const FindingRow& row : printed) {
    SceneRequest request = request_of(kind, bench.settings().seed);
    if (over_density) {
      request.density_ratio = row.ratio;
    } else {
      request.scene_points = row.points;
      request.clutter_ratio = row.ratio;
    }
    const auto found = bench.find(request, bench.settings().finder.time_limit_s);
    if (!found) return found.error();
    out << fmt::format("{:>9.3f}{:>9} |{:>7.3f}{:>9}{:>9.1f}{:>8.2f}{:>9} | {:>14.3f}{:>9}{:>8}\n",
                       over_density ? row.ratio : found->clutter_ratio, found->points, found->rr,
                       text(if_found(*found, 100 * found->point_rms_m), 2), found->seconds,
                       found->support, text(if_found(*found, 100 * found->surface_rms_m), 2),
                       row.rr, text(row.rms_cm, 2), text(row.seconds, 1))
        << std::flush;
  }
  return {};
}

// Tables 4-9 and 4-10. Ours is the object's completeness; the thesis's is the whole scene's
// (THESIS.md, A17), so that rows of its ratios would take nothing off the object.
Status print_completeness(Bench& bench, ObjectKind kind, std::span<const CompletenessRow> printed,
                          std::ostream& out) {
  out << fmt::format("{:>9}{:>9} |{:>4}{:>9}{:>9} | printed{:>9}{:>9}{:>4}{:>8}\n", "complete",
                     "points", "SR", "s", "support", "ratio", "points", "SR", "s");
  const double ours[] = {0.95, 0.85, 0.7, 0.5};
  for (std::size_t i = 0; i < printed.size(); ++i) {
    SceneRequest request = request_of(kind, bench.settings().seed);
    request.completeness = ours[i];
    const auto found = bench.find(request, bench.settings().finder.time_limit_s);
    if (!found) return found.error();
    out << fmt::format("{:>9.3f}{:>9} |{:>4}{:>9.1f}{:>9.2f} | {:>16.3f}{:>9}{:>4}{:>8}\n",
                       found->completeness, found->points, found->success, found->seconds,
                       found->support, printed[i].ratio, printed[i].points, printed[i].success,
                       text(printed[i].seconds, 1))
        << std::flush;
  }
  return {};
}

// Tables 4-11 and 4-12: successes at t over successes at t or, after a failure, at 2 t.
Status print_effectiveness(Bench& bench, ObjectKind kind, double printed, std::ostream& out) {
  std::size_t at_once = 0, at_all = 0;
  const double limit = bench.settings().finder.time_limit_s;
  for (int i = 0; i < bench.settings().effectiveness_scenes; ++i) {
    const SceneRequest request =
        request_of(kind, bench.settings().seed + static_cast<std::uint32_t>(i));
    auto found = bench.find(request, limit);
    if (!found) return found.error();
    if (found->success != 0) {
      ++at_once;
      ++at_all;
      continue;
    }
    found = bench.find(request, 2 * limit);
    if (!found) return found.error();
    at_all += found->success != 0 ? 1U : 0U;
  }
  out << fmt::format("ER {:.2f} ({} of {} successes, {} scenes) | printed {:.2f}\n",
                     effectiveness_ratio(at_once, at_all), at_once, at_all,
                     bench.settings().effectiveness_scenes, printed);
  return {};
}

}  // namespace

Status print_finding_table(const std::string& name, const FindingBench& settings, std::ostream& out,
                           const Watch& watch) {
  Bench bench(settings, watch);
  constexpr ObjectKind kSpool = ObjectKind::kPipeSpool3m, kFrame = ObjectKind::kBoxFrame;
  if (name == "4-5") return print_variation(bench, kSpool, true, kTable4_5, out);
  if (name == "4-6") return print_variation(bench, kFrame, true, kTable4_6, out);
  if (name == "4-7") return print_variation(bench, kSpool, false, kTable4_7, out);
  if (name == "4-8") return print_variation(bench, kFrame, false, kTable4_8, out);
  if (name == "4-9") return print_completeness(bench, kSpool, kTable4_9, out);
  if (name == "4-10") return print_completeness(bench, kFrame, kTable4_10, out);
  if (name == "4-11") return print_effectiveness(bench, kSpool, kTable4_11, out);
  if (name == "4-12") return print_effectiveness(bench, kFrame, kTable4_12, out);
  return Error{ErrorCode::kUsage, "there is no table " + name + " of chapter 4 here"};
}

}  // namespace spool::thesis
