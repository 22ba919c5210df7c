// A design's signed distance as a volume: cubes are divided level by level while they are off.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/design/distance_field.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "vision/core/parallel.h"
#include "vision/design/distance_brick.h"

namespace spool {
namespace {

constexpr float kGridCell = 0.128F;  // m; halved five times its cells measure a millimetre
constexpr int kBricksASide = DistanceVolume::kLargestSide / DistanceVolume::kBrickTexels;
constexpr std::size_t kFineSide = 2 * kBrickSide - 1;  // texels of a brick divided
using FineTexels = std::array<DistanceSample, kFineSide * kFineSide * kFineSide>;
using Block = std::array<std::uint32_t, 8>;

struct Cube {
  Eigen::Vector3f lowest;  // m
  std::size_t block = 0;   // its word: of the grid where there is no block above
  std::size_t octant = 0;
  BrickTexels texels;
};

std::size_t at(std::size_t side, std::size_t x, std::size_t y, std::size_t z) {
  return (z * side + y) * side + x;
}

Eigen::Vector3f steps(std::size_t x, std::size_t y, std::size_t z) {
  return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)};
}

// Whether the surface may pass between texels; two pieces are not told apart there.
bool holds_surface(const BrickTexels& texels, float spacing_m) {
  return std::any_of(texels.begin(), texels.end(), [&](const DistanceSample& sample) {
    return std::abs(sample.distance_m) <= kHalfDiagonal * spacing_m;
  });
}

class Builder {
 public:
  Builder(const DesignSurface& surface, const DistanceFieldOptions& options, const Watch& watch)
      : surface_(surface), options_(options), watch_(watch) {}

  [[nodiscard]] std::optional<DistanceVolume> build(const Eigen::AlignedBox3d& bounds);

 private:
  // The distance at a place that is nearer to the surface than `within`.
  [[nodiscard]] DistanceSample sample(const Eigen::Vector3f& place, float within) const;
  [[nodiscard]] bool is_finest() const { return spacing_m_ < 1.5F * options_.finest_m; }
  [[nodiscard]] std::vector<Cube> first_cubes() const;
  void measure(const Cube& cube, BrickMiddles& middles) const;
  [[nodiscard]] std::vector<std::size_t> to_divide(const std::vector<DistanceBrick>& bricks) const;
  [[nodiscard]] std::vector<Cube> divide(const std::vector<Cube>& cubes,
                                         const std::vector<BrickMiddles>& middles,
                                         const std::vector<std::size_t>& which);
  void set_word(const Cube& cube, std::uint32_t word) {
    (cube.block == kNoBlock ? volume_.grid.data[cube.octant] : blocks_[cube.block][cube.octant]) =
        word;
  }
  void lay_out();

  static constexpr std::size_t kNoBlock = static_cast<std::size_t>(-1);
  const DesignSurface& surface_;
  const DistanceFieldOptions& options_;
  const Watch& watch_;
  DistanceVolume volume_;
  float spacing_m_ = 0;  // of the texels of this level
  std::vector<Block> blocks_;
  std::vector<DistanceBrick> bricks_;
};

DistanceSample Builder::sample(const Eigen::Vector3f& place, float within) const {
  const auto nearest = surface_.closest(place, 1.0001F * within + 1e-6F);
  if (!nearest) return {within, Eigen::Vector3f::Zero()};
  const Eigen::Vector3f away = place - nearest->point;
  const float length = away.norm();
  if (length < 1e-6F) return {nearest->distance, nearest->normal};
  return {nearest->distance, std::copysign(1 / length, nearest->distance) * away};
}

