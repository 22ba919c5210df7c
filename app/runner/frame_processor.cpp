// One frame in, one state out.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/runner/frame_processor.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "app/runner/surface_agreement.h"
#include "vision/core/stage_clock.h"
#include "vision/inspect/facing.h"
#include "vision/scan/back_projection.h"
#include "vision/scan/normals.h"

namespace spool {

namespace {

// Every `stride`-th pixel of a frame, and the camera that sees it so.
DepthFrame every_nth_pixel(const DepthFrame& frame, int stride) {
  DepthFrame small;
  small.index = frame.index;
  small.seconds = frame.seconds;
  small.width = (frame.width + stride - 1) / stride;
  small.height = (frame.height + stride - 1) / stride;
  small.depth.reserve(static_cast<std::size_t>(small.width) *
                      static_cast<std::size_t>(small.height));
  for (int v = 0; v < frame.height; v += stride) {
    const auto row = static_cast<std::size_t>(v) * static_cast<std::size_t>(frame.width);
    for (int u = 0; u < frame.width; u += stride) {
      small.depth.push_back(frame.depth[row + static_cast<std::size_t>(u)]);
    }
  }
  return small;
}

Camera every_nth_pixel(const Camera& camera, int stride) {
  Camera small = camera;
  small.width = (camera.width + stride - 1) / stride;
  small.height = (camera.height + stride - 1) / stride;
  small.fx /= stride;  // pixel centres at integers: pixel u of the small image is pixel u * stride
  small.fy /= stride;
  small.cx /= stride;
  small.cy /= stride;
  return small;
}

// At most `limit` of the points that `wanted` takes, spread evenly over the order they stand in.
template <class Wanted>
PointCloud some_of(const PointCloud& cloud, std::size_t limit, const Wanted& wanted) {
  std::vector<std::size_t> taken;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (wanted(cloud.points[i])) taken.push_back(i);
  }
  const std::size_t step = std::max<std::size_t>(1, (taken.size() + limit - 1) / limit);
  PointCloud out;
  for (std::size_t i = 0; i < taken.size(); i += step) {
    out.points.push_back(cloud.points[taken[i]]);
    if (cloud.has_normals()) out.normals.push_back(cloud.normals[taken[i]]);
  }
  return out;
}

// At most `limit` samples of each part, spread evenly over the order they stand in.
SurfaceSamples some_of_each_part(const SurfaceSamples& samples, std::size_t parts,
                                 std::size_t limit) {
  std::vector<std::vector<std::size_t>> of_part(parts);
  for (std::size_t i = 0; i < samples.part.size(); ++i)
    of_part[static_cast<std::size_t>(samples.part[i])].push_back(i);
  SurfaceSamples some;
  some.radius_m = samples.radius_m;
  for (const std::vector<std::size_t>& all : of_part) {
    const std::size_t step = std::max<std::size_t>(1, (all.size() + limit - 1) / limit);
    for (std::size_t k = 0; k < all.size(); k += step) {
      some.cloud.points.push_back(samples.cloud.points[all[k]]);
      some.part.push_back(samples.part[all[k]]);
    }
  }
  return some;
}

}  // namespace

