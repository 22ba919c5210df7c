// The thesis's object finder (chapter 4, Algorithm 2): random scene pairs, looked up in the
// library.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/find/thesis_finder.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cassert>
#include <chrono>
#include <cmath>
#include <numeric>
#include <random>

#include "vision/core/parallel.h"
#include "vision/find/near_grid.h"
#include "vision/find/point_icp.h"
#include "vision/find/rigid_fit.h"
#include "vision/scan/normals.h"
#include "vision/scan/octree_thinning.h"
#include "vision/scan/point_index.h"

namespace spool {
namespace {

using Clock = std::chrono::steady_clock;

// The scan as a model of one density sees it.
struct Scene {
  PointCloud points;         // of even density, with normals
  bool has_outside = false;  // the normals' signs mean something
  NearGrid near;
};

Scene scene_of(const CloudView& scan, const PairModel& model, const PairLibraryOptions& made,
               double near_m, const Watch& watch) {
  Scene scene;
  scene.has_outside = scan.has_normals();
  scene.points = thin_by_octree(scan, even_leaves(model.leaf_m), watch);
  if (watch.cancelled()) return scene;
  const std::vector<Eigen::Vector3f> outside = std::move(scene.points.normals);
  const PointIndex index(scene.points.points);
  estimate_neighbour_normals(scene.points, index, static_cast<int>(made.normal_neighbours),
                             std::nullopt);
  for (std::size_t i = 0; i < outside.size(); ++i)
    if (scene.points.normals[i].dot(outside[i]) < 0) scene.points.normals[i] *= -1;
  scene.near = NearGrid(scene.points.points, near_m);
  return scene;
}

// A pose and how many model points it puts near the scene.
struct Hypothesis {
  std::size_t near = 0;
  Pose T_scan_design = Pose::Identity();
};

class Search {
 public:
  Search(const Scene& scene, const PairModel& model, double cell_rad,
         const ThesisFinderOptions& options, const Watch& watch)
      : scene_(scene), model_(model), cells_(cell_rad), options_(options), watch_(watch) {
    // A pose that supports less is not found anyway.
    const double least = options.min_support * static_cast<double>(model.points.size());
    best_.near = static_cast<std::size_t>(std::max(0.0, std::ceil(least) - 1));
  }

  void run(ThesisSearch& search) {
    const std::size_t count = scene_.points.size();
    std::vector<std::uint32_t> order(count);
    std::iota(order.begin(), order.end(), 0U);
    std::mt19937 random{options_.seed};
    const std::size_t tries =
        options_.max_iterations > 0 ? std::min(options_.max_iterations, count) : count;
    const auto enough = static_cast<std::size_t>(
        std::ceil(options_.enough_support * static_cast<double>(model_.points.size())));
    for (std::size_t i = 0; i < tries && !ended(); ++i) {
      // Drawn without putting back, one at a time (Fisher and Yates).
      std::swap(order[i], order[i + random() % (count - i)]);
      try_first_point(order[i]);
      ++search.iterations;
      watch_.report("finding", std::max(static_cast<double>(i + 1) / static_cast<double>(tries),
                                        seconds() / options_.time_limit_s));
      if (best_.near >= enough) break;
    }
    search.hypotheses = hypotheses_;
    search.seconds = seconds();
    search.out_of_time = out_of_time_;
    search.cancelled = watch_.cancelled();
    search.T_design_scan = best_.T_scan_design.inverse();
  }

 private:
  [[nodiscard]] double seconds() const {
    return std::chrono::duration<double>(Clock::now() - start_).count();
  }
  bool ended() {
    if (seconds() > options_.time_limit_s) out_of_time_ = true;
    return out_of_time_ || watch_.cancelled();
  }

  // All pairs of one s1, each with the signs that its normals may have.
  void try_first_point(std::uint32_t s1) {
    const auto& points = scene_.points.points;
    const auto& normals = scene_.points.normals;
    if (normals[s1].isZero()) return;
    std::vector<std::uint32_t> seconds_at_d;
    for (std::uint32_t s2 = 0; s2 < points.size(); ++s2) {
      const double distance = (points[s2] - points[s1]).norm();
      if (std::abs(distance - model_.distance_m) <= model_.tolerance_m && !normals[s2].isZero())
        seconds_at_d.push_back(s2);
    }
    const std::size_t signs = scene_.has_outside ? 1 : 4;
    std::vector<Hypothesis> best_of(seconds_at_d.size() * signs);
    std::atomic<std::size_t> tested{0};
    parallel_chunks(best_of.size(), 1, [&](std::size_t task, std::size_t) {
      if (ended()) return;
      const std::uint32_t s2 = seconds_at_d[task / signs];
      const Eigen::Vector3f n1 =
          (task % signs & 1U) != 0 ? Eigen::Vector3f(-normals[s1]) : normals[s1];
      const Eigen::Vector3f n2 =
          (task % signs & 2U) != 0 ? Eigen::Vector3f(-normals[s2]) : normals[s2];
      best_of[task] = best_of_pair(points[s1], n1, points[s2], n2, tested);
    });
    hypotheses_ += tested;
    for (const Hypothesis& hypothesis : best_of)
      if (hypothesis.near > best_.near) best_ = hypothesis;
  }

