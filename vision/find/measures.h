// The thesis's figures of merit: what was found, how closely, and what was kept and lost.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "vision/core/cancel.h"
#include "vision/core/cloud_view.h"
#include "vision/core/pose.h"
#include "vision/design/design_surface.h"

namespace spool {

// All ratios are NaN where what they divide by is zero, and without a unit.

// Points of one scene, counted against the truth.
struct KeptCounts {
  std::size_t object = 0;     // m: of the object in the scene, ||s||
  std::size_t kept = 0;       // N or q: kept, rightly or not
  std::size_t true_kept = 0;  // n, TP: of the object among those kept
};

// `is_object` and `is_kept`: one flag a scan point.
[[nodiscard]] KeptCounts count_kept(std::span<const std::uint8_t> is_object,
                                    std::span<const std::uint8_t> is_kept);

// RR = TP / ||s||, eq. 4.2.
[[nodiscard]] double recognition_rate(const KeptCounts& counts);
// VR = (m - n) / m and NR = (N - n) / m: eqs 5.1 and 5.2 as Table 5-1 was computed, over the
// object's points; by its own text the thesis divides by the points kept (THESIS.md, A2).
[[nodiscard]] double void_rate(const KeptCounts& counts);
[[nodiscard]] double noise_rate(const KeptCounts& counts);
// The same as eqs 5.1 and 5.2 and Algorithm 2 of chapter 5 print them: over the points kept.
[[nodiscard]] double void_rate_as_printed(const KeptCounts& counts);
[[nodiscard]] double noise_rate_as_printed(const KeptCounts& counts);
// n / N, n / m and their harmonic mean.
[[nodiscard]] double precision(const KeptCounts& counts);
[[nodiscard]] double recall(const KeptCounts& counts);
[[nodiscard]] double f1(const KeptCounts& counts);

// Scene points over model points (4.4.2.1).
[[nodiscard]] double density_ratio(std::size_t scene_points, std::size_t model_points);
// ||S - (S n s)|| / ||s||, eq. 4.3: clutter over object points.
[[nodiscard]] double clutter_ratio(std::size_t scene_points, std::size_t object_points);
// The object's points left over those of the whole object (4.4.2.3). The thesis divided scene by
// scene (THESIS.md, A17).
[[nodiscard]] double completeness_ratio(std::size_t object_points, std::size_t whole_points);

// SR, figure 4-14: 1 where the pose is right, else 0. Right: every corner of `box` (m, design
// frame) within `limit_m` of where the true pose puts it.
[[nodiscard]] int success(const Pose& T_design_scan, const Pose& true_T_design_scan,
                          const Eigen::AlignedBox3d& box, double limit_m);
// ER, 4.4.3: successes with the given parameters over all successes, with whatever parameters.
[[nodiscard]] double effectiveness_ratio(std::size_t with_given_parameters, std::size_t with_any);

// Root mean square of distances (m), and of how many.
struct RmsDistance {
  double rms_m = 0;
  std::size_t points = 0;
};

// RMS as the thesis has it (4.4.1): of the distances from every model point to its nearest point of
// the isolated scan. It is mostly the points' spacing and what was not seen (THESIS.md, A19). Both
// clouds in the design frame; points that are not finite are left out. No points: 0.
[[nodiscard]] RmsDistance rms_point_to_point(const CloudView& model, const CloudView& isolated,
                                             const Watch& watch = {});
// RMS of the distances from every isolated scan point (m, scan frame) to the design's surface,
// which spacing leaves alone. Points further than `max_distance_m` are left out.
[[nodiscard]] RmsDistance rms_point_to_surface(const CloudView& isolated,
                                               const DesignSurface& surface,
                                               const Pose& T_design_scan, double max_distance_m,
                                               const Watch& watch = {});

}  // namespace spool