std::vector<Cube> Builder::first_cubes() const {
  const auto& size = volume_.grid.size;
  const float reach = options_.band_m + kHalfDiagonal * volume_.cell_m;
  const auto lowest_of = [&](std::size_t number) -> Eigen::Vector3f {
    const int n = static_cast<int>(number);
    const Eigen::Vector3i place(n % size[0], n / size[0] % size[1], n / (size[0] * size[1]));
    return volume_.lowest + volume_.cell_m * place.cast<float>();
  };
  const Eigen::Vector3f to_middle = Eigen::Vector3f::Constant(0.5F * volume_.cell_m);
  std::vector<float> far(volume_.grid.data.size(),
                         reach);  // of each cube's middle from the surface
  parallel_chunks(far.size(), 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end && !watch_.cancelled(); ++n)
      if (const auto nearest = surface_.closest(lowest_of(n) + to_middle, reach))
        far[n] = std::abs(nearest->distance);
  });
  std::vector<Cube> cubes;
  for (std::size_t n = 0; n < far.size(); ++n) {
    if (!(far[n] < reach)) continue;
    Cube& cube = cubes.emplace_back();
    cube.lowest = lowest_of(n);
    cube.block = kNoBlock;
    cube.octant = n;
  }
  parallel_chunks(cubes.size(), 1, [&](std::size_t c, std::size_t) {
    if (watch_.cancelled()) return;
    Cube& cube = cubes[c];
    for (std::size_t k = 0; k < kBrickSide; ++k)
      for (std::size_t j = 0; j < kBrickSide; ++j)
        for (std::size_t i = 0; i < kBrickSide; ++i) {
          const Eigen::Vector3f offset = spacing_m_ * steps(i, j, k);
          cube.texels[at(kBrickSide, i, j, k)] =
              sample(cube.lowest + offset, far[cube.octant] + (offset - to_middle).norm());
        }
  });
  return cubes;
}

void Builder::measure(const Cube& cube, BrickMiddles& middles) const {
  std::size_t n = 0;
  for (std::size_t k = 0; k < kBrickCells; ++k)
    for (std::size_t j = 0; j < kBrickCells; ++j)
      for (std::size_t i = 0; i < kBrickCells; ++i) {
        float nearest = std::numeric_limits<float>::infinity();
        for (std::size_t c = 0; c < 8; ++c)
          nearest = std::min(
              nearest,
              std::abs(cube.texels[at(kBrickSide, i + (c & 1U), j + (c >> 1U & 1U), k + (c >> 2U))]
                           .distance_m));
        const Eigen::Vector3f place =
            cube.lowest + 0.5F * spacing_m_ * steps(2 * i + 1, 2 * j + 1, 2 * k + 1);
        middles[n++] = sample(place, nearest + kHalfDiagonal * spacing_m_);
      }
}

// Those that are off, in their order; the worst ones where not all of them may be divided.
std::vector<std::size_t> Builder::to_divide(const std::vector<DistanceBrick>& bricks) const {
  std::vector<std::size_t> which;
  if (is_finest()) return which;
  for (std::size_t c = 0; c < bricks.size(); ++c)
    if (bricks[c].error_m > options_.tolerance_m) which.push_back(c);
  const std::size_t used = bricks_.size() + bricks.size();
  const std::size_t most = used < options_.most_bricks ? (options_.most_bricks - used) / 7 : 0;
  if (which.size() <= most) return which;
  std::stable_sort(which.begin(), which.end(), [&](std::size_t a, std::size_t b) {
    return bricks[a].error_m > bricks[b].error_m;
  });
  which.resize(most);
  std::sort(which.begin(), which.end());
  return which;
}

