// The scan map: what all frames together say of the surfaces that stand still.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/scan/scan_map.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cassert>
#include <cmath>

#include "vision/core/parallel.h"
#include "vision/scan/map_reading.h"

namespace spool {
namespace {

constexpr int kMostLevels = 4;
constexpr float kSteepest = 0.34F;  // cosine: 70 degrees; flatter readings start no cell
constexpr float kForgive = 0.5F;    // what a look through counts for after the cell was seen again
constexpr float kRecent = 1.0F / 16;  // share of the newest residual in the recent ones
// Recent residuals average to a fifth of a standard deviation by chance; disparity steps may hold
// a parked camera's off by half of one.
constexpr float kMoved = 1.2F;
// A cell goes when frames that looked through it outweigh those that saw it, of which it can show
// no more than this many.
constexpr float kStartAgainst = 2.0F, kAgainstPerCount = 0.15F;
constexpr double kParkedM = 0.003;    // m; a hand's tremor is more
constexpr double kParkedRad = 0.003;  // rad; the same at 1 m

// The level of the cells for readings at depth z: two standard deviations and one and a half pixels
// wide, so that a cell is more than its own noise.
int level_for(double z, const SeenFrame& frame, double cell_m) {
  const double needed = std::max(2.0 * frame.noise.axial_m(std::max(z, 0.1)),
                                 1.5 * z / std::min(frame.camera.fx, frame.camera.fy));
  const int level = static_cast<int>(std::ceil(std::log2(std::max(needed / cell_m, 1.0))));
  return std::min(level, kMostLevels);
}

// Levels by depth in centimetres, for a loop over cells.
struct Levels {
  std::array<std::uint8_t, 1024> of_cm = {};
  Levels(const SeenFrame& frame, double cell_m) {
    for (std::size_t i = 0; i < of_cm.size(); ++i)
      of_cm[i] = static_cast<std::uint8_t>(
          level_for(0.01 * (static_cast<double>(i) + 0.5), frame, cell_m));
  }
  [[nodiscard]] int at(float z) const {
    return of_cm[std::min<std::size_t>(1023, static_cast<std::size_t>(std::max(0.0F, 100 * z)))];
  }
};

// Pixels that the map explains. Set only, so that the order of threads does not matter.
class Explained {
 public:
  Explained(int width, int height)
      : width_(width), height_(height), marks_(static_cast<std::size_t>(width * height)) {}
  void mark(int u, int v, int radius) {
    for (int y = std::max(0, v - radius); y <= std::min(height_ - 1, v + radius); ++y)
      for (int x = std::max(0, u - radius); x <= std::min(width_ - 1, u + radius); ++x)
        marks_[static_cast<std::size_t>(y * width_ + x)].store(1, std::memory_order_relaxed);
  }
  [[nodiscard]] bool at(std::size_t pixel) const {
    return marks_[pixel].load(std::memory_order_relaxed) != 0;
  }

 private:
  int width_, height_;
  std::vector<std::atomic<std::uint8_t>> marks_;
};

// One reading into a cell: mean, covariance and normal by the running weighted mean (Welford 1962).
void take_in(const CellReading& reading, float most_count, MapCell& cell) {
  const float weight = 1.0F / reading.variance;
  cell.weight = std::min(cell.weight, (most_count - 1) * weight) + weight;
  const float share = weight / cell.weight;
  const Eigen::Vector3f off = reading.point - cell.mean;
  cell.mean += share * off;
  cell.covariance = (1 - share) * (cell.covariance + share * off * off.transpose());
  cell.normal = (cell.normal + share * (reading.normal - cell.normal)).normalized();
  cell.count = std::min(cell.count + 1, most_count);
}

float most_against(const MapCell& cell) { return kStartAgainst + kAgainstPerCount * cell.count; }

struct Counts {
  std::size_t agreed = 0, through = 0, restarted = 0;
  Counts& operator+=(const Counts& o) {
    agreed += o.agreed;
    through += o.through;
    restarted += o.restarted;
    return *this;
  }
};

}  // namespace

std::optional<Error> validate(const ScanMapOptions& options) {
  const bool good = options.cell_m > 0 && options.most_cells > 0 && options.most_count >= 2 &&
                    options.parked_count >= 1 && options.settled_count >= 1 &&
                    options.unsettled_s > 0;
  if (good) return std::nullopt;
  return Error{ErrorCode::kUsage, "scan map options: lengths, counts and times must be positive"};
}

ScanMap::ScanMap(const ScanMapOptions& options)
    : options_(options), blocks_(static_cast<float>(options.cell_m)) {
  assert(!validate(options) && "options that make sense");
}

struct ScanMap::Look {
  const SeenFrame& frame;
  ReadingNoise noise;
  MapReader reader;
  Levels levels;
  Explained explained;
  Eigen::Matrix3f R_map_camera;
  Eigen::Vector3f t_map_camera;
  std::vector<std::size_t> in_view = {};  // blocks

