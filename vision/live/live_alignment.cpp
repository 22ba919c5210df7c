// Keeps the design where the spool is while the camera is followed through the scene.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/live/live_alignment.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace spool {

namespace {

constexpr double kClearly = 0.05;  // more of the surface in sight is seen there
constexpr double kNoises = 3;      // of a point: the datum fit follows what is nearer by itself

// At most `limit` of the points in the box at pose T, spread evenly over the order they stand in.
PointCloud some_in(const Eigen::AlignedBox3f& box, const Eigen::Isometry3f& T,
                   const PointCloud& cloud, std::size_t limit) {
  std::vector<std::size_t> taken;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (box.contains(T * cloud.points[i])) taken.push_back(i);
  const std::size_t step = std::max<std::size_t>(1, (taken.size() + limit - 1) / limit);
  PointCloud out;
  for (std::size_t i = 0; i < taken.size(); i += step) {
    out.points.push_back(cloud.points[taken[i]]);
    if (cloud.has_normals()) out.normals.push_back(cloud.normals[taken[i]]);
  }
  return out;
}

}  // namespace

LiveAlignment::LiveAlignment(std::shared_ptr<const PreparedDesign> design, const Camera& camera,
                             const Camera& seen_by, const NoiseModel& noise,
                             const LiveAlignmentOptions& options)
    : design_(std::move(design)),
      camera_(camera),
      noise_(noise),
      reading_noise_(noise, seen_by),
      correlated_(correlated_readings(seen_by, 1)),
      options_(options),
      bounds_(design_->model.bounds()),
      datum_(design_->model) {
  if (!design_->model.datums.empty())
    datum_ring_ = BoltRing::of(design_->model, design_->model.datums.front());
}

// The sensor's standard deviation at the spool's middle, never under one depth count.
double LiveAlignment::noise_at(const Pose& T_camera_design) const {
  const double z = std::max((T_camera_design * bounds_.center()).z(), 0.1);
  return std::max(noise_.axial_m(z), 0.5 * camera_.depth_unit_m);
}

// What the pose itself may be off by, two standard deviations at the design's middle.
double LiveAlignment::slack_m() const {
  const Matrix6d a = motion_told_at(bounds_.center());
  const Matrix6d at_middle = a * known_.covariance_as_designed * a.transpose();
  return 2 * std::sqrt(std::max(0.0, at_middle.topLeftCorner<3, 3>().trace() / 3));
}

SurfaceAgreement LiveAlignment::agreement(const DepthFrame& frame, const Pose& T_design_camera,
                                          double slack_m) const {
  // The gate of "seen": three standard deviations of a point, and what the pose leaves over.
  const double gate = 3.0 * noise_at(T_design_camera.inverse()) + slack_m;
  return surface_agreement(design_->samples, *design_->surface, frame, camera_, T_design_camera,
                           gate, known_.counts);
}

bool LiveAlignment::is_in_sight(const SurfaceAgreement& agreement) const {
  return agreement.seen + agreement.seen_through >= options_.min_samples &&
         agreement.share_told() >= options_.min_in_sight;
}

DesignFit LiveAlignment::fit(const PointCloud& scan, const DepthFrame& frame,
                             const Pose& T_guess) const {
  return fitted(scan, frame, T_guess, options_.fit_points, IcpOptions{}.max_iterations);
}

DesignFit LiveAlignment::fitted(const PointCloud& scan, const DepthFrame& frame,
                                const Pose& T_guess, std::size_t points, int iterations) const {
  const double margin = options_.near_design_m;
  const Eigen::AlignedBox3f box((bounds_.min().array() - margin).matrix().cast<float>(),
                                (bounds_.max().array() + margin).matrix().cast<float>());
  const PointCloud near = some_in(box, T_guess.cast<float>(), scan, points);
  DesignFit fit;
  fit.point_noise_m = noise_at(T_guess.inverse());
  IcpOptions icp_options;
  icp_options.max_iterations = iterations;
  icp_options.start_distance_m = options_.start_distance_m;
  icp_options.noise_m = fit.point_noise_m;
  const IcpResult icp = refine_icp(near, *design_->surface, T_guess, icp_options);
  fit.T_design_camera = icp.T_design_scan;
  fit.is_held = icp.weak_directions.empty();
  fit.covariance = icp.covariance * correlated_;
  fit.rms_m = icp.rms_m;
  fit.agreement = agreement(frame, icp.T_design_scan, icp.rms_m);
  const bool in_sight = fit.agreement.seen >= options_.min_samples &&
                        fit.agreement.share_in_sight() >= options_.min_in_sight;
  fit.is_believed =
      in_sight && icp.correspondences > 0 && fit.agreement.share() >= options_.least_of_new;
  if (!fit.is_believed)
    fit.hint = in_sight ? "The drawing does not fit what is seen there."
                        : "Too little of the spool is seen: point the camera at it.";
  return fit;
}

void LiveAlignment::set(const Pose& T_design_map) {
  forget();
  T_design_map_ = T_design_map;
  known_ = datum_.solve();  // nothing read yet: what is known beforehand
  known_.counts.clear();
}

void LiveAlignment::forget() {
  T_design_map_.reset();
  datum_.clear();
  known_ = {};
  seconds_.reset();
  T_apart_of_late_.reset();
  missed_ = moved_ = 0;
}

