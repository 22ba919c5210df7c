// What is compared: other libraries' registrations beside ours, on the same points.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "vision/core/point_cloud.h"
#include "vision/core/pose.h"
#include "vision/inspector.h"

namespace spool::compare {

// A scan near its place on a design, for refinement. Everything in metres.
struct IcpCase {
  PointCloud source;  // scan frame, no normals, near clutter kept
  PointCloud target;  // design frame, samples of its surface with outward normals
  std::shared_ptr<const PreparedDesign> design;  // with the surface that the samples are of
  Pose T_true = Pose::Identity(), T_guess = Pose::Identity();  // design from scan
  double noise_m = 0.003;
  double reach_m = 0.05;  // correspondences are looked for this far
};

// What a library makes of a case once and keeps: its tree, its covariances.
class PreparedIcp {
 public:
  virtual ~PreparedIcp() = default;
  // Exactly `iterations` iterations from the guess, no stopping before.
  [[nodiscard]] virtual Pose run(int iterations) = 0;
  // What run() builds anew each time because the library cannot keep it; timed, it is taken off.
  virtual void build_index() {}
};

struct IcpContender {
  std::string name;
  std::function<std::unique_ptr<PreparedIcp>(const IcpCase&)> prepare;
};

// A scan somewhere in which the design is, or is not.
struct FindCase {
  PointCloud scan;    // scan frame, normals towards nothing in particular
  PointCloud design;  // design frame, samples of its surface with outward normals
  double size_m = 3;  // the design's
  double noise_m = 0.003;
  std::uint32_t seed = 1;
};

struct FindContender {
  std::string name;
  // The pose T_design_scan, or nothing where it says that it found none.
  std::function<std::optional<Pose>(const FindCase&)> find;
};

// Follows a moving camera, frame after frame; the first one stands at the identity.
class Follower {
 public:
  virtual ~Follower() = default;
  // The next frame, organised, with normals (zero where there is none), NaN where nothing was
  // measured; it stays until the next. Not timed: into the library's own containers.
  virtual void take(const PointCloud& frame, double seconds) = 0;
  [[nodiscard]] virtual Pose follow() = 0;  // T_first_camera of that frame
  virtual void keep() {}                    // what the next frames are followed by; timed apart
};

struct TrackContender {
  std::string name;
  std::unique_ptr<Follower> follower;
};

// Each defined where its library was there when this was built.
[[nodiscard]] std::vector<IcpContender> open3d_icp();
[[nodiscard]] std::vector<IcpContender> pcl_icp();
[[nodiscard]] std::vector<FindContender> open3d_find();
[[nodiscard]] std::vector<FindContender> pcl_find();
// With so many points of each frame.
[[nodiscard]] std::vector<TrackContender> open3d_track(std::size_t points);

}  // namespace spool::compare