// The eighths of cubes that come within the band. Half their texels were measured already.
std::vector<Cube> Builder::divide(const std::vector<Cube>& cubes,
                                  const std::vector<BrickMiddles>& middles,
                                  const std::vector<std::size_t>& which) {
  const float side_m = spacing_m_ * static_cast<float>(kBrickCells);
  const float reach = options_.band_m + 0.5F * kHalfDiagonal * side_m;
  const std::size_t first_block = blocks_.size();
  std::vector<Cube> eighths;
  std::vector<std::size_t> begins{0};
  for (const std::size_t c : which) {
    for (std::size_t octant = 0; octant < 8; ++octant) {
      const std::size_t x = octant & 1U;
      const std::size_t y = octant >> 1U & 1U;
      const std::size_t z = octant >> 2U;
      const DistanceSample& middle =
          cubes[c].texels[at(kBrickSide, 2 * x + 1, 2 * y + 1, 2 * z + 1)];
      if (std::abs(middle.distance_m) > reach) continue;
      Cube& eighth = eighths.emplace_back();
      eighth.lowest = cubes[c].lowest + 0.5F * side_m * steps(x, y, z);
      eighth.block = blocks_.size();
      eighth.octant = octant;
    }
    begins.push_back(eighths.size());
    blocks_.push_back({});
  }
  parallel_chunks(which.size(), 1, [&](std::size_t n, std::size_t) {
    if (watch_.cancelled()) return;
    const Cube& cube = cubes[which[n]];
    FineTexels fine;
    std::size_t middle = 0;
    for (std::size_t k = 0; k < kBrickSide; ++k)
      for (std::size_t j = 0; j < kBrickSide; ++j)
        for (std::size_t i = 0; i < kBrickSide; ++i)
          fine[at(kFineSide, 2 * i, 2 * j, 2 * k)] = cube.texels[at(kBrickSide, i, j, k)];
    for (std::size_t k = 1; k < kFineSide; k += 2)
      for (std::size_t j = 1; j < kFineSide; j += 2)
        for (std::size_t i = 1; i < kFineSide; i += 2)
          fine[at(kFineSide, i, j, k)] = middles[which[n]][middle++];
    for (std::size_t k = 0; k < kFineSide; ++k)
      for (std::size_t j = 0; j < kFineSide; ++j)
        for (std::size_t i = 0; i < kFineSide; ++i) {
          const std::size_t odd = (i & 1U) + (j & 1U) + (k & 1U);
          if (odd == 0 || odd == 3) continue;
          float nearest = std::numeric_limits<float>::infinity();
          for (const std::size_t z : {k - (k & 1U), k + (k & 1U)})
            for (const std::size_t y : {j - (j & 1U), j + (j & 1U)})
              for (const std::size_t x : {i - (i & 1U), i + (i & 1U)})
                nearest = std::min(nearest, std::abs(fine[at(kFineSide, x, y, z)].distance_m));
          const Eigen::Vector3f place = cube.lowest + 0.5F * spacing_m_ * steps(i, j, k);
          fine[at(kFineSide, i, j, k)] =
              sample(place, nearest + 0.5F * std::sqrt(static_cast<float>(odd)) * spacing_m_);
        }
    for (std::size_t e = begins[n]; e < begins[n + 1]; ++e) {
      Cube& eighth = eighths[e];
      const std::size_t x = kBrickCells * (eighth.octant & 1U);
      const std::size_t y = kBrickCells * (eighth.octant >> 1U & 1U);
      const std::size_t z = kBrickCells * (eighth.octant >> 2U);
      for (std::size_t k = 0; k < kBrickSide; ++k)
        for (std::size_t j = 0; j < kBrickSide; ++j)
          for (std::size_t i = 0; i < kBrickSide; ++i)
            eighth.texels[at(kBrickSide, i, j, k)] = fine[at(kFineSide, x + i, y + j, z + k)];
    }
  });
  for (std::size_t n = 0; n < which.size(); ++n)
    set_word(cubes[which[n]], static_cast<std::uint32_t>(VolumeWord::kBlock) |
                                  static_cast<std::uint32_t>(first_block + n));
  return eighths;
}

// Numbers become places in textures, as near to cubes as they come.
void Builder::lay_out() {
  const auto sides = [](std::size_t count, int most) {
    int side = 1;
    while (side < most && static_cast<std::size_t>(side) * static_cast<std::size_t>(side) *
                                  static_cast<std::size_t>(side) <
                              count)
      ++side;
    const auto layer = static_cast<std::size_t>(side) * static_cast<std::size_t>(side);
    const int layers = std::max(1, static_cast<int>((count + layer - 1) / layer));
    assert(layers <= most && "what was built has room");
    return std::array<int, 3>{side, side, layers};
  };
  const std::array<int, 3> of_blocks = sides(blocks_.size(), DistanceVolume::kLargestSide / 2);
  const std::array<int, 3> of_bricks = sides(bricks_.size(), kBricksASide);
  const auto place = [](std::size_t number, const std::array<int, 3>& size) {
    const auto x = static_cast<std::uint32_t>(size[0]);
    const auto y = static_cast<std::uint32_t>(size[1]);
    const auto n = static_cast<std::uint32_t>(number);
    return Eigen::Matrix<std::uint32_t, 3, 1>(n % x, n / x % y, n / (x * y));
  };
  const auto word = [&](std::uint32_t numbered) {
    const std::uint32_t number = numbered & 0x00FFFFFFU;
    const auto kind = static_cast<VolumeWord>(numbered & 0xFF000000U);
    if (kind == VolumeWord::kNothing) return numbered;
    const auto p = place(number, kind == VolumeWord::kBlock ? of_blocks : of_bricks);
    return volume_word(kind, p[0], p[1], p[2]);
  };
  for (std::uint32_t& w : volume_.grid.data) w = word(w);

  auto& nodes = volume_.nodes;
  nodes.size = {2 * of_blocks[0], 2 * of_blocks[1], 2 * of_blocks[2]};
  nodes.data.assign(nodes.place(0, 0, nodes.size[2]), 0);
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    const Eigen::Vector3i p = 2 * place(b, of_blocks).cast<int>();
    for (int o = 0; o < 8; ++o)
      nodes.data[nodes.place(p[0] + (o & 1), p[1] + (o >> 1 & 1), p[2] + (o >> 2))] =
          word(blocks_[b][static_cast<std::size_t>(o)]);
  }

  auto& texels = volume_.bricks;
  const int side = DistanceVolume::kBrickTexels;
  texels.size = {side * of_bricks[0], side * of_bricks[1], side * of_bricks[2]};
  texels.data.assign(texels.place(0, 0, texels.size[2]), {});
  for (std::size_t b = 0; b < bricks_.size(); ++b) {
    const Eigen::Vector3i p = side * place(b, of_bricks).cast<int>();
    std::size_t n = 0;
    for (int k = 0; k < side; ++k)
      for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i)
          texels.data[texels.place(p[0] + i, p[1] + j, p[2] + k)] = bricks_[b].texels[n++];
  }
}

