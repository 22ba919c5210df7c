// The three-point alignment as the fitter does it: a lit design point, a tap on the steel, undo.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "vision/align/three_point.h"
#include "vision/design/landmarks.h"

namespace spool {

// Holds picks only; the scan they are made on is the caller's. Design points are in the design
// frame without its origin, scan points in the camera frame of the held picture (m).
class AlignSession {
 public:
  // For each proposed landmark 0 to 1: how likely the picture measured it, given the pairs so far.
  // Empty: nothing is known.
  using Evidence = std::function<std::vector<double>(std::span<const PointPair>)>;

  // `evidence` is first asked after the first pick or clear().
  explicit AlignSession(std::vector<Landmark> proposed, Evidence evidence = {});

  // The design point that the next tap on the scan is paired with: the one tapped, else the one
  // proposed. What is proposed changes with a pick, an undo, a skip or a new alignment only.
  [[nodiscard]] std::optional<Landmark> lit() const;
  void choose_design_point(Landmark point);
  // Another point in the place of the lit one, which is not proposed again in this alignment.
  void skip();
  [[nodiscard]] bool can_skip() const;
  [[nodiscard]] std::optional<Landmark> lit_after_skip() const;
  // False where no design point is lit.
  bool pick_scan_point(const Eigen::Vector3d& p_camera);
  // The tap met a place without depth: so until anything else happens.
  void refuse_scan_point() { refused_ = true; }
  [[nodiscard]] bool is_refused() const { return refused_; }
  void undo();   // the chosen design point first, then the last pair
  void clear();  // for a new alignment

  [[nodiscard]] const std::vector<PointPair>& pairs() const { return pairs_; }
  [[nodiscard]] bool can_undo() const { return chosen_.has_value() || !pairs_.empty(); }
  // Of three pairs or more; kTooFew before.
  [[nodiscard]] const PairsAlignment& result() const { return result_; }

 private:
  void propose();
  void propose(const std::vector<double>& likelihood);
  [[nodiscard]] double worth(const Landmark& landmark) const;
  [[nodiscard]] std::optional<std::size_t> best_of(const std::vector<std::size_t>& open) const;

  std::vector<Landmark> proposed_;
  Evidence evidence_;
  std::vector<bool> skipped_;        // of each proposed
  std::optional<std::size_t> next_;  // of `proposed_`
  std::optional<std::size_t> after_next_;
  std::optional<Landmark> chosen_;
  bool refused_ = false;
  std::vector<PointPair> pairs_;
  PairsAlignment result_;
};

}  // namespace spool
