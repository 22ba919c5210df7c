// Where the datum is, from the readings on all parts: each counts as far as its joints hold it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "vision/align/weak_directions.h"
#include "vision/core/cloud_view.h"
#include "vision/design/design_model.h"
#include "vision/inspect/bolt_phase.h"
#include "vision/inspect/deviation.h"
#include "vision/inspect/joint_tree.h"

namespace spool {

struct DatumFitOptions {
  // Standard deviations of a joint as built: half of what PFI ES-3 allows (3 mm; 3/64 in a foot).
  double joint_m = 0.0015;
  double joint_rad = 0.002;
  // What was known before any reading, of the datum at the design's middle: where clear() was
  // called.
  double prior_m = 0.02;
  double prior_rad = 0.05;
  // Standard deviation of what a part's readings of one look err by together, along the surface's
  // normal: incidence, correlation windows, disparity steps. Frames within `look_s` of each other
  // are one look. These and the drift were chosen by spoolsight-live-campaign, seeds 1 and 2 of the
  // small spool, and not derived: on other seeds and sensors they are untried.
  double bias_m = 0.0001;
  double look_s = 0.3;
  // What the map may drift by in a second, m / sqrt(s): what is known of a part fades as fast as
  // that makes it untrue. Chosen as the two above.
  double drift_m = 0.0001;
  std::size_t most_points = 6000;  // of a frame that are looked at, about
};

// The readings of one frame, one entry a point.
struct DatumReadings {
  CloudView scan_design;               // m; with the scan's normals
  const Deviations& deviations;        // there
  std::span<const float> variance_m2;  // along the surface's normal
  double correlated = 1;               // how many readings are worth one
  double passed_s = 0;                 // since the readings before
  double wide_m = 0;                   // what the pose may be off by besides, of a new alignment
  // The datum's bolt holes: nothing else tells how it is turned where its pipe is as round as it.
  const BoltLook* holes = nullptr;
};

struct DatumEstimate {
  // The small motion about the design origin (m, rad) that the scan has to make so that the datum
  // lies where the design has it.
  Vector6d step = Vector6d::Zero();
  Matrix6d covariance = Matrix6d::Zero();
  // The same were every joint of the parts that count exactly as designed: how well the design's
  // place is known, in place of the datum's.
  Matrix6d covariance_as_designed = Matrix6d::Zero();
  // 0 to 1: how much of what is known of the datum's place came through its joints; 0: its own
  // readings tell.
  double through_joints = 1;
  // One a part: it is where the datum and its joints let it be.
  std::vector<std::uint8_t> counts;

  // What is stated of a pose: joints that look as drawn are, but of a datum that was not seen
  // itself nobody knows.
  [[nodiscard]] Matrix6d stated_covariance() const {
    return covariance_as_designed + through_joints * (covariance - covariance_as_designed);
  }
};

// Belief propagation (Pearl 1988) on the tree of joints: each part's own readings hold it (point to
// plane), and each joint lets the next part be off by the trade's tolerance. Where what hangs on a
// joint contradicts the side of the datum (chi-squared, 1 %), it was turned about the joint's axis
// or cut to another length, and says nothing of those two motions; where it contradicts even so, it
// says nothing at all. So a wrong part cannot pull the pose by which it is judged. Of several
// datums it is the first. Without datums or joints the design is one rigid body. Use from one
// thread at a time.
class DatumFit {
 public:
  explicit DatumFit(const DesignModel& design, const DatumFitOptions& options = {});

  void clear();  // what was read is forgotten
  void add(const DatumReadings& readings);
  [[nodiscard]] DatumEstimate solve() const;
  // The scan made this small motion in the design frame; what was read goes with it.
  void follow(const Vector6d& step);

 private:
  void fade(double variance_m2);
  [[nodiscard]] MotionKnowledge turn_of_datum() const;
  enum class Hold { kAsDrawn, kButAxis, kNone };
  [[nodiscard]] MotionKnowledge through(const JointBranch& joint, Hold hold,
                                        const MotionKnowledge& beyond) const;
  [[nodiscard]] double contradiction(const MotionKnowledge& a, const MotionKnowledge& b) const;

  DatumFitOptions options_;
  std::vector<JointBranch> tree_;  // empty: one rigid body
  int root_ = 0;
  std::vector<float> allowance2_;  // m^2; of a part's place as built, one a part
  MotionKnowledge prior_;
  std::vector<MotionKnowledge> own_;                      // one a part, at the design origin
  std::optional<BoltPhase> holes_;                        // of a datum that has some…
  Eigen::Vector3d hole_axis_ = Eigen::Vector3d::UnitZ();  // …about this, design frame
  std::vector<std::vector<Correspondence>> matches_;      // scratch, one a part
};

}  // namespace spool
