// From where to look next: where a look would tell most that is not known yet.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "vision/design/design_surface.h"
#include "vision/live/patch_readings.h"

namespace spool {

// A place of the design and the side from which to look at it.
struct NextLook {
  Eigen::Vector3f target = Eigen::Vector3f::Zero();     // m, design frame
  Eigen::Vector3f direction = Eigen::Vector3f::Zero();  // unit, from there to the eye
  int part = -1;                                        // of which most would be told
  double gain = 0;  // nats: half of what the log determinants grow by
};

// The design is cut into places as large as a picture shows, and each is looked at from 26 sides in
// thought: of patches that face that side, that the design does not hide and that are not known
// yet, what would be told of the motions of the parts that they are of (D-optimality). One thread.
class NextView {
 public:
  NextView(std::shared_ptr<const SurfacePatches> patches, const DesignSurface& surface);

  // Weighs one place anew, the next of all: a frame's share of the work.
  void update(const PatchReadings& readings);
  // The best look of those that the fitter can take; the one that was said last while half as good.
  // `eye` and `down`: the camera's place (m, design frame) and which way is down in its picture.
  // None where no look makes any part's ellipsoid of uncertainty smaller by a tenth along each
  // axis.
  [[nodiscard]] std::optional<NextLook> best(const Eigen::Vector3d& eye,
                                             const Eigen::Vector3d& sight,
                                             const Eigen::Vector3d& down);
  void clear();

  static constexpr std::size_t kSides = 26;
  // Whether a patch faces that side with nothing of the design before it.
  [[nodiscard]] bool is_visible(std::size_t patch, std::size_t side) const {
    return (visible_[patch] >> side & 1U) != 0;
  }
  [[nodiscard]] const Eigen::Vector3f& side(std::size_t i) const { return sides_[i]; }

 private:
  struct Place {
    std::vector<std::uint32_t> patches;
    std::array<NextLook, kSides> looks;
  };
  void weigh(Place& place, const PatchReadings& readings) const;

  std::shared_ptr<const SurfacePatches> patches_;
  std::array<Eigen::Vector3f, kSides> sides_;
  std::vector<std::uint32_t> visible_;   // one bit a side
  std::vector<Eigen::Vector3d> middle_;  // m; of each part's patches
  std::vector<std::vector<std::uint32_t>> of_part_;
  std::vector<Place> places_;
  std::size_t next_ = 0;
  bool is_whole_ = false;                                    // every place was weighed
  std::optional<std::pair<std::size_t, std::size_t>> said_;  // place and side
};

}  // namespace spool
