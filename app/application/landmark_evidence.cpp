// Which landmarks the picture that picks are made on has measured.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/application/landmark_evidence.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "vision/live/surface_agreement.h"

namespace spool {

namespace {
constexpr double kTap = 0.015;         // m: a pick is off by 5 to 20 mm
constexpr double kGate = 2 * kTap;     // m: two picks and a coarse turn put a surface off by this
constexpr std::size_t kSamples = 250;  // enough to tell turns apart, few enough for a tap to wait
constexpr int kTurns = 120;            // 3 degrees: 15 mm at 0.3 m from the line
// A pose is believed where the frame agrees with most of what it could tell.
constexpr std::size_t kLeastSeen = 20;
constexpr double kLeastShare = 0.6;
constexpr double kLeastShareInSight = 0.4;
// A landmark is an outermost point: even where all is measured most of what lies about it is
// background; about a corner an eighth is steel.
constexpr double kFullShare = 0.2;

SurfaceSamples thinned(const SurfaceSamples& samples) {
  SurfaceSamples out;
  const std::size_t step = std::max<std::size_t>(1, samples.cloud.size() / kSamples);
  for (std::size_t i = 0; i < samples.cloud.size(); i += step) {
    out.cloud.points.push_back(samples.cloud.points[i]);
    if (samples.cloud.has_normals()) out.cloud.normals.push_back(samples.cloud.normals[i]);
  }
  return out;
}

struct Guess {
  Pose T_design_camera;
  SurfaceAgreement agreement;

  [[nodiscard]] bool is_believed() const {
    return agreement.seen >= kLeastSeen && agreement.share() >= kLeastShare &&
           agreement.share_in_sight() >= kLeastShareInSight;
  }
  [[nodiscard]] double worth() const {
    return static_cast<double>(agreement.seen) - static_cast<double>(agreement.seen_through);
  }
};

Guess guess_at(const PickScene& scene, const SurfaceSamples& samples, const Pose& T_design_camera) {
  return {T_design_camera, surface_agreement(samples, *scene.design.surface, scene.frame,
                                             scene.camera, T_design_camera, kGate)};
}

// The best turn about the line through two pairs.
std::optional<Guess> turned_about(const PickScene& scene, const SurfaceSamples& samples,
                                  const PointPair& a, const PointPair& b) {
  const Eigen::Vector3d design = b.design - a.design, scan = b.scan - a.scan;
  if (design.norm() < kTap || scan.norm() < kTap) return std::nullopt;
  const Eigen::Quaterniond onto = Eigen::Quaterniond::FromTwoVectors(design, scan);
  std::optional<Guess> best;
  for (int turn = 0; turn < kTurns; ++turn) {
    const double angle = 2 * std::numbers::pi * turn / kTurns;
    Pose T_camera_design = Pose::Identity();
    T_camera_design.linear() =
        (Eigen::AngleAxisd(angle, scan.normalized()) * onto).toRotationMatrix();
    T_camera_design.translation() =
        0.5 * (a.scan + b.scan) - T_camera_design.linear() * (0.5 * (a.design + b.design));
    const Guess guess = guess_at(scene, samples, T_camera_design.inverse());
    if (!best || guess.worth() > best->worth()) best = guess;
  }
  return best;
}

// Where the design may be, from all that is known.
std::optional<Guess> best_guess(const PickScene& scene, std::span<const PointPair> pairs) {
  const SurfaceSamples samples = thinned(scene.design.samples);
  if (pairs.size() == 2) return turned_about(scene, samples, pairs[0], pairs[1]);
  if (!scene.T_design_camera) return std::nullopt;
  Pose T = *scene.T_design_camera;
  // A pick says better where the design is now; how it is turned only the earlier pose says.
  if (pairs.size() == 1) T.translation() += pairs[0].design - T * pairs[0].scan;
  return guess_at(scene, samples, T);
}

// The share of the pixels about a point of the camera frame (m) at which something is measured near
// it.
double share_measured(const PickScene& scene, const Eigen::Vector3d& p_camera) {
  if (p_camera.z() <= kTap) return 0;
  const Eigen::Vector2d pixel = scene.camera.project(p_camera);
  const auto reach = static_cast<int>(std::max(2.0, scene.camera.fx * kTap / p_camera.z()));
  if (!(pixel.cwiseAbs().maxCoeff() < 1e6)) return 0;
  const auto u0 = static_cast<int>(std::lround(pixel.x()));
  const auto v0 = static_cast<int>(std::lround(pixel.y()));
  int measured = 0;
  for (int v = std::max(0, v0 - reach); v <= std::min(scene.frame.height - 1, v0 + reach); ++v) {
    for (int u = std::max(0, u0 - reach); u <= std::min(scene.frame.width - 1, u0 + reach); ++u) {
      const std::size_t at =
          static_cast<std::size_t>(v) * static_cast<std::size_t>(scene.frame.width) +
          static_cast<std::size_t>(u);
      const double z = scene.camera.depth_unit_m * scene.frame.depth[at];
      measured += z > 0 && std::abs(z - p_camera.z()) < kGate;
    }
  }
  const double all = (2.0 * reach + 1) * (2.0 * reach + 1);
  return measured / all;
}

bool is_anything_at(const PickScene& scene, const Eigen::Vector3d& from, double distance) {
  return std::any_of(scene.scan.begin(), scene.scan.end(), [&](const Eigen::Vector3f& p) {
    return std::abs((p.cast<double>() - from).norm() - distance) < kGate;
  });
}

}  // namespace

std::vector<double> measured_likelihood(const PickScene& scene, std::span<const Landmark> landmarks,
                                        std::span<const PointPair> pairs) {
  std::vector<double> out(landmarks.size(), 1.0);
  if (pairs.size() > 2 || !scene.frame.is_consistent()) return out;
  const std::optional<Guess> guess = best_guess(scene, pairs);
  const bool believed = guess && guess->is_believed();
  const Pose T_camera_design = believed ? guess->T_design_camera.inverse() : Pose::Identity();
  for (std::size_t i = 0; i < landmarks.size(); ++i) {
    const Eigen::Vector3d& position = landmarks[i].position;
    if (believed) {
      out[i] = std::min(1.0, share_measured(scene, T_camera_design * position) / kFullShare);
    } else if (pairs.size() == 1) {
      out[i] = is_anything_at(scene, pairs[0].scan, (position - pairs[0].design).norm()) ? 1 : 0;
    }
  }
  return out;
}

}  // namespace spool
