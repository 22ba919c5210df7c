// Normals of an organised cloud: the plane through each pixel's window, fitted in inverse depth.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>

#include "vision/core/parallel.h"
#include "vision/scan/normals.h"

namespace spool {
namespace {

// A plane is linear in the image when inverse depth is the third coordinate: with plane A x + B y +
// C z = 1 and x = (u - cx) z / fx, 1 / z = A (u - cx) / fx + B (v - cy) / fy + C. So a window is a
// linear least-squares problem whose moments are small integers times a mask, four pixels at a
// time.
using Float4 = float __attribute__((vector_size(16)));  // g++ and clang both, on any processor
using Mask4 = std::int32_t __attribute__((vector_size(16)));

constexpr std::size_t kLanes = 4;
constexpr std::size_t kRadius = 6;  // px, half the window: 13 px, some 11 mm at 0.5 m
constexpr std::size_t kNear = 3;    // px, half the window of the first look
constexpr std::size_t kStride =
    2;  // px; next pixels share their correlation window (ARCHITECTURE, The sensor)
constexpr float kNone = -1e30F;  // inverse depth of no measurement: far from every gate
constexpr float kSteepest =
    3.7321F;  // tan 75 deg: beyond it the sensor sees nothing (ARCHITECTURE, The sensor)
constexpr double kSigmas = 3.0;     // of the difference of two readings
constexpr float kLateralPx = 0.8F;  // px, lateral noise head on (ARCHITECTURE, The sensor)
constexpr float kFewest = 6.0F;     // readings for a plane and something to check it by
constexpr float kSpread = 4.0F;     // px^4, least determinant of the window's scatter: no line

Float4 load(const float* at) {
  Float4 four;
  std::memcpy(&four, at, sizeof four);
  return four;
}
Float4 all(float x) { return Float4{x, x, x, x}; }
Float4 where(Mask4 mask, Float4 yes, Float4 no) {
  return reinterpret_cast<Float4>((mask & reinterpret_cast<Mask4>(yes)) |
                                  (~mask & reinterpret_cast<Mask4>(no)));
}
Float4 kept(Mask4 mask, Float4 x) {
  return reinterpret_cast<Float4>(mask & reinterpret_cast<Mask4>(x));
}
Float4 magnitude(Float4 x) {
  constexpr std::int32_t kAllButSign = 0x7FFFFFFF;
  return kept(Mask4{kAllButSign, kAllButSign, kAllButSign, kAllButSign}, x);
}

// Inverse depth near a pixel: at_centre + per_u du + per_v dv.
struct Slope {
  Float4 at_centre, per_u, per_v;
  Mask4 valid;
};

// Least squares over the window of `radius` and `stride` about four pixels, of the readings within
// `gate` of the `expected` plane. `centre` points at the first of the four in an image `pitch`
// wide.
template <std::size_t radius, std::size_t stride>
Slope fit(const float* centre, std::size_t pitch, const Slope& expected, Float4 gate) {
  Float4 n{}, su{}, sv{}, suu{}, suv{}, svv{}, sd{}, sud{}, svd{};
  constexpr auto reach = static_cast<std::ptrdiff_t>(radius);
  constexpr auto step = static_cast<std::ptrdiff_t>(stride);
  for (std::ptrdiff_t dv = -reach; dv <= reach; dv += step) {
    const float* const row = centre + dv * static_cast<std::ptrdiff_t>(pitch);
    const auto y = static_cast<float>(dv);
    const Float4 row_expected = expected.at_centre + expected.per_v * y;
    Float4 row_n{}, row_u{}, row_uu{}, row_d{}, row_ud{};
    for (std::ptrdiff_t du = -reach; du <= reach; du += step) {
      const auto x = static_cast<float>(du);
      const Float4 difference = load(row + du) - (row_expected + expected.per_u * x);
      const Mask4 inside = magnitude(difference) < gate;
      const Float4 one = kept(inside, all(1.0F));
      const Float4 d = kept(inside, difference);
      row_n += one;
      row_u += one * x;
      row_uu += one * (x * x);
      row_d += d;
      row_ud += d * x;
    }
    n += row_n;
    su += row_u;
    sv += row_n * y;
    suu += row_uu;
    suv += row_u * y;
    svv += row_n * (y * y);
    sd += row_d;
    sud += row_ud;
    svd += row_d * y;
  }
  const Float4 per_n = 1.0F / where(n > 0.0F, n, all(1.0F));
  const Float4 mean_u = su * per_n, mean_v = sv * per_n, mean_d = sd * per_n;
  const Float4 cuu = suu - su * mean_u, cuv = suv - su * mean_v, cvv = svv - sv * mean_v;
  const Float4 cud = sud - su * mean_d, cvd = svd - sv * mean_d;
  const Float4 determinant = cuu * cvv - cuv * cuv;
  const Mask4 valid = (n >= kFewest) & (determinant > kSpread * n * n);
  const Float4 per_determinant = 1.0F / where(valid, determinant, all(1.0F));
  const Float4 a = (cvv * cud - cuv * cvd) * per_determinant;
  const Float4 b = (cuu * cvd - cuv * cud) * per_determinant;
  return {expected.at_centre + mean_d - a * mean_u - b * mean_v, expected.per_u + a,
          expected.per_v + b, valid};
}

// Inverse depths with a border of none, and beside each the gate that noise alone explains.
struct InverseDepth {
  std::size_t pitch = 0;
  std::vector<float> value;  // 1/m
  std::vector<float> gate;   // 1/m

