// Bench: one overlay frame at 1280x800, the whole depth frame's points or a quarter of them,
// coloured by the processor or by the graphics card.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>

#include "render/egl_context.h"
#include "render/overlay.h"
#include "vision/design/design_surface.h"
#include "vision/design/distance_field.h"

namespace spool::render {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kRing = 0.30;  // m, from the middle to the tube's
constexpr double kTube = 0.08;  // m

Eigen::Vector3f on_torus(double around, double across, double out_m) {
  const double r = kRing + (kTube + out_m) * std::cos(across);
  return Eigen::Vector3d(r * std::cos(around), r * std::sin(around),
                         (kTube + out_m) * std::sin(across))
      .cast<float>();
}

// 100 000 triangles: a torus of 500 x 100 quads.
TriangleMesh make_mesh() {
  constexpr std::uint32_t kAround = 500;
  constexpr std::uint32_t kAcross = 100;
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i < kAround; ++i) {
    for (std::uint32_t j = 0; j < kAcross; ++j) {
      mesh.vertices.push_back(on_torus(2 * kPi * i / kAround, 2 * kPi * j / kAcross, 0));
      const std::uint32_t next_i = (i + 1) % kAround;
      const std::uint32_t next_j = (j + 1) % kAcross;
      const auto at = [](std::uint32_t a, std::uint32_t b) { return a * kAcross + b; };
      mesh.triangles.push_back({at(i, j), at(next_i, j), at(next_i, next_j)});
      mesh.triangles.push_back({at(i, j), at(next_i, next_j), at(i, next_j)});
    }
  }
  return mesh;
}

// As many points as a 640 x 480 depth frame has, every `step`-th in both directions: all on the
// side that the view sees, half of them clutter as on a table.
struct Points {
  std::vector<Eigen::Vector3f> points;
  std::vector<float> deviation;
  std::vector<std::uint8_t> classes;
};
Points make_points(int step) {
  Points result;
  for (int v = 0; v < 480; v += step) {
    for (int u = 0; u < 640; u += step) {
      const double deviation = 0.004 * std::sin(0.05 * u) * std::cos(0.07 * v);
      if (v % (2 * step) == 0) {
        result.points.push_back(on_torus(2 * kPi * u / 640, kPi * v / 480, deviation));
      } else {
        result.points.emplace_back(static_cast<float>(u - 320) * 0.003F,
                                   static_cast<float>(v - 240) * 0.003F, -0.2F);
      }
      result.deviation.push_back(static_cast<float>(deviation));
      result.classes.push_back(v % (2 * step) == 0 ? 1 : 0);
    }
  }
  return result;
}

// Arguments: step of the points; 1: darkened by depth; 1: with new points in every frame.
void overlay_frame(benchmark::State& state) {
  const auto context = EglContext::surfaceless();
  if (!context) {
    state.SkipWithError(context.error().message.c_str());
    return;
  }
  auto renderer = OverlayRenderer::create();
  auto target = Offscreen::create(1280, 800);
  if (!renderer || !target) {
    state.SkipWithError((!renderer ? renderer.error() : target.error()).message.c_str());
    return;
  }
  const TriangleMesh mesh = make_mesh();
  renderer->set_design(mesh, {});
  const Points points = make_points(static_cast<int>(state.range(0)));
  renderer->set_points(points.points, points.deviation, points.classes);
  const Eigen::AlignedBox3d bounds(Eigen::Vector3d(-0.38, -0.38, -0.08),
                                   Eigen::Vector3d(0.38, 0.38, 0.08));
  const View view = view_of(bounds, {0.3, 0.5, -1}, Eigen::Vector3d::UnitY(), 1280, 800);
  const OverlayStyle style{.shade_cloud = state.range(1) != 0};
  for (auto _ : state) {
    if (state.range(2) != 0) renderer->set_points(points.points, points.deviation, points.classes);
    const Status status = renderer->draw(*target, view, style);
    if (!status) state.SkipWithError(status.error().message.c_str());
    finish_drawing();
  }
  state.SetLabel(gl_description() + ", " + std::to_string(points.points.size()) + " points");
}
BENCHMARK(overlay_frame)
    ->Name("render/overlay_frame")
    ->ArgNames({"step", "shade", "new_points"})
    ->Args({1, 1, 1})
    ->Args({1, 1, 0})
    ->Args({1, 0, 0})
    ->Args({2, 1, 1})
    ->Args({2, 0, 0})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

