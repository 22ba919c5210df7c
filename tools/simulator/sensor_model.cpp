// From what is there to what a structured-light sensor says is there.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/simulator/sensor_model.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "vision/core/parallel.h"

namespace spool::simulator {
namespace {

constexpr int kWindow = 7;       // px, the matching window that neighbours share
constexpr double kSubpixel = 8;  // steps of disparity in a pixel
constexpr float kJump = 0.02F;   // of the depth: more between neighbours is an edge
constexpr float kRightAngle = static_cast<float>(std::numbers::pi / 2);
constexpr float kSteepest = 1.396F;  // rad, 80 degrees: as far as the formulas were measured
constexpr std::size_t kRows = 16;    // a chunk of the parallel loops

enum NoiseKind : std::uint32_t { kAxial = 1, kJitterU, kJitterV, kGrazing, kBright };

// Where the ideal image is looked at for one pixel, and what is there.
struct Sample {
  float depth = 0;
  float incidence = 0;
  bool bright = false;
};

class Model {
 public:
  Model(const SensorSettings& sensor, const IdealImage& image, std::int64_t frame,
        NoiseField& noise)
      : sensor_(sensor),
        image_(image),
        frame_(frame),
        focal_baseline_(sensor.camera.fx * sensor.baseline_m),
        axial_(noise.values) {
    if (sensor.noise) windowed_noise(image.width, image.height, kWindow, key(kAxial), noise);
  }

  void run(DepthFrame& to) const {
    parallel_chunks(static_cast<std::size_t>(image_.height), kRows,
                    [&](std::size_t begin, std::size_t end) {
                      std::vector<float> lit;
                      std::vector<std::uint8_t> edges;
                      for (std::size_t v = begin; v < end; ++v)
                        sense_row(static_cast<int>(v), lit, edges, to);
                    });
  }

 private:
  std::uint64_t key(NoiseKind kind) const { return noise_key(sensor_.seed, frame_, kind); }
  std::size_t at(int u, int v) const {
    return static_cast<std::size_t>(v) * static_cast<std::size_t>(image_.width) +
           static_cast<std::size_t>(u);
  }
  // Depth at (u, v); 0 outside the image.
  float depth_at(int u, int v) const {
    return u >= 0 && v >= 0 && u < image_.width && v < image_.height ? image_.depth[at(u, v)] : 0;
  }

  void sense_row(int v, std::vector<float>& lit, std::vector<std::uint8_t>& edges,
                 DepthFrame& to) const {
    if (sensor_.noise && sensor_.shadow) light_row(v, lit);
    if (sensor_.noise) find_edges(v, edges);
    for (int u = 0; u < image_.width; ++u) {
      Sample sample{image_.depth[at(u, v)], image_.incidence[at(u, v)],
                    image_.bright[at(u, v)] != 0};
      if (sensor_.noise && edges[static_cast<std::size_t>(u)] != 0)
        sample = across_edge(u, v, sample);
      const bool seen = sample.depth > 0 && !(sensor_.noise && is_lost(u, v, sample, lit));
      to.depth[at(u, v)] = seen ? counts(u, v, sample) : std::uint16_t{0};
    }
  }

