// A bracket over a floor seen by a depth camera, ray-cast in memory.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/app/runner/simulated_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <random>
#include <thread>
#include <utility>

namespace spool::test {

namespace {

constexpr double kFloorZ = -0.10;  // m, design frame; the design's z points up

void add_box(DesignModel& model, const std::string& name, const Eigen::Vector3f& low,
             const Eigen::Vector3f& high) {
  Part part;
  part.name = name;
  part.first_triangle = static_cast<std::uint32_t>(model.mesh.triangles.size());
  const auto base = static_cast<std::uint32_t>(model.mesh.vertices.size());
  for (int corner = 0; corner < 8; ++corner) {
    model.mesh.vertices.emplace_back((corner & 1) != 0 ? high.x() : low.x(),
                                     (corner & 2) != 0 ? high.y() : low.y(),
                                     (corner & 4) != 0 ? high.z() : low.z());
  }
  // Counter-clockwise from outside.
  constexpr std::array<std::array<std::uint32_t, 4>, 6> kFaces{
      {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
  for (const auto& f : kFaces) {
    model.mesh.triangles.push_back({base + f[0], base + f[1], base + f[2]});
    model.mesh.triangles.push_back({base + f[0], base + f[2], base + f[3]});
  }
  part.triangle_count =
      static_cast<std::uint32_t>(model.mesh.triangles.size()) - part.first_triangle;
  const auto index = static_cast<std::int32_t>(model.parts.size());
  model.triangle_part.insert(model.triangle_part.end(), part.triangle_count, index);
  model.parts.push_back(std::move(part));
}

// A surface that stands at T_shop_surface; T_shop_camera sees it.
struct Thing {
  const DesignSurface* surface;
  Pose T_shop_surface = Pose::Identity();
};

std::shared_ptr<const DepthFrame> cast_frame(const std::vector<Thing>& things, const Pose& T,
                                             std::int64_t index, double noise_m,
                                             const Camera& camera = small_camera()) {
  auto frame = std::make_shared<DepthFrame>();
  frame->index = index;
  frame->seconds = static_cast<double>(index) / 30.0;
  frame->width = camera.width;
  frame->height = camera.height;
  std::mt19937 random(static_cast<std::uint32_t>(index) + 1);
  std::normal_distribution<double> noise(0, 1);
  for (int v = 0; v < camera.height; ++v) {
    for (int u = 0; u < camera.width; ++u) {
      const Eigen::Vector3d ray = camera.back_project(u, v, 1.0);  // depth 1 along the axis
      const Eigen::Vector3d direction = T.linear() * ray;
      double z = direction.z() < 0 ? (kFloorZ - T.translation().z()) / direction.z() : 0;
      for (const Thing& thing : things) {
        const Pose T_surface_shop = thing.T_shop_surface.inverse();
        const auto hit = thing.surface->cast(
            (T_surface_shop * T.translation()).cast<float>(),
            (T_surface_shop.linear() * direction.normalized()).cast<float>(), 10.0F);
        if (hit && (z <= 0 || hit->distance / ray.norm() < z)) z = hit->distance / ray.norm();
      }
      const bool measured = z > 0 && z < 6;
      const double count =
          measured ? std::round((z + noise_m * noise(random)) / camera.depth_unit_m) : 0;
      frame->depth.push_back(static_cast<std::uint16_t>(count));
    }
  }
  return frame;
}

}  // namespace

DesignModel bracket_design() {
  DesignModel model;
  model.path = "bracket";
  add_box(model, "base", {0.0F, 0.0F, 0.0F}, {0.40F, 0.20F, 0.05F});
  add_box(model, "arm", {0.0F, 0.0F, 0.05F}, {0.08F, 0.20F, 0.20F});
  add_box(model, "post", {0.30F, 0.12F, 0.05F}, {0.36F, 0.18F, 0.14F});
  return model;
}

std::shared_ptr<const PreparedDesign> prepared_bracket() {
  static const auto prepared = [] {
    auto result = PreparedDesign::prepare(bracket_design());
    return result ? *result : nullptr;
  }();
  return prepared;
}

std::shared_ptr<const PreparedDesign> prepared_plate(bool with_peg) {
  DesignModel model;
  model.path = "plate";
  add_box(model, "plate", {0.0F, 0.0F, 0.0F}, {0.40F, 0.20F, 0.05F});
  if (with_peg) add_box(model, "peg", {0.04F, 0.08F, -0.05F}, {0.10F, 0.14F, 0.0F});
  auto result = PreparedDesign::prepare(std::move(model));
  return result ? *result : nullptr;
}

Camera small_camera() {
  Camera camera;
  camera.width = 160;
  camera.height = 120;
  camera.fx = camera.fy = 144;
  camera.cx = 79.5;
  camera.cy = 59.5;
  return camera;
}

Camera larger_camera(double times) {
  Camera camera = small_camera();
  camera.width = static_cast<int>(std::lround(times * camera.width));
  camera.height = static_cast<int>(std::lround(times * camera.height));
  camera.fx *= times;
  camera.fy *= times;
  camera.cx = 0.5 * (camera.width - 1);
  camera.cy = 0.5 * (camera.height - 1);
  return camera;
}

Pose T_design_camera(double turn_rad, double shift_m) {
  const Eigen::Vector3d centre(0.2, 0.1, 0.05);
  const double azimuth = -1.0 + turn_rad;
  const Eigen::Vector3d eye =
      centre + Eigen::Vector3d(0.55 * std::cos(azimuth), 0.55 * std::sin(azimuth), 0.65);
  const Eigen::Vector3d forward = (centre - eye).normalized();
  const Eigen::Vector3d right = forward.cross(Eigen::Vector3d::UnitZ()).normalized();
  Pose T = Pose::Identity();
  T.linear().col(0) = right;
  T.linear().col(1) = forward.cross(right);
  T.linear().col(2) = forward;
  T.translation() = eye + shift_m * right;
  return T;
}

std::shared_ptr<const DepthFrame> render_frame(const PreparedDesign& design,
                                               const Pose& T_design_camera, std::int64_t index,
                                               double noise_m) {
  return cast_frame({{design.surface.get()}}, T_design_camera, index, noise_m);
}

std::shared_ptr<const DepthFrame> render_in_workshop(const PreparedDesign* design,
                                                     const Pose& T_shop_design,
                                                     const Pose& T_shop_camera, std::int64_t index,
                                                     const Camera& camera) {
  static const auto furniture = [] {
    DesignModel model;
    model.path = "furniture";
    add_box(model, "crate", {-0.35F, -0.15F, -0.10F}, {-0.12F, 0.10F, 0.06F});
    add_box(model, "shelf", {-0.10F, 0.32F, -0.10F}, {0.50F, 0.45F, 0.12F});
    add_box(model, "block", {0.52F, -0.10F, -0.10F}, {0.66F, 0.08F, 0.02F});
    add_box(model, "sill", {0.05F, -0.32F, -0.10F}, {0.30F, -0.20F, -0.03F});
    auto prepared = PreparedDesign::prepare(std::move(model));
    return prepared ? *prepared : nullptr;
  }();
  std::vector<Thing> things{{furniture->surface.get()}};
  if (design != nullptr) things.push_back({design->surface.get(), T_shop_design});
  return cast_frame(things, T_shop_camera, index, 0.0005, camera);
}

std::shared_ptr<const DepthFrame> empty_frame(const Pose& T_design_camera, std::int64_t index) {
  return cast_frame({}, T_design_camera, index, 0.0005);
}

ScriptedSource::ScriptedSource(std::vector<Step> steps, bool recording)
    : steps_(std::make_move_iterator(steps.begin()), std::make_move_iterator(steps.end())),
      recording_(recording) {}

Result<sensor::SourceOutput> ScriptedSource::next(std::chrono::milliseconds timeout) {
  if (steps_.empty()) {
    if (recording_) return sensor::SourceOutput{sensor::SourceEvent::kEnd, nullptr};
    std::this_thread::sleep_for(std::min(timeout, std::chrono::milliseconds(2)));
    return sensor::SourceOutput{};
  }
  const Step step = std::move(steps_.front());
  steps_.pop_front();
  if (step.delay.count() > 0) std::this_thread::sleep_for(step.delay);
  if (step.error) return *step.error;
  return step.output;
}

Step frame_step(std::shared_ptr<const DepthFrame> frame) {
  return {{sensor::SourceEvent::kFrame, std::move(frame)}, {}, {}};
}

}  // namespace spool::test
