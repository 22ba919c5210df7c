// A pose from picked pairs: rigid, no scale, refused with its reason where they do not make one.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "vision/core/pose.h"
#include "vision/core/result.h"

namespace spool {

// A point picked on the design and the same point picked on the scan; m, each in its own frame.
struct PointPair {
  Eigen::Vector3d design = Eigen::Vector3d::Zero();
  Eigen::Vector3d scan = Eigen::Vector3d::Zero();
};

enum class PairsStatus { kOk, kTooFew, kCoincident, kCollinear, kMirrored, kInconsistent };

struct PairsAlignment {
  PairsStatus status = PairsStatus::kTooFew;
  std::string reason;  // one sentence for the fitter where status is not kOk
  Pose T_design_scan = Pose::Identity();
  double rms_m = 0;
  std::vector<double> residual_m;  // of each pair
};

struct PairsOptions {
  double max_residual_m = 0.05;    // m; a tap is off by 5-20 mm (ARCHITECTURE, Taps)
  double min_separation_m = 0.02;  // m between any two picks
  double min_spread_ratio = 0.05;  // smaller over larger spread of the triple; below: collinear
};

// What makes no sense in `options`, kUsage; nothing where all is well.
[[nodiscard]] std::optional<Error> validate(const PairsOptions& options);

// Least-squares rigid pose of three or more pairs (Horn 1987; Umeyama 1991 without scale, proper
// rotations only). Mirrored: a reflection (or exchanged picks) would fit far better.
[[nodiscard]] PairsAlignment align_pairs(std::span<const PointPair> pairs,
                                         const PairsOptions& options = {});

// How far (m) the pose may put a point at `design_point` off when each pick is off by `pick_error`
// (m, standard deviation in each coordinate): the picks' lever arms. Pairs as align_pairs()
// accepted them.
[[nodiscard]] double predicted_error(std::span<const PointPair> pairs, double pick_error,
                                     const Eigen::Vector3d& design_point);

}  // namespace spool
