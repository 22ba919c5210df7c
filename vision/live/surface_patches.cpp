// The design's outside cut into patches.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/live/surface_patches.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

#include "vision/scan/point_spacing.h"

namespace spool {
namespace {

constexpr float kAlike = 0.7F;  // cosine; patches do not reach round an edge
constexpr double kStepDown = 0.7, kStepUp = 1.05;
constexpr double kPi = std::numbers::pi;

using Cell = std::tuple<int, int, int>;

Cell cell_of(const Eigen::Vector3f& p, float size) {
  return {static_cast<int>(std::floor(p.x() / size)), static_cast<int>(std::floor(p.y() / size)),
          static_cast<int>(std::floor(p.z() / size))};
}

// Samples of one part, no two that look the same way nearer than `pitch`, every other one near one.
std::vector<std::size_t> middles_of(const SurfaceSamples& samples,
                                    const std::vector<std::size_t>& of_part, float pitch) {
  const bool has_normals = samples.cloud.has_normals();
  const auto& points = samples.cloud.points;
  std::map<Cell, std::vector<std::size_t>> near;
  std::vector<std::size_t> middles;
  for (const std::size_t i : of_part) {
    const auto [x, y, z] = cell_of(points[i], pitch);
    bool is_taken = false;
    for (int n = 0; n < 27 && !is_taken; ++n) {
      const auto found = near.find({x + n % 3 - 1, y + n / 3 % 3 - 1, z + n / 9 - 1});
      if (found == near.end()) continue;
      is_taken = std::ranges::any_of(found->second, [&](std::size_t k) {
        return (points[k] - points[i]).squaredNorm() < pitch * pitch &&
               (!has_normals || samples.cloud.normals[k].dot(samples.cloud.normals[i]) > kAlike);
      });
    }
    if (is_taken) continue;
    near[{x, y, z}].push_back(i);
    middles.push_back(i);
  }
  return middles;
}

}  // namespace

std::shared_ptr<const SurfacePatches> SurfacePatches::cut(const SurfaceSamples& samples,
                                                          std::size_t parts,
                                                          const SurfacePatchOptions& options) {
  std::shared_ptr<SurfacePatches> made(new SurfacePatches);
  made->parts_ = parts;
  if (samples.cloud.empty()) return made;
  const auto& points = samples.cloud.points;
  const bool has_normals = samples.cloud.has_normals();
  const PointIndex plain(points);
  const std::size_t step = points.size() / 2000 + 1;
  const double apart = point_spacing(plain, points, step, static_cast<float>(options.pitch_m * 10));

  std::vector<std::vector<std::size_t>> of_part(parts);
  for (std::size_t i = 0; i < points.size(); ++i)
    of_part[static_cast<std::size_t>(samples.part[i])].push_back(i);
  // Four of them, itself counted, lie in the disc out to the fourth.
  const auto a_sample_m2 = static_cast<float>(kPi * apart * apart / 4);
  double pitch = std::max(options.pitch_m, apart);
  std::vector<std::vector<std::size_t>> middles(parts);
  std::vector<double> pitches(parts);
  for (std::size_t count = options.most + 1; count > options.most;) {
    count = 0;
    for (std::size_t part = 0; part < parts; ++part) {
      double finer = pitch;
      middles[part] = middles_of(samples, of_part[part], static_cast<float>(finer));
      while (middles[part].size() < options.fewest_a_part && kStepDown * finer > apart) {
        finer *= kStepDown;
        middles[part] = middles_of(samples, of_part[part], static_cast<float>(finer));
      }
      pitches[part] = finer;
      count += middles[part].size();
    }
    // Patches go by the area, unless there are many small parts.
    const double share = static_cast<double>(count) / static_cast<double>(options.most);
    if (share > 1) pitch *= kStepUp * std::sqrt(share);
    if (pitch > 100 * options.pitch_m) break;  // more parts than patches: one a part is the least
  }

  made->lift_m_ = has_normals ? static_cast<float>(0.5 * pitch) : 0.0F;
  made->reach_m_ = static_cast<float>(3 * apart);
  made->patch_of_.resize(points.size());
  made->lifted_ = points;
  if (has_normals)
    for (std::size_t i = 0; i < points.size(); ++i)
      made->lifted_[i] += made->lift_m_ * samples.cloud.normals[i];
  for (std::size_t part = 0; part < parts; ++part) {
    std::vector<Eigen::Vector3f> lifted;
    const auto first = static_cast<std::uint32_t>(made->patches_.size());
    for (const std::size_t i : middles[part]) {
      lifted.push_back(made->lifted_[i]);
      made->patches_.push_back(
          {points[i], has_normals ? samples.cloud.normals[i] : Eigen::Vector3f::Zero(),
           static_cast<std::int32_t>(part), static_cast<float>(pitches[part]), 0.0F});
    }
    const PointIndex index(lifted);
    const auto far = static_cast<float>(10 * pitch);
    for (const std::size_t i : of_part[part]) {
      const auto nearest = index.nearest(made->lifted_[i], far);
      made->patch_of_[i] = first + (nearest ? nearest->index : 0U);
      made->patches_[made->patch_of_[i]].area_m2 += a_sample_m2;
    }
  }
  made->index_ = PointIndex(made->lifted_);
  return made;
}

std::optional<std::uint32_t> SurfacePatches::at(const Eigen::Vector3f& point,
                                                const Eigen::Vector3f& normal) const {
  const auto nearest = index_.nearest(point + lift_m_ * normal, reach_m_ + 0.5F * lift_m_);
  if (!nearest) return std::nullopt;
  return patch_of_[nearest->index];
}

}  // namespace spool
