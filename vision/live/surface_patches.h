// The design's outside cut into patches, for each of which readings are kept.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "vision/design/sampling.h"
#include "vision/scan/point_index.h"

namespace spool {

struct SurfacePatch {
  Eigen::Vector3f point = Eigen::Vector3f::Zero();   // m, design frame; on the surface, its middle
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();  // unit, outward; zero where none is known
  std::int32_t part = -1;
  float radius_m = 0;  // no other middle of its part is nearer that looks the same way
  float area_m2 = 0;
};

struct SurfacePatchOptions {
  double pitch_m = 0.025;          // a few of the sensor's correlation windows at 1 m
  std::size_t most = 4000;         // of a large spool they are made larger
  std::size_t fewest_a_part = 16;  // of a small part smaller, as far as there are samples
};

// Immutable; shared by threads. The same patches for the same samples.
class SurfacePatches {
 public:
  [[nodiscard]] static std::shared_ptr<const SurfacePatches> cut(
      const SurfaceSamples& samples, std::size_t parts, const SurfacePatchOptions& options = {});
  SurfacePatches(const SurfacePatches&) = delete;
  SurfacePatches& operator=(const SurfacePatches&) = delete;

  [[nodiscard]] const std::vector<SurfacePatch>& all() const { return patches_; }
  [[nodiscard]] std::size_t parts() const { return parts_; }
  // The patch that a point of the surface (m, design frame) with that outward normal is of: the two
  // sides of a plate are told apart. Nothing further off the samples than they are apart.
  [[nodiscard]] std::optional<std::uint32_t> at(const Eigen::Vector3f& point,
                                                const Eigen::Vector3f& normal) const;

 private:
  SurfacePatches() = default;

  std::vector<SurfacePatch> patches_;
  std::size_t parts_ = 0;
  std::vector<Eigen::Vector3f> lifted_;  // the samples, off the surface along their normals
  std::vector<std::uint32_t> patch_of_;  // of each sample
  PointIndex index_;                     // over lifted_
  float lift_m_ = 0, reach_m_ = 0;
};

}  // namespace spool
