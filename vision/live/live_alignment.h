// Keeps the design where the spool is while the camera is followed through the scene.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "vision/align/icp.h"
#include "vision/core/camera.h"
#include "vision/inspect/bolt_ring.h"
#include "vision/inspect/datum_fit.h"
#include "vision/inspector.h"
#include "vision/live/surface_agreement.h"
#include "vision/live/vision_state.h"
#include "vision/scan/noise_model.h"
#include "vision/scan/reading_noise.h"

namespace spool {

struct LiveAlignmentOptions {
  std::size_t fit_points = 6000;    // of a frame that a fit to the design looks at, at most
  std::size_t check_points = 1500;  // of a frame that is only asked whether the spool was moved
  int check_iterations = 12;
  double near_design_m = 0.10;     // m; points this near the design's box take part in it
  double start_distance_m = 0.05;  // m; a picked pair may be this far off (ARCHITECTURE, Taps)
  // Of the surface that should be seen, the share that must be for a pose to be believed.
  double least_agreement = 0.4;
  // The same for a pose that a fit has just found: more speaks for it than against.
  double least_of_new = 0.5;
  double min_in_sight = 0.25;    // a hand may hide the rest
  std::size_t min_samples = 40;  // fewer surface samples in sight: cannot tell where it is
  int frames_a_check = 3;        // of so many frames one is looked at for a spool that was moved
  int checks_to_notice = 3;      // on end have to show it elsewhere
  int frames_to_search = 10;     // that do not show it: it has to be looked for everywhere
};

// The design fitted to one frame.
struct DesignFit {
  Pose T_design_camera = Pose::Identity();
  bool is_believed = false;
  bool is_held = false;                    // no motion that the frame does not hold
  Matrix6d covariance = Matrix6d::Zero();  // at the design origin, m and rad
  std::string hint;                        // why not
  SurfaceAgreement agreement = {};
  double rms_m = 0;
  double point_noise_m = 0;  // the sensor's standard deviation at the spool's distance
};

// T_design_map: the scene carries the camera's pose (vision/align/tracker) and this the design's
// place in the scene. It follows the datum (vision/inspect/datum_fit) while readings come in. A
// spool that was moved is noticed by fits that suddenly put it elsewhere, where more of it shows,
// and aligned there. One thread at a time.
class LiveAlignment {
 public:
  // `seen_by`: the camera of the thinned pictures that the points come from.
  LiveAlignment(std::shared_ptr<const PreparedDesign> design, const Camera& camera,
                const Camera& seen_by, const NoiseModel& noise,
                const LiveAlignmentOptions& options = {});

  // Refines a guess that may be off by centimetres on one frame's points (camera frame). What is
  // set stays as it is.
  [[nodiscard]] DesignFit fit(const PointCloud& scan, const DepthFrame& frame,
                              const Pose& T_guess) const;

  void set(const Pose& T_design_map);
  // A loop was closed: the design goes with its piece of the map, which moved by `motion` (map
  // frame).
  void follow_map(const Pose& motion) { *T_design_map_ = *T_design_map_ * motion.inverse(); }
  void forget();
  [[nodiscard]] bool is_set() const { return T_design_map_.has_value(); }
  [[nodiscard]] const Pose& T_design_map() const { return *T_design_map_; }
  // Of the datum's place, at the design origin; m and rad.
  [[nodiscard]] Matrix6d covariance() const { return known_.stated_covariance(); }
  // The last readings moved the design at `there` (m, design frame) by so little: a fifth of what
  // is allowed.
  [[nodiscard]] bool is_settled(const Eigen::Vector3d& there, double allowed_m,
                                double allowed_rad) const;

  // Where the spool is for a camera that is known to stand at T_map_camera: kept, or found again
  // close by where it was moved (`was_moved`). Not believed: it is not where it was.
  struct Place {
    DesignFit fit;
    bool was_moved = false;
    bool is_doubtful = false;  // it may just have been moved: the next frames tell
    bool is_gone = false;      // it has to be looked for everywhere
  };
  [[nodiscard]] Place place(const PointCloud& scan, const DepthFrame& frame,
                            const Pose& T_map_camera);

  // Takes in the readings of a placed state, whose deviations are measured.
  void refine(const VisionState& state);
  // A new alignment may be held by a wrong part: a fit to everything follows what is most of the
  // spool. Moves it to where the datum's side has it, by one state's readings, and forgets them.
  // `measure` measures the state's deviations for a new T_design_camera.
  void settle(VisionState& state, const std::function<void(VisionState&)>& measure);

 private:
  [[nodiscard]] DesignFit fitted(const PointCloud& scan, const DepthFrame& frame,
                                 const Pose& T_guess, std::size_t points, int iterations) const;
  [[nodiscard]] SurfaceAgreement agreement(const DepthFrame& frame, const Pose& T_design_camera,
                                           double slack_m) const;
  [[nodiscard]] bool is_in_sight(const SurfaceAgreement& agreement) const;
  [[nodiscard]] double slack_m() const;
  [[nodiscard]] DesignFit check(const PointCloud& scan, const DepthFrame& frame,
                                const Pose& T_map_camera, const DesignFit& here);
  [[nodiscard]] double apart_m(const Pose& a, const Pose& b) const;
  [[nodiscard]] bool is_elsewhere(const DesignFit& there, const DesignFit& here) const;
  [[nodiscard]] double noise_at(const Pose& T_camera_design) const;
  void take_in(const VisionState& state, double passed_s, double wide_m,
               const BoltLook* holes = nullptr);

  std::shared_ptr<const PreparedDesign> design_;
  Camera camera_;
  NoiseModel noise_;
  ReadingNoise reading_noise_;
  double correlated_;  // readings of one frame that are worth one
  LiveAlignmentOptions options_;
  Eigen::AlignedBox3d bounds_;
  DatumFit datum_;
  std::optional<BoltRing> datum_ring_;  // of a datum that is a flange
  std::optional<Pose> T_design_map_;
  DatumEstimate known_;  // of late
  int looks_ = 0;
  Pose T_elsewhere_ = Pose::Identity();  // T_design_map that the last check says
  std::optional<Pose> T_apart_of_late_;  // of such fits from where the design is
  int moved_ = 0;                        // checks on end that show it elsewhere
  int missed_ = 0;                       // frames on end that do not show it
  std::optional<double> seconds_;        // of the readings last taken in
};

}  // namespace spool