  InverseDepth(const PointCloud& cloud, const NoiseModel& noise) {
    const auto width = static_cast<std::size_t>(cloud.width);
    const auto height = static_cast<std::size_t>(cloud.height);
    pitch = width + 2 * kRadius + kLanes;
    value.assign(pitch * (height + 2 * kRadius), kNone);
    gate.assign(value.size(), 0.0F);
    parallel_chunks(height, 32, [&](std::size_t begin, std::size_t end) {
      for (std::size_t v = begin; v < end; ++v)
        for (std::size_t u = 0; u < width; ++u) {
          const double z = cloud.points[v * width + u].z();
          if (!(z > 0 && z < 1e6)) continue;  // NaN too
          const std::size_t at = (v + kRadius) * pitch + u + kRadius;
          value[at] = static_cast<float>(1.0 / z);
          // A difference of z is one of 1 / z^2 in inverse depth.
          gate[at] = static_cast<float>(kSigmas * std::sqrt(2.0) * noise.axial_m(z) / (z * z));
        }
    });
  }
};

}  // namespace

void estimate_organised_normals(PointCloud& cloud, const Camera& camera, const NoiseModel& noise) {
  assert(cloud.width == camera.width && cloud.height == camera.height && cloud.is_consistent() &&
         camera.is_valid() && cloud.width > 0 && "the organised cloud of this camera");
  const auto width = static_cast<std::size_t>(cloud.width);
  const auto height = static_cast<std::size_t>(cloud.height);
  const InverseDepth inverse(cloud, noise);
  std::vector<Eigen::Vector3f> normals(cloud.size(), Eigen::Vector3f::Zero());

  const auto fx = static_cast<float>(camera.fx), fy = static_cast<float>(camera.fy);
  const auto cx = static_cast<float>(camera.cx), cy = static_cast<float>(camera.cy);
  const float steepest_per_px = kSteepest / std::min(fx, fy);  // of the inverse depth itself

  parallel_chunks(height, 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v)
      for (std::size_t u = 0; u < width; u += kLanes) {
        const std::size_t at = (v + kRadius) * inverse.pitch + u + kRadius;
        const float* const centre = inverse.value.data() + at;
        const Float4 value = load(centre);
        const Mask4 seen = value > 0.0F;
        const Float4 noise_gate = load(inverse.gate.data() + at);
        // First look: a few near readings, at most as far off as the steepest visible surface would
        // be.
        const Float4 slope_gate = kept(seen, value) * steepest_per_px;
        const Slope level{value, {}, {}, seen};
        Slope near = fit<kNear, kNear>(centre, inverse.pitch, level,
                                       noise_gate + slope_gate * (1.4142F * kNear));
        near.at_centre = where(near.valid, near.at_centre, value);
        near.per_u = kept(near.valid, near.per_u);
        near.per_v = kept(near.valid, near.per_v);
        // Then the whole window, as far off that plane as the noise explains: along the ray, and
        // across it on a slope. Where the first look found no plane the steepest surface is allowed
        // again.
        const Float4 across = (magnitude(near.per_u) + magnitude(near.per_v)) *
                              (static_cast<float>(kSigmas) * kLateralPx);
        const Float4 gate =
            noise_gate + where(near.valid, across, slope_gate * (1.4142F * kRadius));
        const Slope plane = fit<kRadius, kStride>(centre, inverse.pitch, near, gate);
        const Mask4 good = plane.valid & seen;
        // The plane A x + B y + C z = 1 has its normal away from the camera: turned about.
        const auto first = static_cast<float>(u);
        const Float4 to_cx = cx - Float4{first, first + 1, first + 2, first + 3};
        const Float4 x = -plane.per_u * fx;
        const Float4 y = -plane.per_v * fy;
        const Float4 z =
            -plane.at_centre - plane.per_u * to_cx - plane.per_v * (cy - static_cast<float>(v));
        const Float4 squared = where(good, x * x + y * y + z * z, all(1.0F));
        const Float4 length{std::sqrt(squared[0]), std::sqrt(squared[1]), std::sqrt(squared[2]),
                            std::sqrt(squared[3])};
        const Float4 nx = kept(good, x / length);
        const Float4 ny = kept(good, y / length);
        const Float4 nz = kept(good, z / length);
        for (std::size_t lane = 0; lane < std::min(kLanes, width - u); ++lane)
          normals[v * width + u + lane] = {nx[lane], ny[lane], nz[lane]};
      }
  });
  cloud.normals = std::move(normals);
}

}  // namespace spool
