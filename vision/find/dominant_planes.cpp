// Floor, walls, table tops: planes larger than the design.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/find/dominant_planes.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "vision/core/parallel.h"
#include "vision/scan/point_index.h"
#include "vision/scan/point_spacing.h"
#include "vision/scan/thinning.h"

namespace spool {
namespace {

constexpr std::size_t kMostPatches = 60000;  // a hall many times the design's size: coarser
constexpr int kTries = 150;
constexpr float kCosine = 0.9F;  // a patch's normal to its plane's: 26 degrees

struct Patches {
  std::vector<Eigen::Vector3f> points, normals;
  float cell = 0;  // m
};

// The scan thinned to a size at which floor and walls are plain, with normals.
Patches patches_of(std::span<const Eigen::Vector3f> points, double size_m, const Watch& watch) {
  Patches patches;
  for (double cell = size_m / 40;; cell *= 2) {
    patches.cell = static_cast<float>(cell);
    patches.points = thin_to_voxels(CloudView(points), cell).points;
    if (patches.points.size() <= kMostPatches || watch.cancelled()) break;
  }
  patches.normals.assign(patches.points.size(), Eigen::Vector3f::Zero());
  const PointIndex index(patches.points);
  // As far apart as the points are where the scan is sparser than the cells.
  patches.cell = std::max(
      patches.cell,
      point_spacing(index, patches.points, patches.points.size() / 500 + 1, 8 * patches.cell));
  parallel_chunks(patches.points.size(), 1024, [&](std::size_t begin, std::size_t end) {
    if (watch.cancelled()) return;
    std::vector<Neighbour> near;
    for (std::size_t i = begin; i < end; ++i) {
      index.nearest_k(patches.points[i], 12, 4 * patches.cell, near);
      if (near.size() < 6) continue;
      Eigen::Vector3f mean = Eigen::Vector3f::Zero();
      for (const Neighbour& n : near) mean += patches.points[n.index] - patches.points[i];
      mean /= static_cast<float>(near.size());
      Eigen::Matrix3f scatter = Eigen::Matrix3f::Zero();
      for (const Neighbour& n : near) {
        const Eigen::Vector3f d = patches.points[n.index] - patches.points[i] - mean;
        scatter.noalias() += d * d.transpose();
      }
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> axes;
      axes.computeDirect(scatter);
      if (axes.eigenvalues()[0] < 0.1F * axes.eigenvalues()[1])
        patches.normals[i] = axes.eigenvectors().col(0);
    }
  });
  return patches;
}

bool lies_on(const Patches& patches, std::uint32_t i, const DominantPlane& plane, float band) {
  return std::abs(plane.distance(patches.points[i])) < band &&
         std::abs(plane.normal.dot(patches.normals[i])) > kCosine;
}

std::vector<std::uint32_t> members(const Patches& patches, const std::vector<std::uint32_t>& left,
                                   const DominantPlane& plane, float band) {
  std::vector<std::uint32_t> on;
  for (const std::uint32_t i : left)
    if (lies_on(patches, i, plane, band)) on.push_back(i);
  return on;
}

// Least squares through the patches.
DominantPlane plane_through(const Patches& patches, const std::vector<std::uint32_t>& on) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const std::uint32_t i : on) mean += patches.points[i].cast<double>();
  mean /= static_cast<double>(on.size());
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const std::uint32_t i : on) {
    const Eigen::Vector3d d = patches.points[i].cast<double>() - mean;
    scatter.noalias() += d * d.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(scatter);
  DominantPlane plane;
  plane.normal = axes.eigenvectors().col(0).cast<float>();
  plane.offset = static_cast<float>(axes.eigenvectors().col(0).dot(mean));
  plane.points = on.size();
  return plane;
}

// The largest set of patches that hang together (neighbours within two cells and a half).
std::vector<std::uint32_t> largest_piece(const Patches& patches,
                                         const std::vector<std::uint32_t>& on) {
  std::vector<Eigen::Vector3f> points;
  points.reserve(on.size());
  for (const std::uint32_t i : on) points.push_back(patches.points[i]);
  const PointIndex index(points);
  std::vector<int> piece(on.size(), -1);
  std::vector<std::uint32_t> best, now;
  std::vector<Neighbour> near;
  int pieces = 0;
  for (std::uint32_t start = 0; start < on.size(); ++start) {
    if (piece[start] >= 0) continue;
    now.assign(1, start);
    piece[start] = pieces;
    for (std::size_t at = 0; at < now.size(); ++at) {
      index.within(points[now[at]], 2.5F * patches.cell, near);
      for (const Neighbour& n : near)
        if (piece[n.index] < 0) {
          piece[n.index] = pieces;
          now.push_back(n.index);
        }
    }
    ++pieces;
    if (now.size() > best.size()) best = now;
  }
  for (std::uint32_t& i : best) i = on[i];
  return best;
}