// What a depth camera sees of the ring and of a table under it, in counts of 0.1 mm.
std::vector<std::uint16_t> ring_depth(const View& view) {
  const Camera& camera = view.camera;
  const Pose T_design_camera = view.T_camera_design.inverse();
  std::vector<std::uint16_t> depth;
  for (int v = 0; v < camera.height; ++v) {
    for (int u = 0; u < camera.width; ++u) {
      const Eigen::Vector3d ray = camera.back_project(u, v, 1);
      double z = 0.1;
      for (int step = 0; step < 60; ++step) {
        const Eigen::Vector3d p = T_design_camera * Eigen::Vector3d(z * ray);
        const double ring = std::hypot(p.head<2>().norm() - kRing, p.z()) - kTube;
        z += std::min(ring, p.z() + 0.2) / ray.norm();
        if (z > 5) break;
      }
      depth.push_back(static_cast<std::uint16_t>(z < 5 ? 1e4 * z : 0));
    }
  }
  return depth;
}

// As many points coloured on the card, with a new depth image in every frame.
void depth_frame(benchmark::State& state) {
  const auto context = EglContext::surfaceless();
  if (!context) {
    state.SkipWithError(context.error().message.c_str());
    return;
  }
  auto renderer = OverlayRenderer::create();
  auto target = Offscreen::create(1280, 800);
  if (!renderer || !target) {
    state.SkipWithError((!renderer ? renderer.error() : target.error()).message.c_str());
    return;
  }
  DesignModel design;
  design.parts.resize(1);
  design.mesh = make_mesh();
  design.triangle_part.assign(design.mesh.triangles.size(), 0);
  renderer->set_design(design.mesh, {});
  const auto surface = DesignSurface::build(design);
  if (!surface || !renderer->set_distances(*make_distance_field(*surface, design.bounds()))) {
    state.SkipWithError("there is no volume");
    return;
  }
  const Eigen::AlignedBox3d bounds(Eigen::Vector3d(-0.38, -0.38, -0.08),
                                   Eigen::Vector3d(0.38, 0.38, 0.08));
  const View view = view_of(bounds, {0.3, 0.5, -1}, Eigen::Vector3d::UnitY(), 1280, 800);
  View sensor = view;
  sensor.camera = camera_in_picture(view.camera, 640, 480);
  sensor.camera.depth_unit_m = 0.0001;
  const std::vector<std::uint16_t> depth = ring_depth(sensor);
  const OverlayStyle style{};
  for (auto _ : state) {
    renderer->set_depth({.depth = depth,
                         .camera = sensor.camera,
                         .T_design_camera = sensor.T_camera_design.inverse(),
                         .facing_beyond_m = 0.003,
                         .facing_cosine = 0.17},
                        true);
    const Status status = renderer->draw(*target, view, style);
    if (!status) state.SkipWithError(status.error().message.c_str());
    finish_drawing();
  }
  state.SetLabel(gl_description());
}
BENCHMARK(depth_frame)->Name("render/depth_frame")->Unit(benchmark::kMillisecond)->UseRealTime();

// The edges and normals of a design, once a design.
void set_design(benchmark::State& state) {
  const auto context = EglContext::surfaceless();
  if (!context) {
    state.SkipWithError(context.error().message.c_str());
    return;
  }
  auto renderer = OverlayRenderer::create();
  if (!renderer) {
    state.SkipWithError(renderer.error().message.c_str());
    return;
  }
  const TriangleMesh mesh = make_mesh();
  for (auto _ : state) {
    renderer->set_design(mesh, {});
    finish_drawing();
  }
}
BENCHMARK(set_design)
    ->Name("render/set_design_100k_triangles")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace
}  // namespace spool::render
