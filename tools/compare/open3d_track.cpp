// Open3D's point-to-plane ICP as a tracker: onto the frame before, and onto all frames before.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <random>

#include <open3d/pipelines/registration/Registration.h>

#include "tools/compare/contender.h"
#include "tools/compare/open3d_cloud.h"

namespace spool::compare {
namespace {

namespace registration = open3d::pipelines::registration;
using Cloud = open3d::geometry::PointCloud;

constexpr double kReachM = 0.05;  // a hand moves the camera by 10 mm between two frames
constexpr double kCellM = 0.01;   // of the map

Cloud measured(const PointCloud& frame) {
  Cloud out;
  for (std::size_t i = 0; i < frame.size(); ++i) {
    if (!frame.points[i].allFinite() || frame.normals[i].isZero()) continue;
    out.points_.push_back(frame.points[i].cast<double>());
    out.normals_.push_back(frame.normals[i].cast<double>());
  }
  return out;
}

class Open3dFollower : public Follower {
 public:
  explicit Open3dFollower(std::size_t points) : points_(points) {}

  void take(const PointCloud& frame, double /*seconds*/) override {
    frame_ = measured(frame);
    few_ = {};
    if (frame_.points_.empty()) return;
    std::uniform_int_distribution<std::size_t> any(0, frame_.points_.size() - 1);
    for (std::size_t i = 0; i < points_; ++i) few_.points_.push_back(frame_.points_[any(random_)]);
  }

  Pose follow() override {
    if (target_.points_.empty()) return T_first_camera_;
    // The library's own limits: thirty iterations, or fitness and RMSE change by less than 1e-6.
    const auto found =
        registration::RegistrationICP(few_, target_, kReachM, guess().matrix(),
                                      registration::TransformationEstimationPointToPlane());
    take_over(Pose(found.transformation_));
    return T_first_camera_;
  }

 protected:
  [[nodiscard]] virtual Pose guess() const = 0;
  virtual void take_over(const Pose& T_target_camera) = 0;

  Cloud frame_, few_, target_;
  Pose T_first_camera_ = Pose::Identity();

 private:
  std::size_t points_;
  std::mt19937 random_{1};
};

// Each frame onto all points of the one before, from where a steady hand would be.
class FrameToFrame final : public Open3dFollower {
 public:
  using Open3dFollower::Open3dFollower;
  void keep() override { target_ = std::move(frame_); }

 private:
  [[nodiscard]] Pose guess() const override { return T_step_; }
  void take_over(const Pose& T_before_camera) override {
    T_step_ = T_before_camera;
    T_first_camera_ = T_first_camera_ * T_before_camera;
  }

  Pose T_step_ = Pose::Identity();
};

// Each frame onto all before it, thinned to a centimetre, from where the last one was.
class FrameToMap final : public Open3dFollower {
 public:
  using Open3dFollower::Open3dFollower;
  void keep() override {
    frame_.Transform(T_first_camera_.matrix());
    target_ += frame_;
    target_ = *target_.VoxelDownSample(kCellM);
    target_.NormalizeNormals();
  }

 private:
  [[nodiscard]] Pose guess() const override { return T_first_camera_; }
  void take_over(const Pose& T_map_camera) override { T_first_camera_ = T_map_camera; }
};

}  // namespace

std::vector<TrackContender> open3d_track(std::size_t points) {
  std::vector<TrackContender> all;
  all.push_back({"Open3D point-to-plane, frame to frame", std::make_unique<FrameToFrame>(points)});
  all.push_back({"Open3D point-to-plane, frame to map", std::make_unique<FrameToMap>(points)});
  return all;
}

}  // namespace spool::compare
