// The camera of a BCF viewpoint: metres, z up, from where a picture of the report is seen.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/ncr/bcf_viewpoint.h"

#include <cmath>
#include <sstream>

namespace spool::ncr {

Eigen::Vector3d z_up(const Eigen::Vector3d& design) {
  return {design.x(), -design.z(), design.y()};
}

std::optional<Eigen::Vector3d> eye_side(const std::string& caption) {
  constexpr std::string_view kStart = "seen from ";
  if (!caption.starts_with(kStart)) return std::nullopt;
  std::istringstream words(caption.substr(kStart.size()));
  Eigen::Vector3d side = Eigen::Vector3d::Zero();
  for (std::string word; words >> word;) {
    if (word.size() != 2 || (word[0] != '+' && word[0] != '-') || word[1] < 'x' || word[1] > 'z')
      return std::nullopt;
    side[word[1] - 'x'] = word[0] == '+' ? 1 : -1;
  }
  if (side.isZero()) return std::nullopt;
  return side.normalized();
}

BcfCamera camera_at(const Eigen::AlignedBox3d& bounds, const Eigen::Vector3d& side) {
  // The sphere round the box fits a picture that is at least square.
  const bool is_empty = bounds.isEmpty();
  const Eigen::Vector3d centre =
      is_empty ? Eigen::Vector3d::Zero() : Eigen::Vector3d(bounds.center());
  constexpr double kLeast_m = 0.05;
  const double radius = std::max(kLeast_m, is_empty ? 0.0 : 0.5 * bounds.diagonal().norm());
  const double distance = radius / std::sin(0.5 * kFieldOfView_deg * M_PI / 180);
  BcfCamera camera;
  camera.view_point = z_up(centre + distance * side);
  camera.direction = z_up(-side);
  // Straight from above or below, north is up.
  const Eigen::Vector3d up =
      std::abs(camera.direction.z()) > 0.999 ? Eigen::Vector3d::UnitY() : Eigen::Vector3d::UnitZ();
  camera.up = (up - up.dot(camera.direction) * camera.direction).normalized();
  return camera;
}

}  // namespace spool::ncr
