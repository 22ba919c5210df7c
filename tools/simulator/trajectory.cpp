// Where the simulated camera is at a time.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/simulator/trajectory.h"

#include <cmath>
#include <numbers>
#include <random>

namespace spool::simulator {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

// Six wavering numbers of about unit standard deviation: sums of eight sines each.
Vector6d tremor(std::uint32_t seed, double seconds) {
  constexpr int kSines = 8;
  std::mt19937 random(seed);
  const auto uniform = [&] { return static_cast<double>(random()) / 4294967296.0; };
  Vector6d sum = Vector6d::Zero();
  for (int axis = 0; axis < 6; ++axis) {
    double power = 0;
    for (int i = 0; i < kSines; ++i) {
      const double frequency = 0.4 * std::pow(10.0, (i + uniform()) / kSines);  // Hz, 0.4 to 4
      const double amplitude = 1 / frequency;
      sum(axis) += amplitude * std::sin(kTurn * (frequency * seconds + uniform()));
      power += amplitude * amplitude / 2;
    }
    sum(axis) /= std::sqrt(power);
  }
  return sum;
}

// Looks from `eye` at `target`; the image's right is level.
Pose look_at(const Eigen::Vector3d& eye, const Eigen::Vector3d& target) {
  const Eigen::Vector3d z = (target - eye).normalized();
  Eigen::Vector3d x = z.cross(Eigen::Vector3d::UnitZ());
  if (x.norm() < 1e-6) x = Eigen::Vector3d::UnitX();
  x.normalize();
  Pose pose = Pose::Identity();
  pose.linear().col(0) = x;
  pose.linear().col(1) = z.cross(x);
  pose.linear().col(2) = z;
  pose.translation() = eye;
  return pose;
}

}  // namespace

Pose camera_pose(const Trajectory& trajectory, const Eigen::Vector3d& centre, double seconds) {
  if (trajectory.kind == TrajectoryKind::kFixed) return trajectory.T_map_camera;
  // Distance and height swing with periods that share no multiple with the sweep's.
  const double phase = kTurn * seconds / trajectory.period_s;
  const auto between = [](double low, double high, double swing) {
    return low + (high - low) * (0.5 - 0.5 * swing);
  };
  const double azimuth = trajectory.start_rad + trajectory.sweep_rad * std::sin(phase);
  const double elevation =
      between(trajectory.low_rad, trajectory.high_rad, std::cos(phase * 1.618));
  const double distance = between(trajectory.near_m, trajectory.far_m, std::cos(phase * 1.414));
  const Eigen::Vector3d direction(std::cos(azimuth) * std::cos(elevation),
                                  std::sin(azimuth) * std::cos(elevation), std::sin(elevation));
  Vector6d shake = tremor(trajectory.seed, seconds);
  shake.head<3>() *= trajectory.tremor_m;
  shake.tail<3>() *= trajectory.tremor_rad;
  return look_at(centre + distance * direction, centre) * pose_from_small(shake);
}

}  // namespace spool::simulator
