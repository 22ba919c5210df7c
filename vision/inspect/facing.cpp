// Readings that cannot be of the face they are compared with.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/inspect/facing.h"

#include <cassert>
#include <cmath>
#include <limits>

#include "vision/core/parallel.h"

namespace spool {

namespace {
constexpr std::size_t kGrain = 4096;
constexpr auto kGrazing = static_cast<float>(kFacingCosine);
}  // namespace

std::size_t drop_turned_away(const CloudView& scan_design, const Eigen::Vector3d& eye,
                             const DesignSurface& surface, float beyond_m,
                             std::span<PointClass> classes, Deviations& deviations) {
  assert(classes.size() == scan_design.size() && deviations.part.size() == scan_design.size() &&
         deviations.distance_m.size() == scan_design.size() && "one entry a point");
  return parallel_sum(scan_design.size(), kGrain, std::size_t{0},
                      [&](std::size_t begin, std::size_t end) {
                        std::size_t dropped = 0;
                        for (std::size_t i = begin; i < end; ++i) {
                          const float distance = deviations.distance_m[i];
                          if (!(std::abs(distance) > beyond_m)) continue;  // NaN too
                          const Eigen::Vector3f& point = scan_design.points[i];
                          const auto nearest = surface.closest(point, 1.01F * std::abs(distance));
                          if (!nearest) continue;
                          const Eigen::Vector3f to_eye = eye.cast<float>() - nearest->point;
                          if (nearest->normal.dot(to_eye) >= kGrazing * to_eye.norm()) continue;
                          classes[i] = PointClass::kClutter;
                          deviations.distance_m[i] = std::numeric_limits<float>::quiet_NaN();
                          deviations.part[i] = -1;
                          ++dropped;
                        }
                        return dropped;
                      });
}

}  // namespace spool
