// Follows the camera through the scene: frame to scan map, with what the pose is worth.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/align/tracker.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <Eigen/LU>

#include "vision/align/frame_samples.h"
#include "vision/align/keyframes.h"
#include "vision/align/loop_closure.h"
#include "vision/align/map_fit.h"
#include "vision/align/motion_prediction.h"
#include "vision/align/stored_views.h"
#include "vision/core/stage_clock.h"

namespace spool {
namespace {

constexpr double kMajority = 0.5;     // of what bears on a motion has to speak for the pose
constexpr double kFrame = 1.0 / 30;   // s, where the clock says nothing
constexpr std::size_t kFewest = 200;  // samples to say anything by
constexpr std::size_t kViewsToTry = 12;
constexpr double kCoverage95 = 2;  // standard uncertainties

constexpr const char* kLostReason = "Lost: hold still and look where it was last seen.";

bool is_within(const Matrix6d& covariance, double most_m, double most_rad) {
  return kCoverage95 * largest_sigma(covariance.topLeftCorner<3, 3>()) <= most_m &&
         kCoverage95 * largest_sigma(covariance.bottomRightCorner<3, 3>()) <= most_rad;
}

// Covariance of a pose that hangs on a first frame's own surface; nothing where that does not hold
// all motions: a map of a bare wall carries no pose.
std::optional<Matrix6d> own_covariance(const FrameSamples& frame) {
  std::vector<Correspondence> self;
  self.reserve(frame.samples.size());
  for (const FrameSample& sample : frame.samples)
    self.push_back(
        {sample.point, sample.normal, 0.0F, static_cast<float>(frame.variance) / sample.variance});
  const NormalEquations equations = build_normal_equations(self);
  const HeldMotions motions = held_motions(equations, self);
  if (std::any_of(motions.weak.begin(), motions.weak.end(), [](bool weak) { return weak; }))
    return std::nullopt;
  return motion_covariance(equations, motions, frame.variance * frame.correlated);
}

}  // namespace

std::optional<Error> validate(const TrackerOptions& options) {
  if (auto wrong = validate(options.map)) return wrong;
  const bool good = options.samples > 0 && options.good_m > 0 && options.good_rad > 0 &&
                    options.most_keyframes >= 2 && options.most_keyframes <= 65'535 &&
                    options.frames_a_loop > 0 && options.confirmations >= 0 &&
                    options.searches_per_frame > 0 && options.most_gap_s > 0;
  if (good) return std::nullopt;
  return Error{ErrorCode::kUsage, "tracker options: counts, lengths and times must be positive"};
}

std::string_view name(PoseQuality quality) {
  switch (quality) {
    case PoseQuality::kGood:
      return "good";
    case PoseQuality::kPoor:
      return "poor";
    case PoseQuality::kLost:
      break;
  }
  return "lost";
}

struct Tracker::Impl {
  TrackerOptions options;
  ScanMap map;
  MotionPrediction motion;
  StoredViews views;
  Matrix6d covariance = Matrix6d::Zero();  // of the last pose
  double clock_s = 0;                      // our own: never goes back
  std::optional<double> frame_s;           // the source's, of the last frame
  bool is_lost = true;
  Keyframes keyframes;
  std::vector<KeyframeShare> shares = {};  // of the map that the frame now tracked was fitted to
  std::optional<PoseEdge> measured_loop = {};   // in the last frame
  std::optional<std::size_t> looped_from = {};  // keyframe
  int frames_since_loop = 0;                    // was looked for
  bool may_fuse = false;                        // the frame now tracked
  int unconfirmed = 0;       // frames that a pose found anew still has to be borne out by
  std::size_t searches = 0;  // since it was lost

  explicit Impl(const TrackerOptions& with)
      : options(with), map(with.map), keyframes(with.most_keyframes) {}