std::string_view name(TrackQuality quality) {
  switch (quality) {
    case TrackQuality::kGood:
      return "good";
    case TrackQuality::kPoor:
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
  NoiseModel noise;
  FrameProcessorOptions options;
  Eigen::AlignedBox3d bounds;
  SurfaceSamples coverage_samples;
  std::uint64_t revision = 0;
  std::uint64_t alignment = 0;
  std::string alignment_hint;           // why the last alignment was not believed
  std::optional<Pose> T_design_camera;  // of the last believed frame

  // While picks are made: the held frame as a surface, and the newest frame's pose in it.
  VisionStatePtr held;
  std::optional<DesignSurface> held_surface;
  Pose T_held_camera = Pose::Identity();

  [[nodiscard]] std::shared_ptr<VisionState> thin(std::shared_ptr<const DepthFrame> frame,
                                                  PointCloud organised, const Camera& small);
  void measure(VisionState& state) const;
  void track(VisionState& state, const Pose& guess, const IcpOptions& refinement);
  [[nodiscard]] IcpOptions frame_to_frame() const;
  [[nodiscard]] double noise_at(const Pose& T_camera_design) const;
};

FrameProcessor::FrameProcessor(std::shared_ptr<const PreparedDesign> design, const Camera& camera,
                               const NoiseModel& noise, const FrameProcessorOptions& options)
    : impl_(std::make_unique<Impl>()) {
  impl_->bounds = design->model.bounds();
  impl_->coverage_samples =
      some_of_each_part(design->samples, design->model.parts.size(), options.coverage_samples);
  impl_->design = std::move(design);
  impl_->camera = camera;
  impl_->noise = noise;
  impl_->options = options;
}

FrameProcessor::~FrameProcessor() = default;
FrameProcessor::FrameProcessor(FrameProcessor&&) noexcept = default;
FrameProcessor& FrameProcessor::operator=(FrameProcessor&&) noexcept = default;

std::shared_ptr<VisionState> FrameProcessor::Impl::thin(std::shared_ptr<const DepthFrame> frame,
                                                        PointCloud organised, const Camera& small) {
  auto state = std::make_shared<VisionState>();
  state->revision = ++revision;
  state->alignment = alignment;
  state->frame = std::move(frame);
  state->stride_px = options.stride_px;
  estimate_organised_normals(organised, small, noise);
  state->scan = measured_points(organised);
  return state;
}

// The sensor's standard deviation at the spool's middle, never under one depth count.
double FrameProcessor::Impl::noise_at(const Pose& T_camera_design) const {
  const double z = std::max((T_camera_design * bounds.center()).z(), 0.1);
  return std::max(noise.axial_m(z), 0.5 * camera.depth_unit_m);
}

IcpOptions FrameProcessor::Impl::frame_to_frame() const {
  return {.max_iterations = options.track_iterations,
          .start_distance_m = options.track_distance_m,
          .stop_translation_m = options.track_stop_m,
          .stop_rotation_rad = options.track_stop_rad};
}

// Refines `guess` on the state's points and says how far the frame bears it out.
void FrameProcessor::Impl::track(VisionState& state, const Pose& guess,
                                 const IcpOptions& refinement) {
  StageClock clock(state.timing_s);
  state.point_noise_m = noise_at(guess.inverse());
  const double margin = options.near_design_m;
  const Eigen::AlignedBox3f box((bounds.min().array() - margin).matrix().cast<float>(),
                                (bounds.max().array() + margin).matrix().cast<float>());
  const Eigen::Isometry3f T_guess = guess.cast<float>();
  const PointCloud near =
      some_of(state.scan, options.track_points,
              [&](const Eigen::Vector3f& point) { return box.contains(T_guess * point); });
  IcpOptions icp_options = refinement;
  icp_options.noise_m = state.point_noise_m;
  const IcpResult icp = refine_icp(near, *design->surface, guess, icp_options);
  clock.mark("track");
  // The gate of "seen": three standard deviations of a point, and what the fit leaves over.
  const double gate = 3.0 * state.point_noise_m + icp.rms_m;
  const SurfaceAgreement agreement = surface_agreement(
      design->samples, *design->surface, *state.frame, camera, icp.T_design_scan, gate);
  clock.mark("agreement");
  state.agreement = agreement.share();
  state.rms_m = icp.rms_m;
  const bool in_sight =
      agreement.seen >= options.min_samples && agreement.share_in_sight() >= options.min_in_sight;
  if (!in_sight || state.agreement < options.lost_agreement || icp.correspondences == 0) {
    state.quality = TrackQuality::kLost;
    state.hint = in_sight ? "Lost: hold still and look at the spool from where it was last seen."
                          : "Lost: point the camera at the spool again.";
    state.T_design_camera = T_design_camera.value_or(guess);
    return;
  }
  state.T_design_camera = icp.T_design_scan;
  T_design_camera = icp.T_design_scan;
  const bool good = state.agreement >= options.good_agreement && icp.weak_directions.empty() &&
                    icp.rms_m <= options.good_rms_noises * state.point_noise_m;
  state.quality = good ? TrackQuality::kGood : TrackQuality::kPoor;
  if (!good) {
    state.hint = icp.weak_directions.empty()
                     ? "Unsure: move closer, or look where more of the spool is seen."
                     : "Unsure: it may be " + icp.weak_directions.front().text +
                           "; look where a flange or an elbow is seen too.";
  }
  measure(state);
  clock.mark("deviation");
}

void FrameProcessor::Impl::measure(VisionState& state) const {
  state.scan_design = moved(state.scan, state.T_design_camera);
  state.classes.assign(state.scan_design.size(), PointClass::kObject);
  state.deviations = measure_deviations(state.scan_design, state.classes, *design->surface,
                                        static_cast<float>(options.max_deviation_m));
  // What a single point may be off by at random is not looked at: three standard deviations.
  drop_turned_away(state.scan_design, state.T_design_camera.translation(), *design->surface,
                   static_cast<float>(3.0 * state.point_noise_m), state.classes, state.deviations);
  state.parts = summarise_parts(design->model, state.scan_design, state.classes, state.deviations,
                                coverage_samples);
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
  std::map<std::string, double> times;
  StageClock clock(times);
  const Camera small = every_nth_pixel(self.camera, self.options.stride_px);
  Result<PointCloud> organised =
      back_project(every_nth_pixel(*frame, self.options.stride_px), small);
  if (!organised) return organised.error();
  auto state = self.thin(std::move(frame), std::move(*organised), small);
  clock.mark("thin");
  state->timing_s = std::move(times);
  state->hint = self.alignment_hint;

  if (self.held && self.held_surface) {
    // Camera motion while picks are made: this frame against the held one.
    const PointCloud all = some_of(state->scan, self.options.track_points,
                                   [](const Eigen::Vector3f&) { return true; });
    const IcpResult icp = refine_icp(all, *self.held_surface, self.T_held_camera,
                                     {.start_distance_m = self.options.track_distance_m});
    if (icp.converged) self.T_held_camera = icp.T_design_scan;
  } else if (self.T_design_camera) {
    self.track(*state, *self.T_design_camera, self.frame_to_frame());
  }
  return VisionStatePtr(std::move(state));
}

void FrameProcessor::hold(VisionStatePtr held) {
  Impl& self = *impl_;
  self.held = std::move(held);
  self.T_held_camera = Pose::Identity();
  self.held_surface.reset();
  if (auto surface = DesignSurface::build(CloudView(self.held->scan))) {
    self.held_surface.emplace(std::move(*surface));
  }
}

void FrameProcessor::release() {
  impl_->held_surface.reset();
  impl_->held.reset();
}

VisionStatePtr FrameProcessor::align(const VisionState& held, const Pose& T_design_camera) {
  Impl& self = *impl_;
  auto state = std::make_shared<VisionState>();
  state->revision = ++self.revision;
  state->alignment = ++self.alignment;
  state->frame = held.frame;
  state->scan = held.scan;
  state->stride_px = held.stride_px;
  self.T_design_camera.reset();
  self.alignment_hint.clear();
  self.track(*state, T_design_camera, {.start_distance_m = self.options.align_distance_m});
  if (!state->is_tracked()) {
    state->quality = TrackQuality::kUnaligned;
    self.alignment_hint = "The picks do not fit what is seen: undo one and pick it again.";
    state->hint = self.alignment_hint;
    self.T_design_camera.reset();
  } else if (self.held && self.held->frame == held.frame) {
    // The camera went on while the picks were made: start from where it is now.
    self.T_design_camera = state->T_design_camera * self.T_held_camera;
  }
  release();
  return state;
}

void FrameProcessor::forget() {
  impl_->T_design_camera.reset();
  impl_->alignment_hint.clear();
}

}  // namespace spool
