// Taps as a fitter would.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/app/application/robot_fitter.h"

#include <algorithm>
#include <cmath>

namespace spool::test {

namespace {

struct ScreenView {
  double fx = 0, fy = 0, cx = 0, cy = 0, x = 0, y = 0, width = 0, height = 0;
  Pose T_view_world = Pose::Identity();

  [[nodiscard]] std::optional<Spot> spot(const Eigen::Vector3d& p_world) const {
    const Eigen::Vector3d p = T_view_world * p_world;
    if (p.z() <= 0) return std::nullopt;
    const double u = fx * p.x() / p.z() + cx;
    const double v = fy * p.y() / p.z() + cy;
    constexpr double kEdge = 12;  // px: taps stay clear of the picture's edge
    if (u < kEdge || v < kEdge || u > width - kEdge || v > height - kEdge) return std::nullopt;
    return Spot{x + u, y + v};
  }
};

ScreenView parse(const nlohmann::json& json) {
  ScreenView view;
  view.fx = json.at("fx");
  view.fy = json.at("fy");
  view.cx = json.at("cx");
  view.cy = json.at("cy");
  const auto rect = json.at("rect").get<std::vector<double>>();
  view.x = rect.at(0);
  view.y = rect.at(1);
  view.width = rect.at(2);
  view.height = rect.at(3);
  const auto numbers = json.at("T_view_world").get<std::vector<double>>();
  view.T_view_world = pose_from_row_major(numbers).value_or(Pose::Identity());
  return view;
}

// Nothing of the design lies between a point of its surface and an eye; the surface faces it.
bool in_sight(const PreparedDesign& design, const Eigen::Vector3d& point,
              const Eigen::Vector3d& normal, const Eigen::Vector3d& eye) {
  const Eigen::Vector3d way = eye - point;
  const Eigen::Vector3d direction = way.normalized();
  if (normal.dot(direction) < 0.4) return false;
  const Eigen::Vector3d from = point + 1e-3 * direction;
  return !design.surface
              ->cast(from.cast<float>(), direction.cast<float>(), static_cast<float>(way.norm()))
              .has_value();
}

}  // namespace

std::optional<Spot> spot_in(const nlohmann::json& view, const Eigen::Vector3d& p_world) {
  return parse(view).spot(p_world);
}

std::vector<SpotPair> choose_three(const nlohmann::json& screen, const PreparedDesign& design,
                                   const Camera& camera, const DepthFrame& frame,
                                   const Pose& T_design_camera) {
  const ScreenView drawing = parse(screen.at("design_view"));
  const ScreenView scan = parse(screen.at("scan_view"));
  const Eigen::Vector3d drawing_eye = drawing.T_view_world.inverse().translation();
  struct Candidate {
    Eigen::Vector3d point;
    SpotPair spots;
  };
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < design.samples.cloud.size(); ++i) {
    const Eigen::Vector3d point = design.samples.cloud.points[i].cast<double>();
    const Eigen::Vector3d normal = design.samples.cloud.normals[i].cast<double>();
    if (!in_sight(design, point, normal, drawing_eye)) continue;
    if (!in_sight(design, point, normal, T_design_camera.translation())) continue;
    const Eigen::Vector3d p_camera = T_design_camera.inverse() * point;
    const Eigen::Vector2d pixel = camera.project(p_camera);
    const auto u = std::lround(pixel.x()), v = std::lround(pixel.y());
    if (u < 0 || v < 0 || u >= frame.width || v >= frame.height) continue;
    const double z =
        camera.depth_unit_m * frame.depth[static_cast<std::size_t>(v * frame.width + u)];
    if (std::abs(z - p_camera.z()) > 0.02) continue;  // something else is measured there
    const auto design_spot = drawing.spot(point);
    const auto scan_spot = scan.spot(p_camera);
    if (design_spot && scan_spot) candidates.push_back({point, {*design_spot, *scan_spot}});
  }
  // The widest triangle of a sparse choice: enough for a test and quick.
  const std::size_t step = std::max<std::size_t>(1, candidates.size() / 60);
  double best = 0;
  std::vector<SpotPair> chosen;
  for (std::size_t a = 0; a < candidates.size(); a += step) {
    for (std::size_t b = a + step; b < candidates.size(); b += step) {
      for (std::size_t c = b + step; c < candidates.size(); c += step) {
        const Eigen::Vector3d& p = candidates[a].point;
        const double area = (candidates[b].point - p).cross(candidates[c].point - p).norm();
        if (area <= best) continue;
        best = area;
        chosen = {candidates[a].spots, candidates[b].spots, candidates[c].spots};
      }
    }
  }
  return chosen;
}

std::optional<Spot> target(const nlohmann::json& screen, const std::string& name) {
  const auto& targets = screen.at("targets");
  const auto found = targets.find(name);
  if (found == targets.end()) return std::nullopt;
  const auto rect = found->get<std::vector<double>>();
  return Spot{rect.at(0) + 0.5 * rect.at(2), rect.at(1) + 0.5 * rect.at(3)};
}

std::vector<ui::TouchEvent> tap(const Spot& spot) {
  return {{0, ui::TouchPhase::kDown, spot.x, spot.y, 0, 0},
          {0, ui::TouchPhase::kUp, spot.x, spot.y, 0, 0}};
}

}  // namespace spool::test
