// What was read of each patch of the design.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/live/patch_readings.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "vision/core/parallel.h"

namespace spool {
namespace {

constexpr float kTukey = 4.685F;      // standard deviations (Holland & Welsch 1977)
constexpr float kLeastAlike = 0.7F;   // cosine between a reading's normal and the surface's
constexpr float kLeastFacing = 0.2F;  // flatter to the sight than 78 degrees the model means little
constexpr std::uint32_t kNoPatch = std::numeric_limits<std::uint32_t>::max();
constexpr std::size_t kFewest = 3;  // readings of a patch in a frame; fewer have no median
constexpr double kChance = 3;       // standard deviations
constexpr double kGap_s = 0.5;      // what reads otherwise and is gone for so long begins anew
constexpr int kFewestLooks = 5;     // of what reads otherwise
// Within so wide an angle of the camera's ray, and of the projector's 75 mm beside it, a patch is
// seen by the same pixels and dots (ARCHITECTURE, The sensor).
constexpr float kWindowRad = 8.0F / 575;
constexpr float kBaseline = 0.075F;  // m
// A pixel is measured at some moment of the exposure: half the period of a camera of 30 frames a
// second, as its driver does not say.
constexpr double kExposure_s = 1.0 / 60;

bool is_elsewhere(const Eigen::Vector3f& now, const Eigen::Vector3f& then) {
  const float turned = (now.normalized() - then.normalized()).norm();
  return turned > kWindowRad ||
         std::abs(kBaseline / now.norm() - kBaseline / then.norm()) > kWindowRad;
}

}  // namespace

void PatchMean::add(const PatchMean& other) {
  if (other.information <= 0) return;
  const double sum = information + other.information;
  lean_to(other, other.information / sum);
  information = sum;
}

void PatchMean::lean_to(const PatchMean& other, double share) {
  information += share * (other.information - information);
  mean_m += share * (other.mean_m - mean_m);
  held += share * (other.held - held);
}

PatchReadings::PatchReadings(std::shared_ptr<const SurfacePatches> patches, const Camera& seen_by,
                             const NoiseModel& noise, const PatchReadingsOptions& options)
    : patches_(std::move(patches)),
      seen_by_(seen_by),
      noise_(noise, seen_by),
      correlated_(correlated_readings(seen_by, 1)),
      options_(options),
      of_part_(patches_->parts()),
      kept_(patches_->all().size()) {
  for (std::size_t i = 0; i < kept_.size(); ++i)
    of_part_[static_cast<std::size_t>(patches_->all()[i].part)].push_back(
        static_cast<std::uint32_t>(i));
}

void PatchReadings::clear() {
  std::fill(kept_.begin(), kept_.end(), Kept{});
  T_design_camera_.reset();
  exposed_ = 0;
}

// The frame's readings of the surface in the order of their patches.
void PatchReadings::sort_readings(const VisionState& state) {
  const Deviations& deviations = state.deviations;
  const Eigen::Vector3f eye = state.T_design_camera.translation().cast<float>();
  std::size_t near = 0;
  for (const std::int32_t part : deviations.part) near += part >= 0 ? 1U : 0U;
  const std::size_t step = near / options_.most + 1;
  worth_ = std::max(1.0, correlated_ / static_cast<double>(step));
  readings_.clear();
  const bool has_normals = state.scan_design.has_normals();
  std::size_t met = 0;
  for (std::size_t i = 0; i < deviations.part.size(); ++i) {
    if (deviations.part[i] < 0 || met++ % step != 0) continue;
    const Eigen::Vector3f& p = state.scan_design.points[i];
    const Eigen::Vector3f& n = deviations.normal[i];
    if (has_normals && state.scan_design.normals[i].dot(n) < kLeastAlike) continue;
    const float facing = n.dot((eye - p).normalized());
    if (facing < kLeastFacing) continue;
    readings_.push_back({kNoPatch, static_cast<std::uint32_t>(i),
                         noise_.variance(state.scan.points[i].z(), facing)});
  }
  parallel_chunks(readings_.size(), 512, [&](std::size_t begin, std::size_t end) {
    for (std::size_t r = begin; r < end; ++r) {
      const std::uint32_t i = readings_[r].point;
      const Eigen::Vector3f& n = deviations.normal[i];
      const auto patch =
          patches_->at(state.scan_design.points[i] - deviations.distance_m[i] * n, n);
      if (patch && patches_->all()[*patch].part == deviations.part[i]) readings_[r].patch = *patch;
    }
  });
  first_.assign(kept_.size() + 1, 0);
  std::erase_if(readings_, [](const Reading& reading) { return reading.patch == kNoPatch; });
  for (const Reading& reading : readings_) ++first_[reading.patch + 1];
  for (std::size_t k = 0; k < kept_.size(); ++k) first_[k + 1] += first_[k];
  sorted_.resize(readings_.size());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (const Reading& reading : readings_) sorted_[next[reading.patch]++] = reading;
}

// About their median, so that a finger on half of the patch does not count.
PatchMean PatchReadings::mean_of(std::span<const Reading> readings, const VisionState& state) {
  const std::vector<float>& distance = state.deviations.distance_m;
  distances_.clear();
  for (const Reading& reading : readings) distances_.push_back(distance[reading.point]);
  const auto middle = distances_.begin() + static_cast<std::ptrdiff_t>(distances_.size() / 2);
  std::nth_element(distances_.begin(), middle, distances_.end());
  PatchMean mean;
  double counted = 0;
  for (const Reading& reading : readings) {
    const float off = distance[reading.point] - *middle;
    const float u2 = off * off / (kTukey * kTukey * reading.variance_m2);
    if (!(u2 < 1)) continue;
    const double information = double{(1 - u2) * (1 - u2)} / double{reading.variance_m2};
    const Eigen::Vector3d n = state.deviations.normal[reading.point].cast<double>();
    const Eigen::Vector3d p = state.scan_design.points[reading.point].cast<double>();
    mean.information += information;
    mean.mean_m += information * double{distance[reading.point]};
    mean.held.head<3>() += information * n;
    mean.held.tail<3>() += information * p.cross(n);
    counted += 1;
  }
  if (mean.information <= 0) return {};
  mean.mean_m /= mean.information;
  mean.held /= mean.information;
  // Fewer than share a window are worth one.
  mean.information /= std::min(worth_, counted);
  return mean;
}

void PatchReadings::add(const VisionState& state, const Matrix6d& covariance) {
  const double time = state.frame->seconds;
  const double now = std::isfinite(time) ? time : last_s_ + 1.0 / 30;
  T_camera_design_ = state.T_design_camera.inverse();
  const double passed = now - last_s_;
  const bool follows = T_design_camera_ && passed > 0 && passed < kGap_s;
  T_before_ = follows ? T_design_camera_->inverse() : T_camera_design_;
  exposed_ = follows ? std::min(1.0, kExposure_s / passed) : 0.0;
  sort_readings(state);
  for (std::size_t k = 0; k < kept_.size(); ++k) {
    if (first_[k + 1] - first_[k] < kFewest) continue;
    PatchMean look = mean_of({sorted_.data() + first_[k], first_[k + 1] - first_[k]}, state);
    if (look.information <= 0) continue;
    look.information = 1 / (1 / look.information + smear_m2(k));
    const double doubt_m2 = look.held.dot(covariance * look.held);
    take_in(k, look, doubt_m2, T_camera_design_.cast<float>() * patches_->all()[k].point, now);
  }
  T_design_camera_ = state.T_design_camera;
  last_s_ = now;
}

double PatchReadings::smear_m2(std::size_t k) const {
  const SurfacePatch& patch = patches_->all()[k];
  const Eigen::Vector3d p = patch.point.cast<double>();
  const Eigen::Vector3d n = T_camera_design_.linear() * patch.normal.cast<double>();
  const double smear = exposed_ * n.dot(T_camera_design_ * p - T_before_ * p);
  return smear * smear / 12;  // evenly spread
}

void PatchReadings::take_in(std::size_t k, const PatchMean& look, double doubt_m2,
                            const Eigen::Vector3f& p_camera, double now) {
  Kept& kept = kept_[k];
  const PatchMean known = of(k);
  const double chance2 = kChance * kChance * (look.variance_m2() + doubt_m2);
  const auto contradicts = [&](const PatchMean& mean, double more_m2) {
    const double off = look.mean_m - mean.mean_m;
    return off * off > chance2 + kChance * kChance * more_m2;
  };
  if (known.information > 0 && contradicts(known, known.variance_m2())) {
    const bool goes_on = kept.other_looks > 0 && now - kept.other_last_s < kGap_s &&
                         !contradicts(kept.other, look.variance_m2());
    if (!goes_on) {
      kept.other_looks = 0;
      kept.other_since_s = now;
    }
    ++kept.other_looks;
    kept.other_last_s = now;
    kept.other.lean_to(look, 1.0 / kept.other_looks);
    if (kept.other_looks < kFewestLooks || now - kept.other_since_s < options_.change_s) return;
    const PatchMean other = kept.other;
    kept = {};
    kept.here = other;
    kept.looks = kFewestLooks;
    kept.from = p_camera;
    kept.seen_s = now;
    return;
  }
  kept.other_looks = 0;
  const double passed = std::clamp(now - kept.seen_s, 0.0, 1.0 / 15);  // only sight fades it
  const double fades = -std::expm1(-passed / options_.memory_s);
  kept.seen_s = now;
  kept.before.information *= 1 - fades;
  if (kept.looks > 0 && is_elsewhere(p_camera, kept.from)) {
    kept.before.add(kept.here);
    kept.looks = 0;
  }
  if (kept.looks == 0) kept.from = p_camera;
  ++kept.looks;
  kept.here.lean_to(look, std::max(1.0 / kept.looks, fades));
}

void PatchReadings::follow(const Pose& T_new_old) {
  Vector6d step;
  step << T_new_old.translation(), rotation_vector(T_new_old.linear());
  for (Kept& kept : kept_) {
    kept.before.follow(step);
    kept.here.follow(step);
    kept.other.follow(step);
  }
  if (T_design_camera_) T_design_camera_ = T_new_old * *T_design_camera_;
}

PatchMean PatchReadings::of(std::size_t patch) const {
  const Kept& kept = kept_[patch];
  PatchMean mean = kept.before;
  if (kept.looks > 0) mean.add(kept.here);
  return mean;
}

double PatchReadings::variance_of_a_look(std::size_t k, const Eigen::Vector3d& eye) const {
  const SurfacePatch& patch = patches_->all()[k];
  const Eigen::Vector3d sight = eye - patch.point.cast<double>();
  const double range = sight.norm();
  const double facing =
      std::clamp(patch.normal.cast<double>().dot(sight) / range, double{kLeastFacing}, 1.0);
  const double pixels =
      double{patch.area_m2} * facing * seen_by_.fx * seen_by_.fy / (range * range);
  return double{noise_.variance(static_cast<float>(range), static_cast<float>(facing))} /
         std::max(1.0, pixels / correlated_);
}

PartReading PatchReadings::of_part(std::size_t part, const Matrix6d& covariance) const {
  PartReading reading;
  PatchMean sum;
  double variance = 0, area = 0, known = 0;
  for (const std::uint32_t k : of_part_[part]) {
    const double a = double{patches_->all()[k].area_m2};
    area += a;
    const PatchMean mean = of(k);
    if (mean.information <= 0) continue;
    if (mean.information * kKnownSigma_m * kKnownSigma_m >= 1) known += a;
    // By area as far as patches are known; what is hardly known counts for less.
    const double weight = a / (mean.variance_m2() + kKnownSigma_m * kKnownSigma_m);
    sum.add({weight, mean.mean_m, mean.held});
    variance += weight * weight * mean.variance_m2();
  }
  if (area > 0) reading.coverage = known / area;
  if (sum.information <= 0) return reading;
  reading.is_seen = true;
  reading.mean_m = sum.mean_m;
  variance /= sum.information * sum.information;
  reading.u_m = 2 * std::sqrt(variance + sum.held.dot(covariance * sum.held));
  return reading;
}

}  // namespace spool