// Near the patches: within four cells, across holes that the scan left and corners that have no
// normal.
Occupancy patch_of(const Patches& patches, const std::vector<std::uint32_t>& piece) {
  std::vector<Eigen::Vector3f> points;
  points.reserve(piece.size());
  for (const std::uint32_t i : piece) points.push_back(patches.points[i]);
  return Occupancy(points, 4.0 * double{patches.cell});
}

// Longer than the design, by more than the patches' own size, and at least half as wide. Measured
// from end to end: by its spread a frame's face would seem longer than it is.
bool is_larger_than(const Patches& patches, const std::vector<std::uint32_t>& on, double size_m) {
  if (on.size() < 12) return false;
  Eigen::Vector3f mean = Eigen::Vector3f::Zero();
  for (const std::uint32_t i : on) mean += patches.points[i] / static_cast<float>(on.size());
  Eigen::Matrix3f scatter = Eigen::Matrix3f::Zero();
  for (const std::uint32_t i : on) {
    const Eigen::Vector3f d = patches.points[i] - mean;
    scatter.noalias() += d * d.transpose();
  }
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> axes;
  axes.computeDirect(scatter / static_cast<float>(on.size()));
  Eigen::AlignedBox3f box;
  for (const std::uint32_t i : on)
    box.extend(axes.eigenvectors().transpose() * (patches.points[i] - mean));
  return box.sizes()[2] > size_m + 2 * double{patches.cell} && box.sizes()[1] > 0.5 * size_m;
}

}  // namespace

std::vector<DominantPlane> dominant_planes(std::span<const Eigen::Vector3f> points,
                                           const DominantPlaneOptions& options,
                                           const Watch& watch) {
  std::vector<DominantPlane> planes;
  const Patches patches = patches_of(points, options.size_m, watch);
  std::vector<std::uint32_t> left;
  for (std::uint32_t i = 0; i < patches.points.size(); ++i)
    if (patches.normals[i].squaredNorm() > 0.5F) left.push_back(i);
  // A patch's middle is a mean of several points; the floor itself is flat to some millimetres.
  const auto band = static_cast<float>(std::max(3 * options.noise_m, 0.01 * options.size_m));
  std::mt19937 random(options.seed);
  int misses = 0;
  while (static_cast<int>(planes.size()) < options.max_planes && misses < 4 && left.size() > 100 &&
         !watch.cancelled()) {
    DominantPlane best;
    const std::size_t step = left.size() / 2500 + 1;  // so many say which plane is largest
    for (int t = 0; t < kTries && !watch.cancelled(); ++t) {
      const std::uint32_t seed = left[random() % left.size()];
      DominantPlane plane{patches.normals[seed], patches.normals[seed].dot(patches.points[seed]),
                          0};
      for (std::size_t i = 0; i < left.size(); i += step)
        if (lies_on(patches, left[i], plane, band)) ++plane.points;
      if (plane.points > best.points) best = plane;
    }
    std::vector<std::uint32_t> on = members(patches, left, best, band);
    for (int round = 0; round < 3 && on.size() > 12; ++round) {
      best = plane_through(patches, on);
      on = members(patches, left, best, band);
    }
    const std::vector<std::uint32_t> piece = largest_piece(patches, on);
    const bool is_large = is_larger_than(patches, piece, options.size_m);
    if (is_large) {
      planes.push_back(plane_through(patches, piece));
      planes.back().patch = patch_of(patches, piece);
    } else {
      ++misses;  // the largest that was left; a few more may be longer, if sparser
    }
    const std::vector<std::uint32_t>& gone = is_large ? on : piece;
    std::vector<std::uint8_t> drop(patches.points.size(), 0);
    for (const std::uint32_t i : gone) drop[i] = 1;
    std::erase_if(left, [&](std::uint32_t i) { return drop[i] != 0; });
    if (gone.empty()) break;
  }
  std::stable_sort(
      planes.begin(), planes.end(),
      [](const DominantPlane& a, const DominantPlane& b) { return a.points > b.points; });
  return planes;
}

std::vector<Eigen::Vector3f> off_planes(std::span<const Eigen::Vector3f> points,
                                        std::span<const DominantPlane> planes, double band_m) {
  const auto band = static_cast<float>(band_m);
  std::vector<Eigen::Vector3f> off;
  for (const Eigen::Vector3f& point : points) {
    const bool is_on = std::any_of(planes.begin(), planes.end(), [&](const DominantPlane& plane) {
      return plane.holds(point, band);
    });
    if (!is_on) off.push_back(point);
  }
  return off;
}

}  // namespace spool