  double advance(double seconds);
  void start(const SeenFrame& frame, const FrameSamples& samples, TrackedPose& tracked);
  void follow(const SeenFrame& frame, const FrameSamples& samples, double passed_s,
              TrackedPose& tracked);
  void search(const SeenFrame& frame, const FrameSamples& samples, TrackedPose& tracked);
  void take_over(const MapFit& fit, double passed_s, TrackedPose& tracked);
  void grade(const MapFit& fit, TrackedPose& tracked);
  void state_drift(TrackedPose& tracked) const;
  void fuse(const SeenFrame& frame, TrackedPose& tracked);
  void close_measured_loop(TrackedPose& tracked);
  void look_for_loop(const SeenFrame& frame, const FrameSamples& samples, const MapView& view,
                     TrackedPose& tracked);
};

Tracker::Tracker(const TrackerOptions& options) : impl_(std::make_unique<Impl>(options)) {
  assert(!validate(options) && "options that make sense");
}
Tracker::~Tracker() = default;
Tracker::Tracker(Tracker&&) noexcept = default;
Tracker& Tracker::operator=(Tracker&&) noexcept = default;

const ScanMap& Tracker::map() const { return impl_->map; }

void Tracker::clear() { *impl_ = Impl(impl_->options); }

// Seconds since the last frame by the source's clock; one frame's worth where that stands still,
// goes back, leaps or is not a number.
double Tracker::Impl::advance(double seconds) {
  double passed = frame_s ? seconds - *frame_s : kFrame;
  if (!(passed > 0 && passed < 60)) passed = kFrame;
  if (std::isfinite(seconds)) frame_s = seconds;
  clock_s += passed;
  return passed;
}

void Tracker::Impl::start(const SeenFrame& frame, const FrameSamples& samples,
                          TrackedPose& tracked) {
  const auto own = own_covariance(samples);
  if (!own) {
    tracked.reason = "Too plain to follow: look where edges and corners are seen too.";
    return;
  }
  is_lost = false;
  motion.follow(Pose::Identity(), kFrame);
  covariance.setZero();
  tracked.covariance.setZero();  // the map frame is this camera's
  tracked.quality = PoseQuality::kGood;
  tracked.score = 1;
  keyframes.start(*own);
  shares = {{0, 1}};
  fuse(frame, tracked);
}

// Good, poor or lost by what the fit says of itself.
void Tracker::Impl::grade(const MapFit& fit, TrackedPose& tracked) {
  may_fuse = false;
  shares = fit.shares;
  tracked.score = fit.share;
  tracked.weak_directions = fit.weak_directions;
  if (fit.share_high < kMajority) {
    tracked.quality = PoseQuality::kLost;
    tracked.reason = kLostReason;
    return;
  }
  tracked.quality = PoseQuality::kPoor;
  const bool is_sharp = is_within(tracked.covariance, options.good_m, options.good_rad);
  if (!fit.weak_directions.empty()) {
    tracked.reason =
        "Unsure: it may be " + fit.weak_directions.front().text + "; look where more is seen.";
  } else if (!is_sharp) {
    tracked.reason = "Unsure: move closer, or look where more is seen.";
  } else if (fit.share_low < kMajority) {
    tracked.reason = "Unsure: much of what is seen is not where it was.";
  } else {
    tracked.quality = PoseQuality::kGood;
  }
  // Where the pose is held and likelier right than not, what is new has to get into the map, or a
  // camera that moves on leaves behind all that it knows.
  may_fuse = fit.weak_directions.empty() && is_sharp && fit.share >= kMajority;
}

// The fit's pose and covariance, the motion since the last frame standing in where it holds
// nothing.
void Tracker::Impl::take_over(const MapFit& fit, double passed_s, TrackedPose& tracked) {
  const Matrix6d prior = covariance + MotionPrediction::covariance(passed_s);
  tracked.T_map_camera = fit.T_map_camera;
  tracked.covariance = (fit.covariance.inverse() + prior.inverse()).inverse();
  tracked.covariance = 0.5 * (tracked.covariance + tracked.covariance.transpose()).eval();
}

void Tracker::Impl::follow(const SeenFrame& frame, const FrameSamples& samples, double passed_s,
                           TrackedPose& tracked) {
  const MapViews from_last = MapViews::from(map, frame.camera, motion.last());
  std::optional<Pose> guess;
  double least = 0;
  for (const Pose& each : motion.guesses(std::min(passed_s, options.most_gap_s))) {
    const double cost = guess_cost(samples, from_last.fine, each);
    if (guess && cost >= least) continue;
    guess = each;
    least = cost;
  }
  MapFit fit = fit_to_map(samples, from_last, *guess, true);
  if (fit.share_low < kMajority) {
    // A jerk, or a slow camera: look wider, from a view of where it seems to be.
    const MapFit wide = fit_to_map(samples, from_last, *guess, false);
    if (wide.share_low > fit.share_low) fit = wide;
  }
  take_over(fit, passed_s, tracked);
  grade(fit, tracked);
  if (may_fuse && unconfirmed == 0) look_for_loop(frame, samples, from_last.fine, tracked);
}

// The map as it is drawn for the fit does for asking which pieces of it are in view. What was
// measured is put into the graph with the next frame: not all in the time of one.
void Tracker::Impl::look_for_loop(const SeenFrame& frame, const FrameSamples& samples,
                                  const MapView& view, TrackedPose& tracked) {
  if (++frames_since_loop < options.frames_a_loop) return;
  frames_since_loop = 0;
  // One of each keyframe: frames of one place err together and would be counted as many.
  if (looped_from == keyframes.current()) return;
  const auto candidate = find_loop(view, keyframes, tracked.T_map_camera, tracked.covariance);
  if (!candidate) return;
  measured_loop =
      measure_loop(samples, frame.camera, *candidate, map, keyframes, tracked.T_map_camera);
  if (!measured_loop) return;
  looped_from = keyframes.current();
  tracked.loop = LoopOutcome::kMeasured;
}

void Tracker::Impl::close_measured_loop(TrackedPose& tracked) {
  if (!measured_loop) return;
  tracked.map_motions = close_loop(*measured_loop, keyframes, map);
  measured_loop.reset();
  tracked.loop = tracked.map_motions.empty() ? LoopOutcome::kRefused : LoopOutcome::kClosed;
  if (tracked.loop != LoopOutcome::kClosed) return;
  tracked.T_current_moved = tracked.map_motions[keyframes.current()];
  motion.correct(tracked.T_current_moved * motion.last());
}

void Tracker::Impl::search(const SeenFrame& frame, const FrameSamples& samples,
                           TrackedPose& tracked) {
  // The last pose first: a lens that was covered is mostly where it was.
  std::vector<Pose> guesses = views.likest(frame, kViewsToTry);
  guesses.insert(guesses.begin(), motion.last());
  std::optional<MapFit> best;
  for (int i = 0; i < options.searches_per_frame; ++i) {
    const Pose& guess = guesses[searches++ % guesses.size()];
    const MapFit found =
        fit_to_map(samples, MapViews::from(map, frame.camera, guess), guess, false);
    if (best && found.share_low <= best->share_low) continue;
    best = found;
  }
  if (best->share_high < kMajority) {
    tracked.reason = kLostReason;
    return;
  }
  // Once more in the view from there: what is seen from there and not from the guess may
  // contradict.
  const MapFit again = fit_to_map(samples, MapViews::from(map, frame.camera, best->T_map_camera),
                                  best->T_map_camera, true);
  if (again.share_low < kMajority || !again.weak_directions.empty()) {
    tracked.reason = kLostReason;
    return;
  }
  is_lost = false;
  unconfirmed = options.confirmations;
  tracked.found_again = true;
  tracked.T_map_camera = again.T_map_camera;
  tracked.covariance = again.covariance;
  grade(again, tracked);
}

// Adds what the map itself is off by to the covariance that is given out.
void Tracker::Impl::state_drift(TrackedPose& tracked) const {
  tracked.covariance += keyframes.covariance_at(tracked.T_map_camera, shares);
}

void Tracker::Impl::fuse(const SeenFrame& frame, TrackedPose& tracked) {
  const KeyframeId keyframe = keyframes.hang(tracked.T_map_camera, shares, tracked.covariance, map);
  SeenFrame timed{frame.cloud, frame.camera, frame.noise, clock_s};
  tracked.fused = map.fuse(timed, tracked.T_map_camera, keyframe);
  views.offer(frame, tracked.T_map_camera);
}

TrackedPose Tracker::track(const SeenFrame& frame) {
  Impl& self = *impl_;
  TrackedPose tracked;
  StageClock clock(tracked.timing_s);
  self.close_measured_loop(tracked);
  if (self.motion.is_known()) tracked.T_map_camera = self.motion.last();
  clock.mark("close");
  const double passed_s = self.advance(frame.seconds);
  if (!frame.is_usable()) {
    tracked.reason = "The camera's picture cannot be used: check its calibration.";
    self.is_lost = true;
    return tracked;
  }
  const ReadingNoise noise(frame.noise, frame.camera);
  const FrameSamples samples = sample_frame(frame, noise, self.options.samples);
  if (samples.samples.size() < kFewest) {
    tracked.reason = "Nothing is seen: uncover the lens, or step back.";
    self.is_lost = true;
    self.searches = 0;
    self.motion.stop();
    return tracked;
  }
  if (self.map.empty()) {
    self.start(frame, samples, tracked);
    clock.mark("fuse");
    return tracked;
  }
  const bool was_lost = self.is_lost;
  if (was_lost)
    self.search(frame, samples, tracked);
  else
    self.follow(frame, samples, passed_s, tracked);
  clock.mark("fit");
  if (tracked.quality == PoseQuality::kLost) {
    if (!was_lost) self.searches = 0;
    self.is_lost = true;
    self.motion.stop();
    if (self.motion.is_known()) tracked.T_map_camera = self.motion.last();
    return tracked;
  }
  if (was_lost) self.motion.clear();
  self.motion.follow(tracked.T_map_camera, passed_s);
  self.covariance = tracked.covariance;
  if (self.unconfirmed > 0 && tracked.quality == PoseQuality::kGood) {
    tracked.quality = PoseQuality::kPoor;
    tracked.reason = "Found again: hold still for a moment.";
    --self.unconfirmed;
  } else if (self.unconfirmed == 0 && self.may_fuse && !self.measured_loop) {
    self.fuse(frame, tracked);
  }
  self.state_drift(tracked);
  clock.mark("fuse");
  return tracked;
}

void Tracker::tell(const SeenFrame& frame, const Pose& T_map_camera, const Matrix6d& covariance) {
  Impl& self = *impl_;
  if (self.map.empty() || !frame.is_usable()) return;
  self.motion.correct(T_map_camera);
  if (self.is_lost) {
    self.searches = 0;
    return;
  }
  self.covariance = covariance;
  if (self.unconfirmed > 0) return;
  TrackedPose told;
  told.T_map_camera = T_map_camera;
  told.covariance = covariance;
  if (!self.measured_loop) self.fuse(frame, told);
}

}  // namespace spool
