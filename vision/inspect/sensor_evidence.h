// What one scan says of the sensor that made it: its scale by pieces of known size, its warp by
// planes.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace spool {

enum class GaugeKind : std::uint8_t { kPipeDiameter, kFlangeDiameter, kBoltCircle, kScaleBar };
[[nodiscard]] constexpr std::string_view name(GaugeKind kind) {
  switch (kind) {
    case GaugeKind::kPipeDiameter:
      return "pipe_diameter";
    case GaugeKind::kFlangeDiameter:
      return "flange_diameter";
    case GaugeKind::kBoltCircle:
      return "bolt_circle";
    case GaugeKind::kScaleBar:
      break;
  }
  return "scale_bar";
}

// A length that is known without the scan, as the scan has it. Nothing that was held in a fit.
struct Gauge {
  GaugeKind kind = GaugeKind::kPipeDiameter;
  int part = -1;                  // -1: no part of the design
  double nominal_m = 0;           // by catalogue or certificate
  double tolerance_u_m = 0;       // standard uncertainty of the piece itself: its mill's tolerance
  double measured_m = 0;          // by the scan, uncorrected
  double u_m = 0;                 // of measuring it
  double shared_u_m = 0;          // what all gauges of its kind are off by together
  std::optional<double> range_m;  // from the camera; of a merged scan nobody knows it
};

// s(z) = 1 + a + b z: a metre reads s metres at range z.
struct ScaleCheck {
  std::vector<Gauge> gauges;  // that were used
  double prior_u = 0;         // the calibration's, a fraction
  // What the gauges alone say at `range_m`, where a and b are uncorrelated.
  double found = 0, found_u = 0;
  std::optional<double> range_m;
  double chi_square = 0;   // of the gauges about their own fit; above what chance allows, found_u
  int freedom = 0;         // has grown by Birge's ratio
  double statistic = 0;    // what contradicts the calibration most, in standard deviations
  double limit = 0;        // beyond which it contradicts it
  double false_alarm = 0;  // of honest calibrations exceed it
  bool is_contradicted = false;
  // After the gauges and the calibration together, or where they contradict each other after the
  // gauges alone.
  double a = 0, b_per_m = 0;
  // Lengths are divided by 1 + correction; 0 where chance explains the gauges.
  double correction = 0;
  double scale_u = 0;  // standard uncertainty left, a fraction; what was not corrected is in it
};

// What planes in one depth image, which are flat, say of its warp.
struct WarpCheck {
  double corner_m = 0, corner_u_m = 0;  // the bend found: root mean square over the four corners
  double stated_u_m = 0;                // the calibration's
  double range_m = 0;                   // median, of the readings
  double statistic = 0, limit = 0;  // chi-square of the bend over what was stated, and its bound
  int freedom = 0;
  double false_alarm = 0;
  bool is_contradicted = false;
};

}  // namespace spool
