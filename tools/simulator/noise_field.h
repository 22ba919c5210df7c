// Random numbers over an image that are the same for the same seed, frame and pixel.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

namespace spool::simulator {

// 64 well-mixed bits of a key (the finaliser of SplitMix64; Steele, Lea & Flood 2014).
[[nodiscard]] constexpr std::uint64_t mix(std::uint64_t key) {
  key += 0x9E3779B97F4A7C15U;
  key = (key ^ (key >> 30U)) * 0xBF58476D1CE4E5B9U;
  key = (key ^ (key >> 27U)) * 0x94D049BB133111EBU;
  return key ^ (key >> 31U);
}

// The key of one kind of noise in one frame.
[[nodiscard]] constexpr std::uint64_t noise_key(std::uint32_t seed, std::int64_t frame,
                                                std::uint32_t kind) {
  return mix(mix(mix(seed) + static_cast<std::uint64_t>(frame)) + kind);
}

// A field of numbers and the memory that making it needs, kept for the next frame's.
struct NoiseField {
  std::vector<float> values;  // row-major
  std::vector<float> rows;    // in the making: summed along u only
};

// Fills `field` with width x height numbers of zero mean and unit variance, about Gaussian, each
// the mean over a window of `window` x `window` pixels (odd): neighbours are correlated as far as
// the windows overlap, as the depths of a sensor are that matches such windows.
void windowed_noise(int width, int height, int window, std::uint64_t key, NoiseField& field);

// A number of zero mean and unit variance that wavers over about `cell` pixels; any pixel alone.
[[nodiscard]] float waver(float u, float v, float cell, std::uint64_t key);

}  // namespace spool::simulator
