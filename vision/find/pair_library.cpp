// The model library: each design's oriented pairs at one distance, hashed by their three angles.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/find/pair_library.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>
#include <random>
#include <type_traits>

#include "vision/core/file_digest.h"
#include "vision/core/median.h"
#include "vision/core/parallel.h"
#include "vision/design/sampling.h"
#include "vision/scan/normals.h"
#include "vision/scan/octree_thinning.h"

namespace spool {
namespace {

constexpr std::size_t kGrain = 64;
// Pairs whose normals lie along their line to within this say nothing about the turn round it.
constexpr double kNoTurn = 10.0 * std::numbers::pi / 180;

// Bytes that stand for values, in order.
class Bytes {
 public:
  template <class T>
  void add(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    text_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  template <class T>
  void add_all(const std::vector<T>& values) {
    add(static_cast<std::uint64_t>(values.size()));
    for (const T& value : values)
      for (const auto& number : value) add(number);
  }
  [[nodiscard]] std::string_view text() const { return text_; }

 private:
  std::string text_;
};

// The largest distance (m) between two points; 0 where it was cancelled.
double diameter_of(const std::vector<Eigen::Vector3f>& points, const Watch& watch) {
  std::vector<float> largest(points.size() / kGrain + 1, 0.0F);
  parallel_chunks(points.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    if (watch.cancelled()) return;
    float squared = 0;
    for (std::size_t i = begin; i < end; ++i)
      for (std::size_t k = i + 1; k < points.size(); ++k)
        squared = std::max(squared, (points[i] - points[k]).squaredNorm());
    largest[begin / kGrain] = squared;
  });
  return watch.cancelled() ? 0 : std::sqrt(*std::max_element(largest.begin(), largest.end()));
}

// How far apart the samples are (m). A design cloud of too few points to thin says no radius: half
// of its points then have another within this.
double spacing_of(const SurfaceSamples& samples) {
  if (samples.radius_m > 0 || samples.cloud.size() < 2) return samples.radius_m;
  const PointIndex index(samples.cloud.points);
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& p : samples.cloud.points) box.extend(p);
  std::vector<float> nearest;
  std::vector<Neighbour> two;
  for (const Eigen::Vector3f& p : samples.cloud.points) {
    index.nearest_k(p, 2, box.diagonal().norm() * 1.001F + 1e-6F, two);
    if (two.size() == 2) nearest.push_back(two[1].distance);
  }
  if (nearest.empty()) return 0;
  return median(nearest);
}

// Normals of the neighbours' planes, on the side of those the points have (if any), and the points
// in an order that has nothing to do with their places, so that the first few of them stand for
// all.
PointCloud with_fitted_normals(PointCloud points, int neighbours, std::uint32_t seed) {
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0U);
  std::mt19937 random{seed};
  for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random() % i]);
  const std::vector<Eigen::Vector3f> outward = std::move(points.normals);
  const PointIndex index(points.points);
  estimate_neighbour_normals(points, index, neighbours, std::nullopt);
  PointCloud shuffled;
  for (const std::uint32_t i : order) {
    Eigen::Vector3f normal = points.normals[i];
    if (normal.isZero()) continue;
    if (!outward.empty() && normal.dot(outward[i]) < 0) normal = -normal;
    shuffled.points.push_back(points.points[i]);
    shuffled.normals.push_back(normal);
  }
  return shuffled;
}

// Algorithm 1 of chapter 4 once the model's points are there.
void store_pairs(const FeatureCells& cells, PairModel& model, const Watch& watch) {
  struct Stored {
    OrientedPair pair;
    std::uint32_t cell;
  };
  const auto& points = model.points.points;
  const auto& normals = model.points.normals;
  std::vector<std::vector<Stored>> of_chunk(points.size() / kGrain + 1);
  parallel_chunks(points.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    if (watch.cancelled()) return;
    for (std::size_t m1 = begin; m1 < end; ++m1)
      for (std::size_t m2 = 0; m2 < points.size(); ++m2) {
        const double distance = (points[m2] - points[m1]).norm();
        if (!(std::abs(distance - model.distance_m) <= model.tolerance_m)) continue;
        const Eigen::Array3f feature =
            pair_feature(points[m1], normals[m1], points[m2], normals[m2]);
        if (!fixes_a_pose(feature, kNoTurn)) continue;
        of_chunk[begin / kGrain].push_back(
            {{static_cast<std::uint32_t>(m1), static_cast<std::uint32_t>(m2)},
             static_cast<std::uint32_t>(cells.cell_of(feature))});
      }
  });
  model.cell_first.assign(cells.count() + 1, 0);
  for (const auto& chunk : of_chunk)
    for (const Stored& stored : chunk) ++model.cell_first[stored.cell + 1];
  std::partial_sum(model.cell_first.begin(), model.cell_first.end(), model.cell_first.begin());
  std::vector<std::uint32_t> next(model.cell_first.begin(), model.cell_first.end() - 1);
  model.pairs.resize(model.cell_first.back());
  for (const auto& chunk : of_chunk)
    for (const Stored& stored : chunk) model.pairs[next[stored.cell]++] = stored.pair;
}

}  // namespace

