// The three-point alignment as the fitter does it: a lit design point, a tap on the steel, undo.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "vision/align/three_point.h"
#include "vision/design/landmarks.h"

namespace spool {

// Holds picks only; the scan they are made on is the caller's. Design points are in the design
// frame without its origin, scan points in the camera frame of the held picture (m).
class AlignSession {
 public:
  explicit AlignSession(std::vector<Landmark> proposed) : proposed_(std::move(proposed)) {}

  // The design point that the next tap on the scan is paired with: the one tapped, else the next
  // proposed.
  [[nodiscard]] std::optional<Landmark> lit() const;
  void choose_design_point(Landmark point) { chosen_ = std::move(point); }
  // False where no design point is lit.
  bool pick_scan_point(const Eigen::Vector3d& p_camera);
  void undo();  // the chosen design point first, then the last pair
  void clear();

  [[nodiscard]] const std::vector<PointPair>& pairs() const { return pairs_; }
  [[nodiscard]] bool can_undo() const { return chosen_.has_value() || !pairs_.empty(); }
  // Of three pairs or more; kTooFew before.
  [[nodiscard]] const PairsAlignment& result() const { return result_; }

 private:
  std::vector<Landmark> proposed_;
  std::optional<Landmark> chosen_;
  std::vector<PointPair> pairs_;
  PairsAlignment result_;
};

}  // namespace spool
