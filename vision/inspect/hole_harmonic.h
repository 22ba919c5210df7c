// What goes round a ring as often as a flange has bolt holes: its size, its phase, its holes.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

namespace spool {

// One of equal parts of a turn, counted from angle 0 right-handed: what was seen there, and how
// much of that is as at a hole (looked through, or is absent from the ring).
struct RingBin {
  float seen = 0;
  float through = 0;
};

// share(angle) = a + b cos(n angle) + c sin(n angle) + harmonics 1 and 2, by least squares with the
// bins' weight: of what an edge or a rim that got into the ring does to it, 1 and 2 take the most.
struct HoleHarmonic {
  double amplitude = 0;  // of the share, half of what it varies by; over 0
  double phase_rad = 0;  // of a hole: the angle over which the harmonic is largest, of a pitch
  // Standard error of the phase angle n phase_rad (rad), were what is counted independent: binomial
  // in each bin, grown where bins scatter about the fit by more than that.
  double sigma_rad = 0;
};
// `overtones`: the multiples of n, 1 for n alone, that are fitted; the higher ones tell the holes'
// shape, so that it is not taken for scatter. Nothing where too little was seen to fit them.
[[nodiscard]] std::optional<HoleHarmonic> hole_harmonic(std::span<const RingBin> bins, int count,
                                                        int overtones = 1);

// Three holes at least, and three of four of those in sight, stand out each by itself.
[[nodiscard]] bool are_holes(std::span<const RingBin> bins, int count,
                             const HoleHarmonic& harmonic);

}  // namespace spool
