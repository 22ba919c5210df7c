// The model library: each design's oriented pairs at one distance, hashed by their three angles.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "vision/core/cancel.h"
#include "vision/core/point_cloud.h"
#include "vision/core/result.h"
#include "vision/design/design_model.h"
#include "vision/find/pair_features.h"

namespace spool {

// The first two are the thesis's (Table 4-2), as is the number of samples (its density ratio counts
// scene points over 10 000).
struct PairLibraryOptions {
  double distance_over_diameter = 0.75;             // d over diam(M)
  double cell_rad = 12.0 * std::numbers::pi / 180;  // rad, edge of a cell of angles
  std::uint32_t model_samples = 10000;              // Poisson-disk samples of the design
  double leaf_over_spacing = 10.0;  // longest edge of the octree's leaves over the samples' spacing
  double tolerance_over_leaf = 0.25;  // a pair's distance may be off d by this
  std::uint32_t normal_neighbours = 12;
  std::uint32_t seed = 1;

  bool operator==(const PairLibraryOptions&) const = default;
};

// What makes no sense in `options`, kUsage; nothing where all is well.
[[nodiscard]] std::optional<Error> validate(const PairLibraryOptions& options);

struct OrientedPair {
  std::uint32_t first = 0, second = 0;  // into PairModel::points
};

// One design in the library. Everything in the design's frame, m.
struct PairModel {
  std::string key;         // of the design's content and the options: pair_model_key()
  double diameter_m = 0;   // largest distance between two samples
  double distance_m = 0;   // d
  double tolerance_m = 0;  // of d
  double leaf_m = 0;       // longest edge of the normalising octree's leaves
  PointCloud points;       // of even density, with normals, in an arbitrary order
  std::vector<std::uint32_t> cell_first;  // of each cell in `pairs`, then their number
  std::vector<OrientedPair> pairs;        // sorted by cell

  // The pairs whose angles fall into `cell`.
  [[nodiscard]] std::span<const OrientedPair> in_cell(std::size_t cell) const {
    return std::span(pairs).subspan(cell_first[cell], cell_first[cell + 1] - cell_first[cell]);
  }
};

// Several designs, each searchable by itself: adding one never recalculates another (thesis 4.3.2).
struct PairLibrary {
  PairLibraryOptions options;
  std::vector<PairModel> models;

  [[nodiscard]] const PairModel* find(std::string_view key) const;
};

// SHA-256 of the design's surface as read (so that another unit is another design) and of what the
// pairs are made with.
[[nodiscard]] std::string pair_model_key(const DesignModel& design,
                                         const PairLibraryOptions& options);

// Algorithm 1 of thesis chapter 4: samples the design, evens out their density, fits normals to the
// neighbours (turned outward where the design says where that is) and stores every ordered pair at
// distance d. Same seed, same model. kBadInput where the design has no surface worth the name;
// kUsage as validate(); kInternal where `watch` cancelled it.
[[nodiscard]] Result<PairModel> build_pair_model(const DesignModel& design,
                                                 const PairLibraryOptions& options = {},
                                                 const Watch& watch = {});

}  // namespace spool