std::optional<Error> validate(const PairLibraryOptions& options) {
  const auto refused = [](const char* what) {
    return Error{ErrorCode::kUsage, std::string("model library: ") + what};
  };
  if (!(options.distance_over_diameter > 0 && options.distance_over_diameter < 1))
    return refused("the pairs' distance is a share of the diameter, between 0 and 1");
  if (!(options.cell_rad >= 0.02 && options.cell_rad <= 1.6))
    return refused("a cell of angles is between 0.02 and 1.6 rad wide");
  if (options.model_samples < 100 || options.model_samples > 100000)
    return refused("a model has between 100 and 100000 samples");
  if (!(options.leaf_over_spacing >= 0.1 && options.leaf_over_spacing <= 100))
    return refused("an octree's leaf is between 0.1 and 100 times the samples' spacing");
  if (!(options.tolerance_over_leaf > 0 && options.tolerance_over_leaf <= 10))
    return refused("the tolerance of a pair's distance is over 0 and at most 10 leaves");
  if (options.normal_neighbours < 3 || options.normal_neighbours > 1000)
    return refused("a normal needs between 3 and 1000 neighbours");
  return std::nullopt;
}

const PairModel* PairLibrary::find(std::string_view key) const {
  const auto it = std::find_if(models.begin(), models.end(),
                               [&](const PairModel& model) { return model.key == key; });
  return it == models.end() ? nullptr : &*it;
}

std::string pair_model_key(const DesignModel& design, const PairLibraryOptions& options) {
  Bytes bytes;
  bytes.add_all(design.mesh.vertices);
  bytes.add_all(design.mesh.triangles);
  bytes.add_all(design.cloud.points);
  bytes.add_all(design.cloud.normals);
  bytes.add(options.distance_over_diameter);
  bytes.add(options.cell_rad);
  bytes.add(options.model_samples);
  bytes.add(options.leaf_over_spacing);
  bytes.add(options.tolerance_over_leaf);
  bytes.add(options.normal_neighbours);
  bytes.add(options.seed);
  return sha256_hex(bytes.text());
}

Result<PairModel> build_pair_model(const DesignModel& design, const PairLibraryOptions& options,
                                   const Watch& watch) {
  if (auto error = validate(options)) return *error;
  const auto cancelled = [] {
    return Error{ErrorCode::kInternal, "model library: cancelled; start it again"};
  };
  const SurfaceSamples samples = sample_surface(design, options.model_samples, options.seed, watch);
  if (watch.cancelled()) return cancelled();
  PairModel model;
  model.key = pair_model_key(design, options);
  model.diameter_m = diameter_of(samples.cloud.points, watch);
  if (watch.cancelled()) return cancelled();
  model.leaf_m = options.leaf_over_spacing * spacing_of(samples);
  if (samples.cloud.size() < 50 || !(model.leaf_m > 0) || !(model.diameter_m > 0))
    return Error{ErrorCode::kBadInput,
                 design.path + ": has too little surface to be found by; use a whole design"};
  model.distance_m = options.distance_over_diameter * model.diameter_m;
  model.tolerance_m = options.tolerance_over_leaf * model.leaf_m;
  model.points =
      with_fitted_normals(thin_by_octree(samples.cloud, even_leaves(model.leaf_m), watch),
                          static_cast<int>(options.normal_neighbours), options.seed);
  store_pairs(FeatureCells(options.cell_rad), model, watch);
  if (watch.cancelled()) return cancelled();
  if (model.pairs.empty())
    return Error{ErrorCode::kBadInput,
                 design.path + ": no two of its points lie " + std::to_string(model.distance_m) +
                     " m apart and face a way that fixes a pose; align it by hand"};
  return model;
}

}  // namespace spool
