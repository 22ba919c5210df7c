// One frame in, one state out.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/live/frame_processor.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "vision/core/stage_clock.h"
#include "vision/inspect/facing.h"
#include "vision/live/acquisition_box.h"
#include "vision/live/coverage.h"
#include "vision/live/dropout_watch.h"
#include "vision/live/every_nth_pixel.h"
#include "vision/live/map_correction.h"
#include "vision/scan/back_projection.h"
#include "vision/scan/normals.h"

namespace spool {

namespace {

// A pose that only the spool holds is good where so much of what should be seen is, so near.
constexpr double kGoodAgreement = 0.7;
constexpr double kGoodNoises = 3;  // the residuals' RMS over the sensor's noise

// Turns a small motion, or its covariance, into other axes.
Matrix6d turned(const Eigen::Matrix3d& rotation) {
  Matrix6d both = Matrix6d::Zero();
  both.topLeftCorner<3, 3>() = both.bottomRightCorner<3, 3>() = rotation;
  return both;
}

// `covariance`: of the camera in the design's axes.
void state_uncertainty(const Matrix6d& covariance, VisionState& state) {
  state.pose_u_m = 2 * largest_sigma(covariance.topLeftCorner<3, 3>());
  state.pose_u_rad = 2 * largest_sigma(covariance.bottomRightCorner<3, 3>());
}

}  // namespace

std::string_view name(TrackQuality quality) {
  switch (quality) {
    case TrackQuality::kGood:
      return "good";
    case TrackQuality::kPoor:
    case TrackQuality::kPaused:
      return "poor";
    case TrackQuality::kUnaligned:
    case TrackQuality::kLost:
      break;
  }
  return "lost";
}

struct FrameProcessor::Impl {
  std::shared_ptr<const PreparedDesign> design;
  Camera camera;
  Camera small;  // of the thinned pictures
  NoiseModel noise;
  FrameProcessorOptions options;
  Eigen::AlignedBox3d datum;   // design frame
  Eigen::AlignedBox3f region;  // design frame; no point outside is near enough to be measured
  Tracker tracker;
  LiveAlignment alignment;
  Coverage coverage;
  DropoutWatch dropout;
  std::uint64_t revision = 0;
  std::uint64_t alignments = 0;
  std::uint64_t map = 0;                // how often the map was begun anew
  double last_u_m = 0, last_u_rad = 0;  // VisionState::pose_u of the last placed frame
  bool scene_holds = false;             // every motion of the camera, in the frame now processed
  std::string alignment_hint;           // why the last alignment was not believed
  Pose T_last = Pose::Identity();       // T_design_camera of the last believed frame

  Impl(std::shared_ptr<const PreparedDesign> of, const Camera& by, const NoiseModel& with,
       const FrameProcessorOptions& so)
      : design(std::move(of)),
        camera(by),
        small(every_nth_pixel(by, so.stride_px)),
        noise(with),
        options(so),
        datum(datum_box(design->model)),
        region(box_about(design->model, so.max_deviation_m)),
        tracker(so.tracker),
        alignment(design, by, small, with, so.alignment),
        coverage(design, by, small, with) {}

