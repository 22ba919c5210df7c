// Where the holes of a flange's bolt circle let the camera see through.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/inspect/bolt_ring.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>

namespace spool {
namespace {

constexpr double kPi = std::numbers::pi;
// The ring is about as wide as a hole, which is a fifth to a quarter of the pitch (B16.5), and
// reaches no further than there is steel to either side of the bolt circle.
constexpr double kOfPitch = 0.11, kOfRadius = 0.2;
constexpr double kFlat = 0.98;        // cosine of a face's normal to the axis
constexpr double kSameFace_m = 1e-4;  // heights nearer to each other than that are one
constexpr double kLeastFacing = 0.3;  // cosine of a view of 72 degrees: holes are slits there
constexpr double kSolid = 3.5;        // standard deviations
constexpr double kLeastThrough_m =
    0.006;                           // behind the face: less may be its edge, or its raised part
constexpr std::size_t kFewest = 60;  // readings on the ring
constexpr double kMostBefore = 0.5;  // of the readings: what stands before it hides it
constexpr int kBinsOfPitch = 16;

}  // namespace

std::optional<BoltRing> BoltRing::of(const DesignModel& design, int part) {
  const Part& it = design.parts[static_cast<std::size_t>(part)];
  if (!it.holes || it.holes->count < 3 || !(it.holes->bolt_circle_m > 0)) return std::nullopt;
  BoltRing ring;
  ring.holes_ = *it.holes;
  ring.T_design_part_ = it.T_design_part;
  const double radius = 0.5 * it.holes->bolt_circle_m;
  ring.half_width_m_ = std::min(kOfRadius * radius, kOfPitch * 2 * kPi * radius / it.holes->count);

  // The flat faces round the holes: where most of the area lies that looks either way.
  const Pose T_part_design = it.T_design_part.inverse();
  std::array<std::map<long, double>, 2> areas;  // by height along the axis
  for (std::uint32_t t = 0; t < it.triangle_count; ++t) {
    const auto& corners = design.mesh.triangles[it.first_triangle + t];
    std::array<Eigen::Vector3d, 3> p;
    for (std::size_t i = 0; i < 3; ++i)
      p[i] = T_part_design * design.mesh.vertices[corners[i]].cast<double>();
    const Eigen::Vector3d normal = (p[1] - p[0]).cross(p[2] - p[0]);
    const Eigen::Vector3d middle = (p[0] + p[1] + p[2]) / 3;
    const double area = 0.5 * normal.norm();
    if (!(area > 0) || std::abs(normal.z()) < kFlat * 2 * area ||
        std::abs(middle.head<2>().norm() - radius) > 2 * ring.half_width_m_)
      continue;
    areas[normal.z() > 0 ? 1 : 0][std::lround(middle.z() / kSameFace_m)] += area;
  }
  for (std::size_t side = 0; side < 2; ++side) {
    if (areas[side].empty()) continue;
    const auto most =
        std::max_element(areas[side].begin(), areas[side].end(),
                         [](const auto& a, const auto& b) { return a.second < b.second; });
    ring.faces_[side] = {kSameFace_m * static_cast<double>(most->first), side == 1 ? 1.0 : -1.0};
  }
  if (ring.faces_[0].side == 0 && ring.faces_[1].side == 0) return std::nullopt;
  return ring;
}

std::optional<double> BoltRing::face_height_m(double side) const {
  for (const Face& face : faces_)
    if (face.side * side > 0) return face.z_m;
  return std::nullopt;
}

std::optional<BoltLook> BoltRing::read(const DepthFrame& frame, const Camera& camera,
                                       const NoiseModel& noise, const Pose& T_design_camera) const {
  const Pose T_camera_part = T_design_camera.inverse() * T_design_part_;
  const Pose T_part_camera = T_camera_part.inverse();
  const Eigen::Vector3d& eye = T_part_camera.translation();
  const auto face = std::find_if(faces_.begin(), faces_.end(), [&](const Face& each) {
    return each.side * (eye.z() - each.z_m) > 0;
  });
  if (face == faces_.end()) return std::nullopt;
  const Eigen::Vector3d middle(0, 0, face->z_m);
  const double distance = (eye - middle).norm();
  if (std::abs(eye.z() - face->z_m) < kLeastFacing * distance) return std::nullopt;

  const double radius = 0.5 * holes_.bolt_circle_m;
  const double outer = radius + half_width_m_;
  Eigen::AlignedBox2d box;
  for (int i = 0; i < 16; ++i) {
    const double angle = 2 * kPi * i / 16;
    const Eigen::Vector3d p =
        T_camera_part *
        Eigen::Vector3d(1.05 * outer * std::cos(angle), 1.05 * outer * std::sin(angle), face->z_m);
    if (p.z() < 0.05) return std::nullopt;
    box.extend(camera.project(p));
  }
  const int u0 = std::max(0, static_cast<int>(std::floor(box.min().x())));
  const int v0 = std::max(0, static_cast<int>(std::floor(box.min().y())));
  const int u1 = std::min(camera.width - 1, static_cast<int>(std::ceil(box.max().x())));
  const int v1 = std::min(camera.height - 1, static_cast<int>(std::ceil(box.max().y())));

  BoltLook look;
  look.bins.resize(static_cast<std::size_t>(kBinsOfPitch * holes_.count));
  look.pixel_m = distance / std::min(camera.fx, camera.fy);
  std::size_t readings = 0, before = 0;
  const Eigen::Matrix3d to_part = T_part_camera.linear();
  for (int v = v0; v <= v1; ++v)
    for (int u = u0; u <= u1; ++u) {
      const Eigen::Vector3d ray = to_part * camera.back_project(u, v, 1);  // a metre of depth
      const double depth = (face->z_m - eye.z()) / ray.z();
      const Eigen::Vector3d on_face = eye + depth * ray;
      const double r = on_face.head<2>().norm();
      // A ray along the face or away from it has no place on it; it may be no number.
      if (!(depth > 0) || !(std::abs(r - radius) <= half_width_m_)) continue;
      const auto count =
          frame.depth[static_cast<std::size_t>(v) * static_cast<std::size_t>(frame.width) +
                      static_cast<std::size_t>(u)];
      if (count == 0) continue;
      // How far the reading lies behind the face, along its normal.
      const double behind =
          (static_cast<double>(count) * camera.depth_unit_m - depth) * std::abs(ray.z());
      const double sigma = std::max(noise.axial_m(depth), 0.5 * camera.depth_unit_m);
      const double gate = std::max(kLeastThrough_m, kSolid * sigma);
      if (behind < -gate) {  // something stands before it
        ++before;
        continue;
      }
      const double turns = std::atan2(on_face.y(), on_face.x()) / (2 * kPi);
      const auto bins = static_cast<double>(look.bins.size());
      RingBin& bin = look.bins[static_cast<std::size_t>(
          std::min(bins - 1, (turns < 0 ? turns + 1 : turns) * bins))];
      bin.seen += 1;
      bin.through += behind > gate ? 1.0F : 0.0F;
      ++readings;
    }
  if (readings < kFewest ||
      static_cast<double>(before) > kMostBefore * static_cast<double>(readings + before))
    return std::nullopt;
  return look;
}

}  // namespace spool
