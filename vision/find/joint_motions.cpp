// Where the design would lie were one joint turned or one pipe too long.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/find/joint_motions.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>

#include "vision/core/parallel.h"
#include "vision/find/pose_search.h"

namespace spool {
namespace {

constexpr int kTurns = 120;  // of three degrees: a refinement reaches half of that
constexpr int kNoTurn = 2;   // the best pose itself and its flanks
constexpr int kSlides = 24;  // each way
constexpr float kLeastScore = 0.25F;
constexpr std::size_t kOfEachAxis = 3;

struct Scored {
  Eigen::Isometry3f T = Eigen::Isometry3f::Identity();
  float score = 0;
};

// The local maxima of a row of scores away from place `home`, highest first.
std::vector<Scored> peaks(const std::vector<Scored>& row, std::size_t home, std::size_t apart,
                          bool is_ring) {
  std::vector<Scored> some;
  const std::size_t n = row.size();
  for (std::size_t i = 0; i < n; ++i) {
    std::size_t away = i > home ? i - home : home - i;
    if (is_ring) away = std::min(away, n - away);
    if (away <= apart || row[i].score < kLeastScore) continue;
    const float before = i > 0 ? row[i - 1].score : (is_ring ? row[n - 1].score : 0.0F);
    const float after = i + 1 < n ? row[i + 1].score : (is_ring ? row[0].score : 0.0F);
    if (row[i].score > before && row[i].score >= after) some.push_back(row[i]);
  }
  std::stable_sort(some.begin(), some.end(),
                   [](const Scored& a, const Scored& b) { return a.score > b.score; });
  if (some.size() > kOfEachAxis) some.resize(kOfEachAxis);
  return some;
}

}  // namespace

std::vector<JointAxis> joint_axes(const DesignModel& design) {
  constexpr float kParallel = 0.9986F;  // cosine of three degrees
  const auto in_line = static_cast<float>(0.01 * design.bounds().diagonal().norm());
  std::vector<JointAxis> axes;
  for (const Joint& joint : design.joints) {
    const Part& part = design.parts[static_cast<std::size_t>(joint.part_a)];
    const Port& port = part.ports[static_cast<std::size_t>(joint.port_a)];
    const JointAxis axis{(part.T_design_part * port.position).cast<float>(),
                         (part.T_design_part.linear() * port.direction).cast<float>()};
    const bool known = std::any_of(axes.begin(), axes.end(), [&](const JointAxis& other) {
      return std::abs(other.direction.dot(axis.direction)) > kParallel &&
             (axis.point - other.point).cross(other.direction).norm() < in_line;
    });
    if (!known) axes.push_back(axis);
  }
  return axes;
}

std::vector<Eigen::Isometry3f> joint_motions(std::span<const JointAxis> axes,
                                             const Eigen::Isometry3f& T_design_scan,
                                             const Occupancy& occupancy,
                                             std::span<const Eigen::Vector3f> probes,
                                             double slide_m) {
  std::vector<std::vector<Scored>> found(axes.size());
  parallel_chunks(axes.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t a = begin; a < end; ++a) {
      const auto score = [&](const Eigen::Isometry3f& motion) {
        const Eigen::Isometry3f T = motion * T_design_scan;
        return Scored{T, pose_score(T, occupancy, probes)};
      };
      std::vector<Scored> turned, slid;
      for (int i = 0; i < kTurns; ++i) {
        const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(i) / kTurns;
        Eigen::Isometry3f motion = Eigen::Isometry3f::Identity();
        motion.linear() = Eigen::AngleAxisf(angle, axes[a].direction).toRotationMatrix();
        motion.translation() = axes[a].point - motion.linear() * axes[a].point;
        turned.push_back(score(motion));
      }
      for (int i = -kSlides; i <= kSlides; ++i) {
        const auto by = static_cast<float>(slide_m * i / kSlides);
        Eigen::Isometry3f motion = Eigen::Isometry3f::Identity();
        motion.translation() = by * axes[a].direction;
        slid.push_back(score(motion));
      }
      found[a] = peaks(turned, 0, kNoTurn, true);
      const std::vector<Scored> slides = peaks(slid, kSlides, 1, false);
      found[a].insert(found[a].end(), slides.begin(), slides.end());
    }
  });
  std::vector<Eigen::Isometry3f> motions;
  for (const std::vector<Scored>& some : found)
    for (const Scored& scored : some) motions.push_back(scored.T);
  return motions;
}

}  // namespace spool