  [[nodiscard]] Result<PointCloud> organised(const DepthFrame& frame) const;
  void wait(VisionState& state) const;
  void see_nothing(VisionState& state) const;
  void follow_camera(const PointCloud& cloud, VisionState& state);
  void follow_map(const TrackedPose& tracked, VisionState& state);
  void place_design(const PointCloud& cloud, VisionState& state, StageClock& clock);
  void show(const DesignFit& fit, VisionState& state);
  void hold_by_spool(const PointCloud& cloud, VisionState& state, StageClock& clock);
  void grade(VisionState& state) const;
  void measure(VisionState& state) const;
  [[nodiscard]] Matrix6d pose_covariance(const VisionState& state) const;
  void take_readings(const VisionState& state);
  void settle(VisionState& state);
};

FrameProcessor::FrameProcessor(std::shared_ptr<const PreparedDesign> design, const Camera& camera,
                               const NoiseModel& noise, const FrameProcessorOptions& options)
    : impl_(std::make_unique<Impl>(std::move(design), camera, noise, options)) {}

FrameProcessor::~FrameProcessor() = default;
FrameProcessor::FrameProcessor(FrameProcessor&&) noexcept = default;
FrameProcessor& FrameProcessor::operator=(FrameProcessor&&) noexcept = default;

Result<PointCloud> FrameProcessor::Impl::organised(const DepthFrame& frame) const {
  Result<PointCloud> cloud = back_project(every_nth_pixel(frame, options.stride_px), small);
  if (cloud) estimate_organised_normals(*cloud, small, noise);
  return cloud;
}

// Of a picture that went out: scene, map and design are left alone until it is back.
void FrameProcessor::Impl::wait(VisionState& state) const {
  state.is_out = true;
  state.T_design_camera = T_last;
  if (alignment.is_set()) state.quality = TrackQuality::kPaused;
  state.hint = "Paused: the picture went out, hold still for a moment.";
}

// A fit to one value, which is a plane, would put some face of the design on it.
void FrameProcessor::Impl::see_nothing(VisionState& state) const {
  state.T_design_camera = T_last;
  if (alignment.is_set()) state.quality = TrackQuality::kLost;
  state.hint = "Nothing is seen: uncover the lens, or step back.";
}

// Where the camera stands in the scene, and how sure that is.
void FrameProcessor::Impl::follow_camera(const PointCloud& cloud, VisionState& state) {
  const bool had_map = !tracker.map().empty();
  const TrackedPose tracked = tracker.track({cloud, small, noise, state.frame->seconds});
  state.camera = tracked.quality;
  state.T_map_camera = tracked.T_map_camera;
  state.map = map;
  state.hint = tracked.reason;
  state.camera_covariance = tracked.covariance;
  state.map_cells = tracker.map().size();
  for (const auto& [stage, seconds] : tracked.timing_s) state.timing_s["follow/" + stage] = seconds;
  scene_holds = tracked.quality != PoseQuality::kLost && tracked.weak_directions.empty();
  follow_map(tracked, state);
  if (had_map || tracker.map().empty() || !alignment.is_set()) return;
  // The scene was too plain until now, and the spool alone was followed.
  const DesignFit fit = alignment.fit(state.scan, *state.frame, T_last);
  if (fit.is_believed) alignment.set(fit.T_design_camera * state.T_map_camera.inverse());
}

// A loop was closed: the design goes with the piece of the map that its datum lies in, and the
// camera with the one that it looks at.
void FrameProcessor::Impl::follow_map(const TrackedPose& tracked, VisionState& state) {
  if (tracked.map_motions.empty() || !alignment.is_set()) return;
  const Pose& of_camera = tracked.T_current_moved;
  const Pose of_design = motion_of_piece(tracker.map(), tracked.map_motions,
                                         alignment.T_design_map(), datum, of_camera);
  const Pose T_camera_before = of_camera.inverse() * tracked.T_map_camera;
  const Pose T_before = alignment.T_design_map() * T_camera_before;
  alignment.follow_map(of_design);
  const PoseSize moved =
      pose_size(T_before.inverse() * alignment.T_design_map() * tracked.T_map_camera);
  state.loop_moved_m = moved.translation_m;
  state.loop_moved_rad = moved.rotation_rad;
}

void FrameProcessor::Impl::show(const DesignFit& fit, VisionState& state) {
  state.T_design_camera = fit.T_design_camera;
  state.rms_m = fit.rms_m;
  state.agreement = fit.agreement.share();
  state.point_noise_m = fit.point_noise_m;
  T_last = fit.T_design_camera;
}

// The place's covariance and the camera's, at the design origin.
Matrix6d FrameProcessor::Impl::pose_covariance(const VisionState& state) const {
  const Matrix6d from_eye = motion_told_at(-state.T_design_camera.translation()) *
                            turned(alignment.T_design_map().linear());
  return alignment.covariance() + from_eye * state.camera_covariance * from_eye.transpose();
}

// The readings of a state correct the design's place, and those before them with it.
void FrameProcessor::Impl::take_readings(const VisionState& state) {
  coverage.add(state, pose_covariance(state));
  const Pose T_before = alignment.T_design_map();
  alignment.refine(state);
  coverage.follow(alignment.T_design_map() * T_before.inverse());
}

// Of an alignment that is new: the datum's side decides, and the state is measured there.
void FrameProcessor::Impl::settle(VisionState& state) {
  alignment.settle(state, [this](VisionState& there) { measure(there); });
  T_last = state.T_design_camera;
  measure(state);
}

// What the pose may be off by at the camera: the camera's place in the scene, and the design's.
void FrameProcessor::Impl::grade(VisionState& state) const {
  const Eigen::Vector3d& eye = state.T_design_camera.translation();
  const Matrix6d at_eye = motion_told_at(eye);
  const Matrix6d to_design = turned(alignment.T_design_map().linear());
  state_uncertainty(at_eye * alignment.covariance() * at_eye.transpose() +
                        to_design * state.camera_covariance * to_design.transpose(),
                    state);
  const double good_m = options.tracker.good_m, good_rad = options.tracker.good_rad;
  const bool is_sharp = state.pose_u_m <= good_m && state.pose_u_rad <= good_rad;
  const bool is_settled = alignment.is_settled(eye, good_m, good_rad);
  const bool is_good = state.camera == PoseQuality::kGood && is_sharp && is_settled;
  state.quality = is_good ? TrackQuality::kGood : TrackQuality::kPoor;
  if (is_good) {
    state.hint.clear();
  } else if (state.hint.empty()) {
    state.hint = is_sharp ? "Unsure: go on looking for a moment, the drawing settles on the steel."
                          : "Unsure: look where a flange or an elbow is seen too.";
  }
}

void FrameProcessor::Impl::place_design(const PointCloud& cloud, VisionState& state,
                                        StageClock& clock) {
  state.T_design_camera = T_last;
  state.quality = TrackQuality::kLost;
  if (!scene_holds) {
    hold_by_spool(cloud, state, clock);
    return;
  }
  const LiveAlignment::Place place = alignment.place(state.scan, *state.frame, state.T_map_camera);
  clock.mark("place");
  state.was_moved = place.was_moved;
  state.is_gone = place.is_gone;
  if (!place.fit.is_believed) {
    state.hint = place.fit.hint;
    return;
  }
  show(place.fit, state);
  if (place.was_moved) {
    coverage.clear();
    settle(state);
  } else {
    measure(state);
  }
  clock.mark("deviation");
  if (state.camera == PoseQuality::kGood && !place.is_doubtful) take_readings(state);
  grade(state);
  if (place.is_doubtful) {
    state.quality = TrackQuality::kPoor;
    state.hint = "Unsure: the spool may have been moved.";
  }
  if (state.loop_moved_m > last_u_m || state.loop_moved_rad > last_u_rad) {
    // More than was said beforehand.
    state.quality = TrackQuality::kPoor;
    state.hint = "Corrected: coming back here showed that the way had drifted.";
  }
  last_u_m = state.pose_u_m;
  last_u_rad = state.pose_u_rad;
  clock.mark("refine");
  coverage.tell(state, pose_covariance(state));
  clock.mark("coverage");
}

// Where the scene does not hold the camera, on a bare floor, the spool may. A camera that was lost
// is never good by that: another place may look alike. Where the scene is too plain for a map there
// is nothing but the spool to follow.
void FrameProcessor::Impl::hold_by_spool(const PointCloud& cloud, VisionState& state,
                                         StageClock& clock) {
  const bool is_lost = state.camera == PoseQuality::kLost;
  const bool has_map = !tracker.map().empty();
  const Pose guess = is_lost ? T_last : alignment.T_design_map() * state.T_map_camera;
  const DesignFit fit = alignment.fit(state.scan, *state.frame, guess);
  clock.mark("place");
  if (!fit.is_believed) return;
  const Matrix6d at_eye = motion_told_at(fit.T_design_camera.translation());
  const Matrix6d covariance = at_eye * fit.covariance * at_eye.transpose();
  if (fit.is_held && has_map) {
    const Pose T_map_design = alignment.T_design_map().inverse();
    const Matrix6d to_map = turned(T_map_design.linear());
    state.T_map_camera = T_map_design * fit.T_design_camera;
    state.camera_covariance = to_map * covariance * to_map.transpose();
    tracker.tell({cloud, small, noise, state.frame->seconds}, state.T_map_camera,
                 state.camera_covariance);
  }
  show(fit, state);
  measure(state);
  clock.mark("deviation");
  if (fit.is_held && !(is_lost && has_map)) coverage.add(state, fit.covariance);
  coverage.tell(state, fit.covariance);
  clock.mark("coverage");
  state_uncertainty(covariance, state);
  const bool is_good = !(is_lost && has_map) && fit.is_held && state.agreement >= kGoodAgreement &&
                       fit.rms_m <= kGoodNoises * fit.point_noise_m;
  state.quality = is_good ? TrackQuality::kGood : TrackQuality::kPoor;
  if (is_good) state.hint.clear();
}

void FrameProcessor::Impl::measure(VisionState& state) const {
  state.scan_design = moved(state.scan, state.T_design_camera);
  state.classes.resize(state.scan_design.size());
  for (std::size_t i = 0; i < state.classes.size(); ++i)
    state.classes[i] =
        region.contains(state.scan_design.points[i]) ? PointClass::kObject : PointClass::kClutter;
  state.deviations = measure_deviations(state.scan_design, state.classes, *design->surface,
                                        static_cast<float>(options.max_deviation_m));
  // What a single point may be off by at random is not looked at.
  drop_turned_away(state.scan_design, state.T_design_camera.translation(), *design->surface,
                   static_cast<float>(kFacingSigmas * state.point_noise_m), state.classes,
                   state.deviations);
  state.rms_m = rms(state.deviations, state.classes);
}

Result<VisionStatePtr> FrameProcessor::process(std::shared_ptr<const DepthFrame> frame) {
  Impl& self = *impl_;
  if (!frame->is_consistent() || frame->width != self.camera.width ||
      frame->height != self.camera.height) {
    return Error{ErrorCode::kBadInput,
                 "frame " + std::to_string(frame->index) + " is " + std::to_string(frame->width) +
                     "x" + std::to_string(frame->height) + " and the camera " +
                     std::to_string(self.camera.width) + "x" + std::to_string(self.camera.height) +
                     "; check camera.json or the recording"};
  }
  auto state = std::make_shared<VisionState>();
  state->revision = ++self.revision;
  state->alignment = self.alignments;
  state->frame = std::move(frame);
  state->stride_px = self.options.stride_px;
  if (self.dropout.is_out(*state->frame)) {
    self.wait(*state);
    return VisionStatePtr(std::move(state));
  }
  if (is_blank(*state->frame)) {
    self.see_nothing(*state);
    return VisionStatePtr(std::move(state));
  }
  StageClock clock(state->timing_s);
  const Result<PointCloud> cloud = self.organised(*state->frame);
  if (!cloud) return cloud.error();
  state->scan = measured_points(*cloud);
  clock.mark("thin");
  self.follow_camera(*cloud, *state);
  clock.mark("follow");
  if (self.alignment.is_set())
    self.place_design(*cloud, *state, clock);
  else
    state->hint = self.alignment_hint;
  return VisionStatePtr(std::move(state));
}

VisionStatePtr FrameProcessor::align(const VisionState& held, const Pose& T_design_camera) {
  Impl& self = *impl_;
  auto state = std::make_shared<VisionState>();
  state->revision = ++self.revision;
  state->alignment = ++self.alignments;
  state->frame = held.frame;
  state->scan = held.scan;
  state->stride_px = held.stride_px;
  state->camera = held.camera;
  state->T_map_camera = held.T_map_camera;
  state->camera_covariance = held.camera_covariance;
  state->map = held.map;
  state->map_cells = held.map_cells;
  self.alignment.forget();
  self.alignment_hint.clear();
  StageClock clock(state->timing_s);
  const DesignFit fit = self.alignment.fit(state->scan, *state->frame, T_design_camera);
  clock.mark("fit");
  self.show(fit, *state);
  if (!fit.is_believed) {
    self.alignment_hint = "The picks do not fit what is seen: undo one and pick it again.";
    state->hint = self.alignment_hint;
    return state;
  }
  if (state->camera == PoseQuality::kLost || state->map != self.map) {
    // Nobody knows where in the scene that was: the scene begins anew, with it.
    self.tracker.clear();
    ++self.map;
    if (const Result<PointCloud> cloud = self.organised(*state->frame))
      self.follow_camera(*cloud, *state);
    state->hint.clear();
  }
  self.alignment.set(state->T_design_camera * state->T_map_camera.inverse());
  self.coverage.clear();
  self.settle(*state);
  self.take_readings(*state);
  self.grade(*state);
  self.coverage.tell(*state, self.pose_covariance(*state));
  clock.mark("deviation");
  return state;
}

void FrameProcessor::forget() {
  impl_->alignment.forget();
  impl_->alignment_hint.clear();
}

}  // namespace spool