  Hypothesis best_of_pair(const Eigen::Vector3f& s1, const Eigen::Vector3f& n1,
                          const Eigen::Vector3f& s2, const Eigen::Vector3f& n2,
                          std::atomic<std::size_t>& tested) {
    Hypothesis best{.near = best_.near};
    const auto alike = model_.in_cell(cells_.cell_of(pair_feature(s1, n1, s2, n2)));
    const auto scene_four = four_points(s1, n1, s2, n2);
    std::size_t done = 0;
    for (const OrientedPair& pair : alike) {
      if (++done % 256 == 0 && ended()) break;
      const auto& points = model_.points.points;
      const auto& normals = model_.points.normals;
      const Pose T_scan_design =
          fit_rigid_motion(four_points(points[pair.first], normals[pair.first], points[pair.second],
                                       normals[pair.second]),
                           scene_four);
      const std::size_t near = count_near(T_scan_design.cast<float>(), best.near);
      if (near > best.near) best = {near, T_scan_design};
    }
    tested += done;
    return best;
  }

  // The pair and the ends of its unit normals (figure 4-8: 1 m long).
  static std::array<Eigen::Vector3d, 4> four_points(const Eigen::Vector3f& p1,
                                                    const Eigen::Vector3f& n1,
                                                    const Eigen::Vector3f& p2,
                                                    const Eigen::Vector3f& n2) {
    return {p1.cast<double>(), p2.cast<double>(), (p1 + n1).cast<double>(),
            (p2 + n2).cast<double>()};
  }

  // m_s: the model points near the scene; 0 as soon as they cannot be more than `to_beat`. (The
  // model's points are in no order, so that a wrong pose shows early.)
  [[nodiscard]] std::size_t count_near(const Eigen::Isometry3f& T_scan_design,
                                       std::size_t to_beat) const {
    const auto& points = model_.points.points;
    std::size_t may_miss = points.size() - std::min(points.size(), to_beat);
    std::size_t near = 0;
    for (const Eigen::Vector3f& p : points) {
      if (scene_.near.is_near(T_scan_design * p)) {
        ++near;
      } else {
        if (may_miss <= 1) return 0;
        --may_miss;
      }
    }
    return near > to_beat ? near : 0;
  }

  const Scene& scene_;
  const PairModel& model_;
  FeatureCells cells_;
  const ThesisFinderOptions& options_;
  const Watch& watch_;
  Clock::time_point start_ = Clock::now();
  Hypothesis best_;
  std::size_t hypotheses_ = 0;
  std::atomic<bool> out_of_time_{false};
};

double support_of(const PairModel& model, const PointIndex& scan, const Pose& T_design_scan,
                  double near_m) {
  const Eigen::Isometry3f T_scan_design = T_design_scan.inverse().cast<float>();
  std::size_t near = 0;
  for (const Eigen::Vector3f& p : model.points.points)
    near += scan.nearest(T_scan_design * p, static_cast<float>(near_m)) ? 1U : 0U;
  return static_cast<double>(near) / static_cast<double>(model.points.size());
}

}  // namespace

std::optional<Error> validate(const ThesisFinderOptions& options) {
  const auto refused = [](const char* what) {
    return Error{ErrorCode::kUsage, std::string("finder: ") + what};
  };
  if (!(options.min_support > 0 && options.min_support <= 1))
    return refused("the least support is a share of the model's points, over 0 and at most 1");
  if (!(options.enough_support >= options.min_support))
    return refused("enough support is no less than the least");
  if (!(options.time_limit_s > 0)) return refused("the time limit is over 0 s");
  if (options.icp_iterations < 0) return refused("ICP iterations are 0 or more");
  if (!(options.near_over_leaf > 0 && options.near_over_leaf <= 100))
    return refused("near is over 0 and at most 100 leaves");
  return std::nullopt;
}

std::vector<ThesisSearch> find_as_thesis(const CloudView& scan, const PairLibrary& library,
                                         const ThesisFinderOptions& options, const Watch& watch) {
  assert(!validate(options) && "options that make sense");
  const PointIndex index(scan.points);
  std::vector<ThesisSearch> searches;
  for (const PairModel& model : library.models) {
    ThesisSearch& search = searches.emplace_back();
    search.near_m = options.near_over_leaf * model.leaf_m;
    const Scene scene = scene_of(scan, model, library.options, search.near_m, watch);
    if (watch.cancelled()) {
      search.cancelled = true;
      continue;
    }
    Search(scene, model, library.options.cell_rad, options, watch).run(search);
    search.T_design_scan =
        refine_point_to_point(model.points, index, scan, search.T_design_scan,
                              {.iterations = options.icp_iterations, .reach_m = 2 * search.near_m});
    search.support = support_of(model, index, search.T_design_scan, search.near_m);
    search.found = !search.cancelled && search.support >= options.min_support;
  }
  return searches;
}

std::vector<std::uint32_t> isolate(const CloudView& scan, const CloudView& model,
                                   const Pose& T_design_scan, double distance_m,
                                   const Watch& watch) {
  const PointIndex index(model.points);
  const Eigen::Isometry3f T = T_design_scan.cast<float>();
  std::vector<std::uint8_t> is_near(scan.size(), 0);
  parallel_chunks(scan.size(), 4096, [&](std::size_t begin, std::size_t end) {
    if (watch.cancelled()) return;
    for (std::size_t i = begin; i < end; ++i)
      is_near[i] = index.nearest(T * scan.points[i], static_cast<float>(distance_m)).has_value();
  });
  std::vector<std::uint32_t> places;
  for (std::size_t i = 0; i < scan.size(); ++i)
    if (is_near[i] != 0) places.push_back(static_cast<std::uint32_t>(i));
  return places;
}

}  // namespace spool