LiveAlignment::Place LiveAlignment::place(const PointCloud& scan, const DepthFrame& frame,
                                          const Pose& T_map_camera) {
  Place place;
  DesignFit& here = place.fit;
  here.T_design_camera = *T_design_map_ * T_map_camera;
  here.point_noise_m = noise_at(here.T_design_camera.inverse());
  here.agreement = agreement(frame, here.T_design_camera, slack_m());
  const bool can_tell = is_in_sight(here.agreement);  // else it is taken to be where it was
  here.is_believed = !can_tell || here.agreement.share() >= options_.least_agreement;
  missed_ = here.is_believed ? 0 : missed_ + 1;
  if (here.is_believed && moved_ == 0 && ++looks_ % options_.frames_a_check != 0) return place;
  DesignFit near = check(scan, frame, T_map_camera, here);
  if (moved_ >= options_.checks_to_notice) {
    set(T_elsewhere_);
    place.fit = std::move(near);
    place.was_moved = true;
    return place;
  }
  place.is_doubtful = moved_ > 0;
  if (here.is_believed) return place;
  here.hint = "The spool is not where it was: look at all of it, or press Find.";
  place.is_gone = missed_ >= options_.frames_to_search;
  return place;
}

// Fits the design anew and counts in `moved_` how often on end that put the spool elsewhere, at the
// same place. A spool that is not as drawn fits elsewhere by much the same from check to check; a
// bump is sudden.
DesignFit LiveAlignment::check(const PointCloud& scan, const DepthFrame& frame,
                               const Pose& T_map_camera, const DesignFit& here) {
  DesignFit near =
      fitted(scan, frame, here.T_design_camera, options_.check_points, options_.check_iterations);
  near.agreement = agreement(frame, near.T_design_camera, slack_m());  // by the same gate
  const double near_by = kNoises * here.point_noise_m;
  const Pose T_there = near.T_design_camera * T_map_camera.inverse();
  const Pose T_apart = near.T_design_camera * here.T_design_camera.inverse();
  const bool is_new = moved_ == 0 || apart_m(T_there, T_elsewhere_) > near_by;
  const bool is_sudden =
      T_apart_of_late_ && apart_m(T_apart, *T_apart_of_late_) > near_by + slack_m();
  const bool says_so =
      near.is_believed && is_elsewhere(near, here) && (is_sudden || !here.is_believed);
  if (!says_so) T_apart_of_late_ = T_apart;
  moved_ = !says_so ? 0 : is_new ? 1 : moved_ + 1;
  T_elsewhere_ = T_there;
  return near;
}

// Mean displacement (m) of the design from one pose to another, nearly.
double LiveAlignment::apart_m(const Pose& a, const Pose& b) const {
  const Pose apart = a * b.inverse();
  return (apart * bounds_.center() - bounds_.center()).norm() +
         pose_size(apart).rotation_rad * 0.25 * bounds_.diagonal().norm();
}

// Further off than the datum fit follows by itself, and clearly more of the parts that the datum is
// known by is seen there: by more than two standard deviations of so many samples.
bool LiveAlignment::is_elsewhere(const DesignFit& there, const DesignFit& here) const {
  const double off = apart_m(there.T_design_camera, here.T_design_camera);
  const SurfaceAgreement& of = here.agreement;
  const auto measured =
      static_cast<double>(std::max<std::size_t>(1, of.seen + of.seen_through + of.hidden));
  const double share = of.share_in_sight();
  const double chance = std::sqrt(share * (1 - share) / measured) + 1 / measured;
  return off > kNoises * here.point_noise_m + slack_m() &&
         there.agreement.share_in_sight() > share + std::max(kClearly, 2 * chance);
}

void LiveAlignment::refine(const VisionState& state) {
  const double now = state.frame->seconds;
  constexpr double kWhile_s = 1;         // before the first there was a while without any
  constexpr double kFrame_s = 1.0 / 30;  // where no clock tells
  const double passed = !seconds_            ? kWhile_s
                        : std::isfinite(now) ? std::max(0.0, now - *seconds_)
                                             : kFrame_s;
  if (std::isfinite(now)) seconds_ = now;
  std::optional<BoltLook> holes;
  if (datum_ring_) holes = datum_ring_->read(*state.frame, camera_, noise_, state.T_design_camera);
  take_in(state, passed, 0, holes ? &*holes : nullptr);
}

void LiveAlignment::take_in(const VisionState& state, double passed_s, double wide_m,
                            const BoltLook* holes) {
  std::vector<float> variances(state.scan.size());
  for (std::size_t i = 0; i < variances.size(); ++i)
    if (state.deviations.part[i] >= 0)
      variances[i] = reading_noise_.variance(state.scan.points[i], state.scan.normals[i]);
  datum_.add({CloudView(state.scan_design), state.deviations, variances, correlated_, passed_s,
              wide_m, holes});
  known_ = datum_.solve();
  T_design_map_ = moved_about(Eigen::Vector3d::Zero(), known_.step, *T_design_map_);
  datum_.follow(known_.step);
}

void LiveAlignment::settle(VisionState& state, const std::function<void(VisionState&)>& measure) {
  // As wide as picks and a wrong joint may put a part, then narrower as the pose gets better.
  constexpr std::array<double, 6> kWide_m = {0.02, 0.012, 0.007, 0.004, 0.002, 0};
  constexpr double kWhile_s = 1;
  for (const double wide_m : kWide_m) {
    state.T_design_camera = *T_design_map_ * state.T_map_camera;
    measure(state);
    datum_.clear();
    take_in(state, kWhile_s, wide_m);
  }
  state.T_design_camera = *T_design_map_ * state.T_map_camera;
  set(*T_design_map_);
}

bool LiveAlignment::is_settled(const Eigen::Vector3d& there, double allowed_m,
                               double allowed_rad) const {
  constexpr double kShare = 0.2;
  const Vector6d step = motion_told_at(there) * known_.step;
  return step.head<3>().norm() <= kShare * allowed_m &&
         step.tail<3>().norm() <= kShare * allowed_rad;
}

}  // namespace spool