std::optional<DistanceVolume> Builder::build(const Eigen::AlignedBox3d& bounds) {
  const Eigen::Vector3f margin = Eigen::Vector3f::Constant(options_.band_m);
  const Eigen::Vector3f size = bounds.sizes().cast<float>() + 2 * margin;
  volume_.band_m = options_.band_m;
  volume_.lowest = bounds.min().cast<float>() - margin;
  volume_.cell_m = std::max(kGridCell, size.maxCoeff() / (DistanceVolume::kLargestSide - 1));
  const auto cubes_along = [&](int axis) {
    return 1 + static_cast<int>(size[axis] / volume_.cell_m);
  };
  const auto all = [&] { return 1.0 * cubes_along(0) * cubes_along(1) * cubes_along(2); };
  while (all() > static_cast<double>(options_.most_bricks)) volume_.cell_m *= 1.1F;
  volume_.grid.size = {cubes_along(0), cubes_along(1), cubes_along(2)};
  volume_.grid.data.assign(volume_.grid.place(0, 0, volume_.grid.size[2]), 0);
  spacing_m_ = volume_.cell_m / static_cast<float>(kBrickCells);

  const BrickLimits limits{options_.tolerance_m, options_.near_m, options_.band_m};
  std::vector<Cube> cubes = first_cubes();
  while (!cubes.empty() && !watch_.cancelled()) {
    std::vector<BrickMiddles> middles(cubes.size());
    std::vector<DistanceBrick> bricks(cubes.size());
    parallel_chunks(cubes.size(), 4, [&](std::size_t begin, std::size_t end) {
      for (std::size_t c = begin; c < end; ++c) {
        if (watch_.cancelled()) return;
        if (is_finest() && holds_surface(cubes[c].texels, spacing_m_)) {
          bricks[c] = make_plain_brick(cubes[c].texels);
          continue;
        }
        measure(cubes[c], middles[c]);
        bricks[c] = make_brick(cubes[c].texels, middles[c], spacing_m_, limits);
      }
    });
    if (watch_.cancelled()) break;
    const std::vector<std::size_t> which = to_divide(bricks);
    auto next = which.begin();
    for (std::size_t c = 0; c < cubes.size(); ++c) {
      if (next != which.end() && *next == c) {
        ++next;
        continue;
      }
      set_word(cubes[c], static_cast<std::uint32_t>(VolumeWord::kBrick) |
                             static_cast<std::uint32_t>(bricks_.size()));
      bricks_.push_back(bricks[c]);
    }
    cubes = divide(cubes, middles, which);
    spacing_m_ *= 0.5F;
  }
  if (watch_.cancelled()) return std::nullopt;
  lay_out();
  return std::move(volume_);
}

}  // namespace

std::optional<DistanceVolume> make_distance_field(const DesignSurface& surface,
                                                  const Eigen::AlignedBox3d& bounds,
                                                  const DistanceFieldOptions& options,
                                                  const Watch& watch) {
  assert(!bounds.isEmpty() && options.band_m > 0 && "a design, and a band round it");
  return Builder(surface, options, watch).build(bounds);
}

}  // namespace spool
