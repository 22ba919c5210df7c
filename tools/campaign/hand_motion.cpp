// How a hand carries a camera about an object: a smooth way at a stated speed, and tremor on it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/campaign/hand_motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tools/campaign/hand_camera.h"
#include "tools/campaign/random.h"

namespace spool::campaign {
namespace {

using Eigen::Vector3d;
constexpr double kTurn = 2 * std::numbers::pi;
constexpr int kSteps = 720;  // of the way

}  // namespace

HandMotion::Shape HandMotion::drawn(const Eigen::AlignedBox3d& object, double lift,
                                    Random& random) const {
  Shape shape;
  shape.middle = object.center();
  const Vector3d half = object.sizes() / 2;
  const bool longer_in_x = half.x() > half.y();
  shape.along = longer_in_x ? Vector3d(half.x(), 0, 0) : Vector3d(0, half.y(), 0);
  if (random.chance(0.5)) shape.along *= -1;
  for (double& phase : shape.phase) phase = random.uniform(0, kTurn);
  shape.distance = 0.5 * (settings_.nearest_m + settings_.farthest_m);
  shape.distance_swing = 0.5 * (settings_.farthest_m - settings_.nearest_m);
  shape.elevation = 0.45 + lift;
  shape.elevation_swing = 0.2;
  if (settings_.way == Way::kRound) {
    shape.azimuth = random.uniform(0, kTurn);
    shape.azimuth_swing = random.uniform(0.5, 1.0);
    shape.along *= 0.4;
  } else if (settings_.way == Way::kAround) {
    // Where the way begins the camera stands beyond the near end.
    const Vector3d out = -shape.along;
    shape.azimuth = std::atan2(out.y(), out.x());
    shape.azimuth_swing = random.chance(0.5) ? 1 : -1;  // which way round
    shape.distance_swing *= 0.4;
  } else {
    const double across = longer_in_x ? kTurn / 4 : 0;
    shape.azimuth = across + (random.chance(0.5) ? kTurn / 2 : 0);
    shape.azimuth_swing = 0.15;
    shape.distance_swing *= 0.4;
  }
  return shape;
}

Pose HandMotion::on_way(const Shape& shape, double share) const {
  const double a = kTurn * share;
  const bool goes_round = settings_.way == Way::kAround;
  const double azimuth = shape.azimuth + shape.azimuth_swing * (goes_round ? a : std::sin(a));
  const double elevation =
      std::min(1.4, shape.elevation + shape.elevation_swing * std::sin(2 * a + shape.phase[0]));
  const double distance = shape.distance + shape.distance_swing * std::sin(a + shape.phase[1]);
  const double along = settings_.way == Way::kRound ? std::sin(a + shape.phase[2]) : -std::cos(a);
  const Vector3d target = shape.middle + along * shape.along;
  const Vector3d out(std::cos(elevation) * std::cos(azimuth),
                     std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
  return looking(target + distance * out, target);
}

// How many places of the way are no good: too low, or something stands before the lens or hides
// what it looks at.
int HandMotion::obstructed(const RayWorld& world, const Shape& shape) const {
  int bad = 0;
  for (int i = 0; i < 48; ++i) {
    const Pose pose = on_way(shape, i / 48.0);
    bool clear = pose.translation().z() > 0.25;
    for (const double x : {-0.45, 0.0, 0.45})
      for (const double y : {-0.35, 0.0, 0.35}) {
        const Vector3d direction = pose.linear() * Vector3d(x, y, 1).normalized();
        const auto hit = world.cast(pose.translation(), direction, 4.0);
        // The sensor sees nothing nearer than 0.4 m.
        if (hit && hit->distance < 0.45) clear = false;
      }
    bad += clear ? 0 : 1;
  }
  return bad;
}

void HandMotion::keep_to_speed() {
  when_.assign(1, 0.0);
  for (int i = 0; i < kSteps; ++i) {
    const double share = static_cast<double>(i) / kSteps;
    const PoseSize step =
        pose_size(on_way(shape_, share).inverse() * on_way(shape_, share + 1.0 / kSteps));
    const double least = std::max(step.translation_m / settings_.speed_m_s,
                                  step.rotation_rad / settings_.turn_rad_s);
    // Nobody keeps one speed: between the whole and four tenths of it, three times a way.
    const double haste = 0.7 + 0.3 * std::cos(3 * kTurn * share);
    when_.push_back(when_.back() + least / haste);
  }
}

HandMotion::HandMotion(const RayWorld& world, const Eigen::AlignedBox3d& object,
                       const HandSettings& settings, std::uint32_t seed)
    : settings_(settings) {
  Random random(seed, 401);
  int least = 1000;
  for (int attempt = 0; attempt < 60 && least > 0; ++attempt) {
    const Shape shape = drawn(object, 0.01 * attempt, random);
    const int bad = obstructed(world, shape);
    if (bad >= least) continue;
    least = bad;
    shape_ = shape;
  }
  keep_to_speed();
  // Tremor of 1 to 8 Hz, the slower the larger.
  for (std::size_t axis = 0; axis < 6; ++axis) {
    const double rms = (axis < 3 ? settings.tremor_m : settings.tremor_rad) / std::sqrt(3.0);
    double power = 0;
    for (int k = 0; k < 12; ++k) {
      const double hertz = std::pow(8.0, random.uniform());
      waves_[axis].push_back({hertz, random.uniform(0, kTurn), 1 / hertz});
      power += 0.5 / (hertz * hertz);
    }
    for (Wave& wave : waves_[axis]) wave.amplitude *= rms / std::sqrt(power);
  }
}

Pose HandMotion::T_scan_camera(double seconds) const {
  const double within = std::fmod(seconds, period_s());
  const auto after = std::upper_bound(when_.begin() + 1, when_.end() - 1, within);
  const auto i = static_cast<double>(after - when_.begin()) - 1;
  const double share = (i + (within - *(after - 1)) / (*after - *(after - 1))) / kSteps;
  Vector6d tremor = Vector6d::Zero();
  for (std::size_t axis = 0; axis < 6; ++axis)
    for (const Wave& wave : waves_[axis])
      tremor[static_cast<Eigen::Index>(axis)] +=
          wave.amplitude * std::sin(kTurn * wave.hertz * seconds + wave.phase);
  return on_way(shape_, share) * pose_from_small(tremor);
}

}  // namespace spool::campaign
