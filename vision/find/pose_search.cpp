// Poses that may be right: pairs of scan elements laid on pairs of the design, tried on the scan.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/find/pose_search.h"

#include <algorithm>
#include <optional>
#include <random>

#include "vision/core/parallel.h"

namespace spool {
namespace {

constexpr std::size_t kPairsPerChunk = 32;
constexpr int kPartnerTries = 64;
// Wald's sequential test (WaldSAC, Chum & Matas 2008): a wrong pose finds a scan point near one
// design sample in five, a right one near half of them; what is a hundred times likelier wrong
// is dropped.
constexpr float kHit = 0.916F;    // log(0.5 / 0.2)
constexpr float kMiss = -0.470F;  // log(0.5 / 0.8)
constexpr float kDrop = -4.6F;    // log(1 / 100)

// The score, or nothing where the test gave up.
std::optional<float> sequential_score(const Eigen::Isometry3f& T_scan_design,
                                      const Occupancy& occupancy,
                                      std::span<const Eigen::Vector3f> samples) {
  float evidence = 0;
  std::size_t hits = 0;
  const Eigen::Matrix3f R = T_scan_design.linear();
  const Eigen::Vector3f t = T_scan_design.translation();
  for (const Eigen::Vector3f& sample : samples) {
    const bool hit = occupancy.is_near(R * sample + t);
    hits += hit ? 1U : 0U;
    evidence += hit ? kHit : kMiss;
    if (evidence < kDrop) return std::nullopt;
  }
  return static_cast<float>(hits) / static_cast<float>(samples.size());
}

void keep_best(std::vector<PoseHypothesis>& hypotheses, std::size_t count) {
  std::stable_sort(
      hypotheses.begin(), hypotheses.end(),
      [](const PoseHypothesis& a, const PoseHypothesis& b) { return a.score > b.score; });
  if (hypotheses.size() > count) hypotheses.resize(count);
}

}  // namespace

float pose_score(const Eigen::Isometry3f& T_design_scan, const Occupancy& occupancy,
                 std::span<const Eigen::Vector3f> samples) {
  const Eigen::Isometry3f T = T_design_scan.inverse();
  std::size_t hits = 0;
  for (const Eigen::Vector3f& sample : samples) hits += occupancy.is_near(T * sample) ? 1U : 0U;
  return samples.empty() ? 0.0F : static_cast<float>(hits) / static_cast<float>(samples.size());
}

std::vector<PoseHypothesis> search_poses(const PairTable& table, std::span<const Element> scan,
                                         const Occupancy& occupancy,
                                         std::span<const Eigen::Vector3f> samples,
                                         const PoseSearchOptions& options, const Watch& watch) {
  if (table.empty() || scan.size() < 2 || samples.empty()) return {};
  const std::size_t chunks = (options.pairs + kPairsPerChunk - 1) / kPairsPerChunk;
  std::vector<std::vector<PoseHypothesis>> found(chunks);
  parallel_chunks(chunks, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t chunk = begin; chunk < end; ++chunk) {
      std::mt19937_64 random(options.seed * 0x9E3779B97F4A7C15U + chunk);
      for (std::size_t pair = 0; pair < kPairsPerChunk; ++pair) {
        if (watch.cancelled()) return;
        const Element& a = scan[random() % scan.size()];
        std::optional<PairFrame> frame;
        for (int t = 0; t < kPartnerTries && !frame; ++t) {
          const Element& b = scan[random() % scan.size()];
          const float distance = (b.point - a.point).norm();
          if (distance >= table.least_distance() && distance <= table.most_distance())
            frame = pair_frame(a, b);
        }
        if (!frame) continue;
        const std::size_t count = table.count(*frame);
        for (std::size_t n = 0; n < count; ++n) {
          const Eigen::Isometry3f T = table.pose(*frame, n);
          const std::optional<float> score = sequential_score(T.inverse(), occupancy, samples);
          if (score && *score >= options.least_score)
            found[chunk].push_back({T, *score, static_cast<std::uint32_t>(chunk)});
        }
      }
      keep_best(found[chunk], options.keep);
    }
  });
  std::vector<PoseHypothesis> all;
  for (const auto& some : found) all.insert(all.end(), some.begin(), some.end());
  keep_best(all, all.size());
  return all;
}

}  // namespace spool