  Look(const SeenFrame& of, const Pose& T_map_camera, double cell_m)
      : frame(of),
        noise(of.noise, of.camera),
        reader(of, noise, T_map_camera),
        levels(of, cell_m),
        explained(of.camera.width, of.camera.height),
        R_map_camera(T_map_camera.linear().cast<float>()),
        t_map_camera(T_map_camera.translation().cast<float>()) {}
};

FuseReport ScanMap::fuse(const SeenFrame& frame, const Pose& T_map_camera, KeyframeId keyframe) {
  assert(frame.is_usable() && "an organised cloud with normals and its camera");
  FuseReport report;
  ++frames_;
  if (T_map_anchor_) {
    const PoseSize moved = pose_size(T_map_anchor_->inverse() * T_map_camera);
    report.parked = moved.translation_m < kParkedM && moved.rotation_rad < kParkedRad;
  }
  if (!report.parked) T_map_anchor_ = T_map_camera;

  Look look(frame, T_map_camera, options_.cell_m);
  for (std::size_t i = 0; i < blocks_.blocks().size(); ++i) {
    MapBlock& block = blocks_.blocks()[i];
    if (block.voxel <= 0 || !look.reader.may_see(block.box)) continue;
    block.seen_s = frame.seconds;
    look.in_view.push_back(i);
  }
  correct_cells(look, report);
  drop_faded(look, report);
  start_cells(look, keyframe, report);
  blocks_.shrink_to(options_.most_cells);
  if (report.removed > 0) blocks_.sweep();
  return report;
}

// Each cell in view by the reading that it is seen at.
void ScanMap::correct_cells(Look& look, FuseReport& report) {
  const SeenFrame& frame = look.frame;
  const auto focal = static_cast<float>(std::min(frame.camera.fx, frame.camera.fy));
  const auto look_at = [&](MapCell& cell, Counts& counts) {
    const CellReading reading = look.reader.read(cell);
    if (reading.sight == CellSight::kThrough) {
      ++counts.through;
      cell.against += 1;
    }
    if (reading.sight != CellSight::kAgrees) return;
    ++counts.agreed;
    cell.seen_s = frame.seconds;
    const int wanted = look.levels.at(reading.z);
    if (cell.size > std::ldexp(blocks_.cell_m(), wanted + 1) * 0.9F) {
      // A near look makes finer cells; the coarse one goes once they have settled.
      cell.against += most_against(cell) / (4 * options_.settled_count);
      return;
    }
    cell.against *= kForgive;
    look.explained.mark(reading.u, reading.v,
                        std::max(1, static_cast<int>(0.5F * cell.size * focal / reading.z)));
    const float sigma = std::sqrt(reading.variance + cell.variance());
    cell.bias += kRecent * (reading.residual / sigma - cell.bias);
    if (std::abs(cell.bias) > kMoved) {
      ++counts.restarted;
      cell.count = 1;
      cell.weight = 1.0F / reading.variance;
      cell.bias = 0;
    }
    if (report.parked && cell.count >= options_.parked_count) return;
    take_in(reading, options_.most_count, cell);
  };
  constexpr std::size_t kGrain = 16;  // blocks, some thousand cells
  const Counts counts =
      parallel_sum(look.in_view.size(), kGrain, Counts{}, [&](std::size_t begin, std::size_t end) {
        Counts part;
        for (std::size_t i = begin; i < end; ++i)
          for (MapCell& cell : blocks_.blocks()[look.in_view[i]].cells) look_at(cell, part);
        return part;
      });
  report.agreed = counts.agreed;
  report.through = counts.through;
  report.restarted = counts.restarted;
}

// What was looked through too often goes, and what was seen once or twice and then no more.
void ScanMap::drop_faded(const Look& look, FuseReport& report) {
  const std::size_t before = blocks_.cell_count();
  for (const std::size_t i : look.in_view)
    blocks_.drop(i, [&](const MapCell& cell) {
      const bool passed = cell.count < options_.settled_count &&
                          look.frame.seconds - cell.seen_s > options_.unsettled_s;
      return passed || cell.against > most_against(cell);
    });
  report.removed = before - blocks_.cell_count();
}

// New cells where the map explains nothing: a few pixels of each, others every frame.
void ScanMap::start_cells(const Look& look, KeyframeId keyframe, FuseReport& report) {
  const SeenFrame& frame = look.frame;
  const int stride = std::max(1, frame.camera.width / 160);
  const int start = static_cast<int>(frames_ % static_cast<std::size_t>(stride));
  for (int v = start; v < frame.camera.height; v += stride)
    for (int u = start; u < frame.camera.width; u += stride) {
      const auto pixel = static_cast<std::size_t>(v * frame.camera.width + u);
      const Eigen::Vector3f& point = frame.cloud.points[pixel];
      const Eigen::Vector3f& normal = frame.cloud.normals[pixel];
      if (!(point.z() > 0) || normal.isZero() || look.explained.at(pixel)) continue;
      const float facing = -normal.dot(point) / point.norm();
      if (facing < kSteepest) continue;
      MapCell cell;
      cell.mean = look.R_map_camera * point + look.t_map_camera;
      cell.normal = look.R_map_camera * normal;
      const float variance = look.noise.variance(point.z(), facing);
      cell.weight = 1.0F / variance;
      cell.covariance = variance * cell.normal * cell.normal.transpose();
      cell.count = 1;
      cell.keyframe = keyframe;
      cell.seen_s = frame.seconds;
      report.added += blocks_.add(cell, look.levels.at(point.z())) ? 1U : 0U;
    }
}

void ScanMap::move(std::span<const Pose> motions) {
  blocks_.move(motions);
  T_map_anchor_.reset();
}

PointCloud ScanMap::cloud() const {
  PointCloud cloud;
  for (const MapBlock& block : blocks())
    for (const MapCell& cell : block.cells) {
      if (!is_settled(cell)) continue;
      cloud.points.push_back(cell.mean);
      cloud.normals.push_back(cell.normal);
    }
  return cloud;
}

void ScanMap::clear() {
  blocks_.clear();
  frames_ = 0;
  T_map_anchor_.reset();
}

}  // namespace spool