  // Edges. A window over an edge answers with the nearer surface, so silhouettes grow by a pixel;
  // where exactly wavers with the lateral noise. Sets `edges` to 1 where one of row v may be in
  // reach.
  void find_edges(int v, std::vector<std::uint8_t>& edges) const {
    constexpr int kReach = 4;  // px: one of fattening and three standard deviations of jitter
    constexpr std::uint8_t kEdge = 1;
    const auto width = static_cast<std::size_t>(image_.width);
    const float* const here = image_.depth.data() + at(0, v);
    edges.assign(width, 0);
    // Plain loops over rows, which the compiler turns into vector instructions.
    const auto compare = [&](const float* a, const float* b, std::uint8_t* to, std::size_t count) {
      for (std::size_t u = 0; u < count; ++u) to[u] = is_other(a[u], b[u]) ? kEdge : to[u];
    };
    for (const int step : {-kReach, kReach, -1, 1}) {
      const int row = std::clamp(v + step, 0, image_.height - 1);
      compare(image_.depth.data() + at(0, row), here, edges.data(), width);
    }
    for (const std::size_t step : {std::size_t{kReach}, std::size_t{1}}) {
      const std::size_t inside = width > step ? width - step : 0;
      compare(here + step, here, edges.data(), inside);
      compare(here, here + step, edges.data() + step, inside);
      for (std::size_t u = 0; u < std::min(step, width); ++u) {  // beyond the border is the border
        if (is_other(here[0], here[u])) edges[u] = kEdge;
        if (is_other(here[width - 1], here[width - 1 - u])) edges[width - 1 - u] = kEdge;
      }
    }
  }
  Sample across_edge(int u, int v, const Sample& own) const {
    const float angle = std::min(own.incidence, kSteepest);
    // Lateral sigma in px, Nguyen, Izadi & Lovell 2012.
    const float sigma = 0.8F + 0.035F * angle / (kRightAngle - angle);
    const auto fu = static_cast<float>(u), fv = static_cast<float>(v);
    const int du = static_cast<int>(std::lround(sigma * waver(fu, fv, 5, key(kJitterU))));
    const int dv = static_cast<int>(std::lround(sigma * waver(fu, fv, 5, key(kJitterV))));
    Sample nearest = own;
    constexpr int kCross[5][2] = {{0, 0}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}};
    // The jittered place decides between the surfaces; only another surface replaces the own one,
    // so that inside a slanted face the axial formula alone holds.
    const float there = depth_at(u + du, v + dv);
    if (there > 0 && is_other(there, own.depth)) nearest = sample(u + du, v + dv);
    for (const auto& step : kCross) {
      const float depth = depth_at(u + du + step[0], v + dv + step[1]);
      if (depth > 0 && is_other(depth, nearest.depth) &&
          (nearest.depth <= 0 || depth < nearest.depth))
        nearest = sample(u + du + step[0], v + dv + step[1]);
    }
    return nearest;
  }
  static bool is_other(float a, float b) {
    return std::abs(a - b) > kJump * std::max(std::min(a, b), 0.1F);
  }
  Sample sample(int u, int v) const {
    return {image_.depth[at(u, v)], image_.incidence[at(u, v)], image_.bright[at(u, v)] != 0};
  }

  // Projector shadow. `lit` holds for each projector column the largest disparity that the row's
  // surfaces put there: what lies behind it is dark. Column u + disparity, since the projector is
  // at -baseline.
  void light_row(int v, std::vector<float>& lit) const {
    // Nearer than this nothing is expected to cast a shadow into the picture.
    constexpr double kNearest = 0.1;  // m
    const auto columns = static_cast<std::size_t>(image_.width + focal_baseline_ / kNearest);
    lit.assign(columns, 0.0F);
    for (int u = 0; u < image_.width; ++u) {
      const float depth = image_.depth[at(u, v)];
      if (depth <= 0) continue;
      const float disparity = disparity_of(depth);
      float end = static_cast<float>(u) + disparity + 0.5F;
      const float next = depth_at(u + 1, v);
      // A surface that goes on covers the columns up to its next pixel.
      if (next > 0 && !is_other(next, depth))
        end = std::max(end, static_cast<float>(u + 1) + disparity_of(next));
      const auto first =
          static_cast<std::size_t>(std::max(static_cast<float>(u) + disparity, 0.0F));
      for (std::size_t c = first; c < columns && static_cast<float>(c) <= end; ++c)
        lit[c] = std::max(lit[c], disparity);
    }
  }
  bool is_dark(int u, float depth, const std::vector<float>& lit) const {
    const float disparity = disparity_of(depth);
    const auto column = static_cast<std::size_t>(static_cast<float>(u) + disparity + 0.5F);
    if (column >= lit.size()) return false;
    return depth > 0 && is_other(focal_baseline_f() / std::max(lit[column], 1e-6F), depth) &&
           lit[column] > disparity;
  }

