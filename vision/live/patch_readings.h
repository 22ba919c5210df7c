// What was read of each patch of the design: mean signed deviation and how sure it is.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "vision/core/camera.h"
#include "vision/core/pose.h"
#include "vision/live/surface_patches.h"
#include "vision/live/vision_state.h"
#include "vision/scan/noise_model.h"
#include "vision/scan/reading_noise.h"

namespace spool {

// A patch is known well enough for a number where two standard deviations of its mean are a third
// of what PFI ES-3 allows (3 mm): so much doubt leaves most of the tolerance to the steel (JCGM
// 106:2012, 8).
inline constexpr double kPatchTolerance_m = 0.003;
inline constexpr double kKnownSigma_m = kPatchTolerance_m / 3 / 2;

struct PatchReadingsOptions {
  double memory_s = 3;      // of sight, after which a reading counts for 1/e: as the datum's
  double change_s = 1;      // a patch that reads otherwise for so long is otherwise: no hand passes
  std::size_t most = 8000;  // readings of a frame that are looked at, about
};

// A mean of deviations that a later correction of the design's place can still reach.
struct PatchMean {
  double information = 0;            // 1/m^2; 0: nothing read
  double mean_m = 0;                 // + outside the design
  Vector6d held = Vector6d::Zero();  // mean of (n, p x n): what a small motion adds to the mean

  void add(const PatchMean& other);                    // weighed by information
  void lean_to(const PatchMean& other, double share);  // a running mean
  void follow(const Vector6d& step) { mean_m += held.dot(step); }
  [[nodiscard]] double variance_m2() const { return 1 / information; }
};

// Frames of a placed camera add to the patches that they show. In one frame readings within a
// correlation window of the sensor are worth one, and frames that see a patch by the same pixels
// err alike and together are worth one: a camera that stands still learns no more. What reads
// otherwise beyond chance (a hand before it) is left out until it has stayed for `change_s`. One
// thread.
class PatchReadings {
 public:
  // `seen_by`: the camera of the thinned pictures that the points come from.
  PatchReadings(std::shared_ptr<const SurfacePatches> patches, const Camera& seen_by,
                const NoiseModel& noise, const PatchReadingsOptions& options = {});

  void clear();
  // A state whose deviations are measured. `covariance`: of its pose, at the design origin.
  void add(const VisionState& state, const Matrix6d& covariance);
  // The design's place was corrected: what was at p (m, design frame) is at T_new_old p. Exact to
  // first order.
  void follow(const Pose& T_new_old);

  [[nodiscard]] const SurfacePatches& patches() const { return *patches_; }
  // What is known of a patch, the pose's own doubt apart; information 0: it was not seen.
  [[nodiscard]] PatchMean of(std::size_t patch) const;
  [[nodiscard]] bool is_known(std::size_t patch) const {
    return of(patch).information * kKnownSigma_m * kKnownSigma_m >= 1;
  }
  // Half a second's frames saw it from where it is seen now: more of them tell nothing new.
  [[nodiscard]] bool is_spent(std::size_t patch) const { return kept_[patch].looks > 15; }
  // Of the frame added last: what its motion leaves in doubt of a patch's deviation (m^2), as a
  // pixel is measured at some moment of the exposure.
  [[nodiscard]] double smear_m2(std::size_t patch) const;
  // What one frame tells of a patch seen from there (m, design frame): its mean's variance (m^2).
  [[nodiscard]] double variance_of_a_look(std::size_t patch, const Eigen::Vector3d& eye) const;
  // The mean over what was seen of a part. `covariance`: of the design's place and the camera's, at
  // the design origin.
  [[nodiscard]] PartReading of_part(std::size_t part, const Matrix6d& covariance) const;

 private:
  struct Kept {
    PatchMean before;                                // of other places of the camera
    PatchMean here;                                  // of the present one: worth one look
    int looks = 0;                                   // frames in `here`
    Eigen::Vector3f from = Eigen::Vector3f::Zero();  // m, camera frame: where `here` began
    PatchMean other;                                 // what reads otherwise
    double other_since_s = 0, other_last_s = 0;
    int other_looks = 0;
    double seen_s = 0;  // last
  };
  struct Reading {
    std::uint32_t patch, point;
    float variance_m2;
  };
  void sort_readings(const VisionState& state);
  [[nodiscard]] PatchMean mean_of(std::span<const Reading> readings, const VisionState& state);
  void take_in(std::size_t patch, const PatchMean& look, double doubt_m2,
               const Eigen::Vector3f& p_camera, double now);

  std::shared_ptr<const SurfacePatches> patches_;
  Camera seen_by_;
  ReadingNoise noise_;
  double correlated_;  // readings of one frame that are worth one
  PatchReadingsOptions options_;
  std::vector<std::vector<std::uint32_t>> of_part_;
  std::vector<Kept> kept_;
  std::optional<Pose> T_design_camera_;     // of the frame added last
  double last_s_ = 0;                       // its time
  Pose T_camera_design_, T_before_;         // of it, and of the one before it
  double exposed_ = 0;                      // share of the time between them
  std::vector<Reading> readings_, sorted_;  // scratch
  std::vector<std::uint32_t> first_;        // scratch; where each patch's readings begin
  std::vector<float> distances_;            // scratch
  double worth_ = 1;                        // of the frame now added: readings that are worth one
};

}  // namespace spool
