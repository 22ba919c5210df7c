// Random numbers over an image that are the same for the same seed, frame and pixel.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/simulator/noise_field.h"

#include <cassert>
#include <cmath>
#include <cstddef>

#include "vision/core/parallel.h"

namespace spool::simulator {
namespace {

constexpr float kUniformScale =
    3.4641016F;  // sqrt(12): a uniform number of width 1 gets variance 1

// Variance 1, uniform, from 16 bits.
float uniform16(std::uint64_t bits) {
  return (static_cast<float>(bits & 0xFFFFU) + 0.5F) * (kUniformScale / 65536.0F) -
         kUniformScale / 2;
}

// Sums of `window` neighbours along one line of `out`, from a line longer by window - 1.
void slide(const float* in, std::size_t stride_in, float* out, std::size_t stride_out,
           std::size_t count, int window) {
  float sum = 0;
  for (int i = 0; i < window; ++i) sum += in[static_cast<std::size_t>(i) * stride_in];
  for (std::size_t i = 0; i < count; ++i) {
    out[i * stride_out] = sum;
    if (i + 1 < count)
      sum += in[(i + static_cast<std::size_t>(window)) * stride_in] - in[i * stride_in];
  }
}

}  // namespace

void windowed_noise(int width, int height, int window, std::uint64_t key, NoiseField& field) {
  assert(width > 0 && height > 0 && window > 0 && window % 2 == 1 && "a window has a middle");
  const auto w = static_cast<std::size_t>(width), h = static_cast<std::size_t>(height);
  const std::size_t margin = static_cast<std::size_t>(window) - 1;
  const std::size_t wide = (w + margin + 3) / 4 * 4, high = h + margin;
  field.rows.resize(w * high);
  parallel_chunks(high, 32, [&](std::size_t begin, std::size_t end) {
    std::vector<float> white(wide);
    for (std::size_t v = begin; v < end; ++v) {
      for (std::size_t u = 0; u < wide; u += 4) {
        const std::uint64_t bits = mix(key + v * wide + u);
        for (std::size_t i = 0; i < 4; ++i) white[u + i] = uniform16(bits >> (16 * i));
      }
      slide(white.data(), 1, field.rows.data() + v * w, 1, w, window);
    }
  });
  field.values.resize(w * h);
  const std::vector<float>& rows = field.rows;
  const float scale = 1.0F / static_cast<float>(window);  // the sum of window^2 has that sigma
  parallel_chunks(h, 32, [&](std::size_t begin, std::size_t end) {
    std::vector<float> sum(w, 0.0F);
    for (std::size_t v = begin; v <= begin + margin; ++v)
      for (std::size_t u = 0; u < w; ++u) sum[u] += rows[v * w + u];
    for (std::size_t v = begin; v < end; ++v)
      for (std::size_t u = 0; u < w; ++u) {
        field.values[v * w + u] = sum[u] * scale;
        if (v + 1 < end) sum[u] += rows[(v + margin + 1) * w + u] - rows[v * w + u];
      }
  });
}

float waver(float u, float v, float cell, std::uint64_t key) {
  const float x = u / cell, y = v / cell;
  const float column = std::floor(x), row = std::floor(y);
  const float a = x - column, b = y - row;
  const auto corner = [&](int right, int down) {
    const auto i = static_cast<std::uint64_t>(static_cast<std::int64_t>(column) + right);
    const auto j = static_cast<std::uint64_t>(static_cast<std::int64_t>(row) + down);
    return uniform16(mix(key + i * 0x100000001B3U + j * 0x9E3779B1U));
  };
  const float weights[4] = {(1 - a) * (1 - b), a * (1 - b), (1 - a) * b, a * b};
  const float value = weights[0] * corner(0, 0) + weights[1] * corner(1, 0) +
                      weights[2] * corner(0, 1) + weights[3] * corner(1, 1);
  float power = 0;  // between nodes the mean of several would waver less
  for (const float weight : weights) power += weight * weight;
  return value / std::sqrt(power);
}

}  // namespace spool::simulator
