// spoolsight-compare-icp: our ICP beside Open3D's and PCL's, on the same points in one run.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>

#include "app/common/cli.h"
#include "tools/compare/icp_case.h"
#include "tools/compare/summary.h"
#include "vision/align/icp.h"

namespace spool::compare {
namespace {

// Ours onto the design's surface, or onto the target's points alone as the others.
class Ours final : public PreparedIcp {
 public:
  Ours(const IcpCase& of, bool onto_points) : of_(of) {
    if (onto_points) points_.emplace(*DesignSurface::build(CloudView(of.target)));
  }

  Pose run(int iterations) override {
    const IcpOptions options{.max_iterations = iterations,
                             .start_distance_m = of_.reach_m,
                             .noise_m = of_.noise_m,
                             .stop_translation_m = 1e-15,  // never: all iterations are asked for
                             .stop_rotation_rad = 1e-15};
    return refine_icp(of_.source, points_ ? *points_ : *of_.design->surface, of_.T_guess, options)
        .T_design_scan;
  }

 private:
  const IcpCase& of_;
  std::optional<DesignSurface> points_;
};

std::vector<IcpContender> contenders() {
  std::vector<IcpContender> all{
      {"ours, onto points", [](const IcpCase& of) { return std::make_unique<Ours>(of, true); }},
      {"ours, onto the mesh", [](const IcpCase& of) { return std::make_unique<Ours>(of, false); }}};
  const auto add = [&](std::vector<IcpContender> more) {
    all.insert(all.end(), more.begin(), more.end());
  };
#ifdef SPOOL_COMPARE_OPEN3D
  add(open3d_icp());
#endif
#ifdef SPOOL_COMPARE_PCL
  add(pcl_icp());
#endif
  return all;
}

// Wall time, and processor time of all threads: on a busy machine only the second says anything.
struct Seconds {
  double wall = 1e9, processor = 1e9;
};

Seconds least(const Seconds& a, const Seconds& b) {
  return {std::min(a.wall, b.wall), std::min(a.processor, b.processor)};
}

template <class Work>
Seconds seconds_of(const Work& work) {
  const auto processor = [] {
    timespec t{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
  };
  const auto start = std::chrono::steady_clock::now();
  const double before = processor();
  work();
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  return {wall.count(), processor() - before};
}

struct Request {
  IcpCaseRequest of;
  int seeds = 5, repeats = 3;
  std::string filter;
};

constexpr int kFew = 10, kMany = 30;

// One contender over all cases.
struct Line {
  std::string name;
  std::vector<double> error_mm;               // after kFew iterations, one a case
  std::vector<double> wall_ms, processor_ms;  // an iteration of the first kFew
  std::vector<double> late_ms;                // wall, an iteration of those from kFew to kMany
};

void measure(const IcpCase& of, const IcpContender& contender, int repeats, Line& line) {
  const auto prepared = contender.prepare(of);
  Seconds index, few, many;
  Pose T = Pose::Identity();
  for (int i = 0; i < repeats; ++i) {
    index = least(index, seconds_of([&] { prepared->build_index(); }));
    few = least(few, seconds_of([&] { T = prepared->run(kFew); }));
    many = least(many, seconds_of([&] { (void)prepared->run(kMany); }));
  }
  line.error_mm.push_back(1000 * mean_displacement(of, T));
  line.wall_ms.push_back(1000 * (few.wall - index.wall) / kFew);
  line.processor_ms.push_back(1000 * (few.processor - index.processor) / kFew);
  line.late_ms.push_back(1000 * (many.wall - few.wall) / (kMany - kFew));
}

Result<int> compare(Request request) {
  std::vector<Line> lines;
  for (int seed = 1; seed <= request.seeds; ++seed) {
    request.of.seed = static_cast<std::uint32_t>(seed);
    const auto of = make_icp_case(request.of);
    if (!of) return of.error();
    std::fprintf(stderr, "case %d: %zu points onto %zu, %.2f mm off\n", seed, of->source.size(),
                 of->target.size(), 1000 * mean_displacement(*of, of->T_guess));
    std::size_t at = 0;
    for (const IcpContender& contender : contenders()) {
      if (contender.name.find(request.filter) == std::string::npos) continue;
      if (at == lines.size()) lines.push_back({contender.name, {}, {}, {}, {}});
      measure(*of, contender, request.repeats, lines[at++]);
    }
  }
  std::printf(
      "| %-30s | error after %d, median / most | ms an iteration of the first %d, wall / "
      "processor | of those from %d to %d, wall |\n|---|---|---|---|\n",
      "", kFew, kFew, kFew + 1, kMany);
  for (const Line& line : lines)
    std::printf("| %-30s | %.2f / %.2f mm | %.2f / %.2f | %.2f |\n", line.name.c_str(),
                median(line.error_mm), most(line.error_mm), median(line.wall_ms),
                median(line.processor_ms), median(line.late_ms));
  return 0;
}

}  // namespace
}  // namespace spool::compare

int main(int argc, char** argv) {
  CLI::App app{
      "Refines the same guesses with our ICP, Open3D's and PCL's, and prints error and time."};
  spool::compare::Request request;
  spool::add_common_options(app, "spoolsight-compare-icp");
  app.add_option("--points", request.of.source_points, "Points of the scan")->capture_default_str();
  app.add_option("--onto", request.of.target_points, "Points of the design")->capture_default_str();
  app.add_option("--station-error-m", request.of.station_error_m,
                 "Registration error of each scanner station, one axis")
      ->capture_default_str();
  app.add_option("--seeds", request.seeds, "Cases")->capture_default_str();
  app.add_option("--repeats", request.repeats, "Runs of each, the least time counts")
      ->capture_default_str();
  app.add_option("--only", request.filter, "Only what has this in its name")->type_name("TEXT");
  return spool::run_program(app, argc, argv, [&] { return spool::compare::compare(request); });
}