  bool is_lost(int u, int v, const Sample& sample, const std::vector<float>& lit) const {
    if (sensor_.shadow && is_dark(u, sample.depth, lit)) return true;
    if (!sensor_.dropout) return false;
    const auto fu = static_cast<float>(u), fv = static_cast<float>(v);
    // Lost from 70 degrees on, all of it at 75; in patches, as the pattern is matched in windows.
    constexpr float kFirst = 1.2217F, kLast = 1.3090F;  // rad
    const float share = (sample.incidence - kFirst) / (kLast - kFirst);
    if (share >= 1) return true;
    if (share > 0 && waver(fu, fv, 4, key(kGrazing)) < kUniformWidth * (share - 0.5F)) return true;
    if (!sample.bright) return false;
    // Bright metal: blinded within 12 degrees of the mirror direction (camera and projector are
    // close, so that is nearly head on), elsewhere a third is lost for lack of a diffuse answer.
    constexpr float kMirror = 0.21F;  // rad
    return sample.incidence < kMirror ||
           waver(fu, fv, 4, key(kBright)) < kUniformWidth * (0.33F - 0.5F);
  }

  std::uint16_t counts(int u, int v, const Sample& sample) const {
    const Camera& camera = sensor_.camera;
    const double x = (u - camera.cx) / camera.cx, y = (v - camera.cy) / camera.cy;
    double z = static_cast<double>(sample.depth) *
               (1 + sensor_.scale_error + sensor_.radial_warp * (x * x + y * y) / 2);
    if (sensor_.noise) {
      // The published sigma holds the rounding of disparity already: step / sqrt(12) of it.
      const double step = quantisation_step_m(sensor_, z);
      const double sigma = axial_sigma_m(z, static_cast<double>(sample.incidence));
      const double added = std::sqrt(std::max(sigma * sigma - step * step / 12, 0.0));
      z += added * static_cast<double>(axial_[at(u, v)]);
      if (!(z > 0)) return 0;
      const double disparity = std::round(focal_baseline_ / z * kSubpixel) / kSubpixel;
      if (!(disparity > 0)) return 0;
      z = focal_baseline_ / disparity;
    }
    if (z < sensor_.near_m || z > sensor_.far_m) return 0;
    return static_cast<std::uint16_t>(std::lround(z / camera.depth_unit_m));
  }

  float focal_baseline_f() const { return static_cast<float>(focal_baseline_); }
  float disparity_of(float depth) const { return focal_baseline_f() / std::max(depth, 0.05F); }

  static constexpr float kUniformWidth = 3.4641016F;  // of waver() where it is uniform

  const SensorSettings& sensor_;
  const IdealImage& image_;
  std::int64_t frame_;
  double focal_baseline_;  // px m
  const std::vector<float>& axial_;
};

}  // namespace

double quantisation_step_m(const SensorSettings& sensor, double z_m) {
  return z_m * z_m / (sensor.camera.fx * sensor.baseline_m) / kSubpixel;
}

double axial_sigma_m(double z_m, double incidence_rad) {
  const double angle = std::min(incidence_rad, static_cast<double>(kSteepest));
  const double beyond = std::numbers::pi / 2 - angle;
  return 0.0012 + 0.0019 * (z_m - 0.4) * (z_m - 0.4) +
         0.0001 / std::sqrt(z_m) * angle * angle / (beyond * beyond);
}

void sense(const SensorSettings& sensor, const IdealImage& image, std::int64_t index,
           NoiseField& noise, DepthFrame& frame) {
  frame.index = index;
  frame.seconds = static_cast<double>(index) / sensor.frames_per_second;
  frame.width = image.width;
  frame.height = image.height;
  frame.depth.resize(image.depth.size());
  Model(sensor, image, index, noise).run(frame);
}

}  // namespace spool::simulator
