// The scan map as it should look from a place: one facet a pixel, for matching by projection.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/scan/map_view.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "vision/core/parallel.h"

namespace spool {
namespace {

constexpr float kNearest = 0.05F;  // m
constexpr float kFacing = 0.17F;   // cosine of 80 degrees: a moved camera may see it flatter
constexpr std::uint64_t kNothing = ~std::uint64_t{0};
constexpr std::size_t kCellBits = 12;

// Depth by three percent, then the better known first, then the place in the map.
std::uint64_t rank(float z, float count, std::size_t block, std::size_t cell) {
  const auto depth =
      static_cast<std::uint64_t>(std::clamp(33.0F * std::log(z / kNearest), 0.0F, 1023.0F));
  const auto doubt = static_cast<std::uint64_t>(255.0F - std::min(count, 255.0F));
  return depth << 54 | doubt << 46 | static_cast<std::uint64_t>(block) << kCellBits | cell;
}

void lower(std::atomic<std::uint64_t>& least, std::uint64_t value) {
  std::uint64_t now = least.load(std::memory_order_relaxed);
  while (value < now && !least.compare_exchange_weak(now, value, std::memory_order_relaxed)) {
  }
}

}  // namespace

Camera with_margin(const Camera& camera, int width) {
  Camera wide = camera;
  const double scale = static_cast<double>(width) / camera.width;
  const int margin_u = width / 8;
  const int height = std::max(1, static_cast<int>(std::lround(scale * camera.height)));
  const int margin_v = height / 8;
  wide.width = width + 2 * margin_u;
  wide.height = height + 2 * margin_v;
  wide.fx = camera.fx * scale;
  wide.fy = camera.fy * scale;
  // Pixel centres are at integers: the left edge of the picture is at -0.5.
  wide.cx = (camera.cx + 0.5) * scale - 0.5 + margin_u;
  wide.cy = (camera.cy + 0.5) * scale - 0.5 + margin_v;
  return wide;
}

MapView::MapView(const ScanMap& map, const Camera& camera, const Pose& T_map_view,
                 const std::vector<bool>& of)
    : camera_(camera),
      T_map_view_(T_map_view),
      facets_(static_cast<std::size_t>(camera.width) * static_cast<std::size_t>(camera.height)) {
  const Eigen::Matrix3f R = T_map_view.linear().transpose().cast<float>();
  const Eigen::Vector3f eye = T_map_view.translation().cast<float>();
  const auto fx = static_cast<float>(camera.fx), fy = static_cast<float>(camera.fy);
  const auto cx = static_cast<float>(camera.cx), cy = static_cast<float>(camera.cy);
  const auto& blocks = map.blocks();
  std::vector<std::atomic<std::uint64_t>> best(facets_.size());
  for (auto& each : best) each.store(kNothing, std::memory_order_relaxed);

  const auto in_view = [&](const MapBlock& block) {
    const Eigen::Vector3f middle = R * (block.box.center() - eye);
    const float radius = 0.5F * block.box.diagonal().norm();
    if (middle.z() < -radius) return false;
    const float z = std::max(middle.z() + radius, kNearest);
    // The widest the view gets within the block's depth.
    const auto far = [&](float across, float focal, float centre, int size) {
      const float low = -(centre + 0.5F) / focal * z;
      const float high = (static_cast<float>(size) - centre) / focal * z;
      return across + radius < low || across - radius > high;
    };
    return !far(middle.x(), fx, cx, camera.width) && !far(middle.y(), fy, cy, camera.height);
  };
  constexpr std::size_t kGrain = 64;  // blocks
  parallel_chunks(blocks.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b) {
      const MapBlock& block = blocks[b];
      if (block.voxel <= 0 || !in_view(block)) continue;
      for (std::size_t c = 0; c < block.cells.size(); ++c) {
        const MapCell& cell = block.cells[c];
        if (!map.is_settled(cell)) continue;
        if (!of.empty() && (cell.keyframe >= of.size() || !of[cell.keyframe])) continue;
        const Eigen::Vector3f to_cell = cell.mean - eye;
        const Eigen::Vector3f point = R * to_cell;
        if (!(point.z() > kNearest)) continue;
        if (-cell.normal.dot(to_cell) < kFacing * to_cell.norm()) continue;
        const int u = static_cast<int>(std::lround(fx * point.x() / point.z() + cx));
        const int v = static_cast<int>(std::lround(fy * point.y() / point.z() + cy));
        if (u < 0 || v < 0 || u >= camera.width || v >= camera.height) continue;
        lower(best[static_cast<std::size_t>(v * camera.width + u)],
              rank(point.z(), cell.count, b, c));
      }
    }
  });
  for (std::size_t i = 0; i < facets_.size(); ++i) {
    const std::uint64_t key = best[i].load(std::memory_order_relaxed);
    if (key == kNothing) continue;
    const std::uint64_t place = key & ((std::uint64_t{1} << 46) - 1);
    const MapCell& cell =
        blocks[place >> kCellBits].cells[place & ((std::uint64_t{1} << kCellBits) - 1)];
    facets_[i] = {R * (cell.mean - eye), R * cell.normal, cell.variance(), cell.size,
                  cell.keyframe};
    ++facet_count_;
  }
}

}  // namespace spool
