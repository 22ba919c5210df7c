// Which facet of the map a frame's reading lies on, by projection into a view of the map.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/align/map_matcher.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "vision/core/parallel.h"

namespace spool {
namespace {

constexpr std::size_t kGrain = 512;
constexpr float kAlike = 0.6F;    // cosine: noisy normals of one surface differ by less
constexpr float kTukey = 4.685F;  // 95 % efficiency for Gaussian noise
constexpr float kSigmas = 3.0F;
constexpr int kVouchWindow = 2;  // px of the view
constexpr unsigned kAllQuadrants = 0b1111;
constexpr float kBeside = 1.5F;  // cell sizes: as far from a cell's middle its plane may be used

// The camera as the view's camera sees it, and the view's lens.
struct Into {
  Eigen::Matrix3f R_view_camera, R_map_view;
  Eigen::Vector3f t_view_camera;
  float fx, fy, cx, cy;
  int width, height;

  Into(const MapView& view, const Pose& T_map_camera) {
    const Pose T = view.T_map_view().inverse() * T_map_camera;
    R_view_camera = T.linear().cast<float>();
    t_view_camera = T.translation().cast<float>();
    R_map_view = view.T_map_view().linear().cast<float>();
    const Camera& camera = view.camera();
    fx = static_cast<float>(camera.fx);
    fy = static_cast<float>(camera.fy);
    cx = static_cast<float>(camera.cx);
    cy = static_cast<float>(camera.cy);
    width = camera.width;
    height = camera.height;
  }
};

struct Found {
  const MapFacet* facet = nullptr;     // nearest that looks the same way, within reach
  const MapFacet* expected = nullptr;  // nearest of all in the window
  unsigned quadrants = 0;              // of the window in which there is a facet
  Eigen::Vector3f point, normal;       // the sample, view frame
};

Found find_facet(const FrameSample& sample, const MapView& view, const Into& into, int window,
                 float reach) {
  Found found;
  found.point = into.R_view_camera * sample.point + into.t_view_camera;
  found.normal = into.R_view_camera * sample.normal;
  if (!(found.point.z() > 0)) return found;
  const int u =
      static_cast<int>(std::lround(into.fx * found.point.x() / found.point.z() + into.cx));
  const int v =
      static_cast<int>(std::lround(into.fy * found.point.y() / found.point.z() + into.cy));
  float nearest = std::numeric_limits<float>::max();
  float nearest_any = nearest;
  for (int y = std::max(0, v - window); y <= std::min(into.height - 1, v + window); ++y)
    for (int x = std::max(0, u - window); x <= std::min(into.width - 1, u + window); ++x) {
      const MapFacet& facet = view.at(x, y);
      if (facet.size <= 0) continue;
      found.quadrants |= 1U << ((x > u ? 1 : 0) + (y > v ? 2 : 0));
      const float distance = (facet.point - found.point).squaredNorm();
      if (distance < nearest_any) {
        nearest_any = distance;
        found.expected = &facet;
      }
      const float far = reach + kBeside * facet.size;
      if (distance >= nearest || distance > far * far) continue;
      if (facet.normal.dot(found.normal) < kAlike) continue;
      nearest = distance;
      found.facet = &facet;
    }
  return found;
}

// Point, normal and residual of a match, in the axes of the map about the view's eye.
Correspondence paired(const Found& found, const MapFacet& facet, const Into& into) {
  Correspondence match;
  const Eigen::Vector3f normal = (found.normal + facet.normal).normalized();
  match.residual = normal.dot(found.point - facet.point);
  match.point = into.R_map_view * found.point;
  match.normal = into.R_map_view * normal;
  return match;
}

}  // namespace

std::vector<Correspondence> match_to_view(const FrameSamples& frame, const MapView& view,
                                          const Pose& T_map_camera, const MatchReach& reach) {
  const Into into(view, T_map_camera);
  std::vector<Correspondence> matches((frame.samples.size() + reach.every - 1) / reach.every);
  const auto unit = static_cast<float>(frame.variance);
  parallel_chunks(matches.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const FrameSample& sample = frame.samples[i * reach.every];
      const Found found = find_facet(sample, view, into, reach.window_px, reach.gate_m);
      if (found.facet == nullptr) continue;
      Correspondence match = paired(found, *found.facet, into);
      const float variance = sample.variance + found.facet->variance;
      const float width = std::max(kTukey * std::sqrt(variance), reach.gate_m);
      const float share = match.residual * match.residual / (width * width);
      if (share >= 1) continue;
      match.weight = (1 - share) * (1 - share) * unit / variance;
      matches[i] = match;
    }
  });
  return matches;
}

Vouching vouch_for(const FrameSamples& frame, const MapView& view, const Pose& T_map_camera) {
  const Into into(view, T_map_camera);
  Vouching all;
  all.matches.resize(frame.samples.size());
  all.says.assign(frame.samples.size(), Vouch::kUnknown);
  std::vector<KeyframeId> keyframes(frame.samples.size());
  parallel_chunks(all.matches.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const FrameSample& sample = frame.samples[i];
      const float noise = kSigmas * std::sqrt(sample.variance);
      const Found found = find_facet(sample, view, into, kVouchWindow, noise);
      if (found.facet != nullptr) {
        all.matches[i] = paired(found, *found.facet, into);
        const float variance = sample.variance + found.facet->variance;
        const float off = all.matches[i].residual;
        all.matches[i].weight = 1;
        if (off * off < kSigmas * kSigmas * variance) {
          all.says[i] = Vouch::kAgrees;
          keyframes[i] = found.facet->keyframe;
          continue;
        }
        all.says[i] = off > 0 ? Vouch::kInFront : Vouch::kContradicts;
        continue;
      }
      // Beside the rim of something nearer, what is seen for the first time contradicts nothing:
      // the map has to know a surface all round the place.
      if (found.quadrants != kAllQuadrants) continue;
      // Near a surface that looks another way: an edge, which says nothing.
      const float far = noise + kBeside * found.expected->size;
      if ((found.expected->point - found.point).squaredNorm() < far * far) continue;
      // By its own normal it would have seen any motion that moves it off that surface.
      all.matches[i].point = into.R_map_view * found.point;
      all.matches[i].normal = into.R_map_view * found.normal;
      all.matches[i].residual = found.point.z() - found.expected->point.z();
      all.matches[i].weight = 1;
      all.says[i] =
          found.point.z() < found.expected->point.z() ? Vouch::kInFront : Vouch::kContradicts;
    }
  });
  std::vector<std::size_t> counts;
  for (std::size_t i = 0; i < all.says.size(); ++i) {
    if (all.says[i] == Vouch::kAgrees) {
      if (counts.size() <= keyframes[i]) counts.resize(keyframes[i] + std::size_t{1});
      ++counts[keyframes[i]];
    }
    all.agrees += all.says[i] == Vouch::kAgrees ? 1U : 0U;
    all.contradicts += all.says[i] == Vouch::kContradicts ? 1U : 0U;
    all.in_front += all.says[i] == Vouch::kInFront ? 1U : 0U;
  }
  for (std::size_t k = 0; k < counts.size(); ++k)
    if (counts[k] > 0) all.shares.push_back({static_cast<KeyframeId>(k), counts[k]});
  return all;
}

}  // namespace spool
