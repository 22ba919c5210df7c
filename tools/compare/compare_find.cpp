// spoolsight-compare-find: our finder beside PCL's and Open3D's, on the same scenes in one run.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <chrono>
#include <cstdio>

#include "app/common/cli.h"
#include "tools/compare/find_case.h"
#include "tools/compare/summary.h"
#include "vision/find/finder.h"

namespace spool::compare {
namespace {

// Ours reads the whole scan, thins it itself and works out its normals; the others are given both.
std::optional<Pose> ours(const ComparedTrial& of) {
  const FindResult found = find_design(*of.trial.design->finder, of.trial.scene.cloud.points,
                                       {.noise_m = of.points.noise_m, .seed = of.points.seed});
  if (!found.found) return std::nullopt;
  return found.best.T_design_scan;
}

struct Method {
  std::string name;
  std::function<std::optional<Pose>(const ComparedTrial&)> find;
};

std::vector<Method> methods() {
  std::vector<Method> all{{"ours", ours}};
  [[maybe_unused]] const auto add = [&](const std::vector<FindContender>& more) {
    for (const FindContender& each : more)
      all.push_back(
          {each.name, [find = each.find](const ComparedTrial& of) { return find(of.points); }});
  };
#ifdef SPOOL_COMPARE_OPEN3D
  add(open3d_find());
#endif
#ifdef SPOOL_COMPARE_PCL
  add(pcl_find());
#endif
  return all;
}

struct Tally {
  int right = 0, wrong = 0, silent = 0;
  std::vector<double> seconds, miss_mm;  // miss of those that were right
};

void judge(const ComparedTrial& of, const Method& method, Tally& tally) {
  const auto start = std::chrono::steady_clock::now();
  const std::optional<Pose> pose = method.find(of);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  tally.seconds.push_back(took.count());
  if (!pose) {
    ++tally.silent;
    return;
  }
  const double miss_m = mean_miss(of, *pose);
  if (miss_m < 0.02 * of.points.size_m) {
    ++tally.right;
    tally.miss_mm.push_back(1000 * miss_m);
  } else {
    ++tally.wrong;
  }
}

Result<int> compare(const std::string& filter, const std::string& only, int seeds) {
  std::printf(
      "| scene | method | right / wrong / silent | s, median / most | mean displacement of "
      "the right, median / most |\n|---|---|---|---|---|\n");
  for (const campaign::FindRow& row : compared_rows()) {
    if (row.name.find(filter) == std::string::npos) continue;
    const std::vector<Method> all = methods();
    std::vector<Tally> tallies(all.size());
    for (int seed = 1; seed <= seeds; ++seed) {
      campaign::SceneRequest request = row.request;
      request.seed = static_cast<std::uint32_t>(seed);
      const auto scene = make_compared_trial(request);
      if (!scene) return scene.error();
      std::fprintf(stderr, "%s %d: %zu points, thinned for the others to %zu onto %zu\n",
                   row.name.c_str(), seed, scene->trial.scene.cloud.size(),
                   scene->points.scan.size(), scene->points.design.size());
      for (std::size_t i = 0; i < all.size(); ++i)
        if (all[i].name.find(only) != std::string::npos) judge(*scene, all[i], tallies[i]);
    }
    for (std::size_t i = 0; i < all.size(); ++i)
      if (!tallies[i].seconds.empty())
        std::printf("| %s | %s | %d / %d / %d | %.2f / %.2f | %.1f / %.1f mm |\n", row.name.c_str(),
                    all[i].name.c_str(), tallies[i].right, tallies[i].wrong, tallies[i].silent,
                    median(tallies[i].seconds), most(tallies[i].seconds),
                    median(tallies[i].miss_mm), most(tallies[i].miss_mm));
    std::fflush(stdout);
  }
  return 0;
}

}  // namespace
}  // namespace spool::compare

int main(int argc, char** argv) {
  CLI::App app{"Looks for designs in scenes of known truth with our finder, PCL's and Open3D's."};
  std::string filter, only;
  int seeds = 3;
  spool::add_common_options(app, "spoolsight-compare-find");
  app.add_option("--rows", filter, "Only rows whose name holds this text")->type_name("TEXT");
  app.add_option("--only", only, "Only methods whose name holds this text")->type_name("TEXT");
  app.add_option("--seeds", seeds, "Scenes of each row")->capture_default_str()->type_name("N");
  return spool::run_program(app, argc, argv,
                            [&] { return spool::compare::compare(filter, only, seeds); });
}
