// What is said where a scan contradicts the calibration of the sensor that made it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/measure/sensor_findings.h"

#include <cmath>
#include <cstdio>
#include <string>

namespace spool {
namespace {

std::string text_of(const char* format, double value) {
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

std::string gauges_text(const DesignModel& design, const ScaleCheck& scale) {
  std::string text;
  for (const Gauge& gauge : scale.gauges) {
    text += text.empty() ? "" : ", ";
    text += gauge.part < 0 ? std::string("scale bar")
                           : design.parts[static_cast<std::size_t>(gauge.part)].name;
    text += text_of(" %+.1f mm", 1000 * (gauge.measured_m - gauge.nominal_m)) +
            text_of(" of %.0f mm", 1000 * gauge.nominal_m);
  }
  return text;
}

Finding scale_finding(const DesignModel& design, const ScaleCheck& scale) {
  std::string text = "Pieces of known size contradict the sensor's calibration: a metre reads " +
                     text_of("%.1f mm too ", 1000 * std::abs(scale.found)) +
                     (scale.found < 0 ? "short" : "long") +
                     text_of(" ± %.1f mm", 2000 * scale.found_u);
  if (scale.range_m) text += text_of(" at %.1f m", *scale.range_m);
  text += text_of(", and it says ± %.1f mm. ", 2000 * scale.prior_u);
  text += "Nothing is ok until the sensor was calibrated anew.";
  return {"scale", "", text,
          gauges_text(design, scale) + text_of("; %.1f standard deviations", scale.statistic) +
              text_of(", of honest calibrations %.2g in 100", 100 * scale.false_alarm) +
              text_of(" exceed %.1f", scale.limit)};
}

Finding warp_finding(const WarpCheck& warp) {
  return {"scale", "",
          "What is flat contradicts the sensor's calibration: planes are bent by " +
              text_of("%.1f mm", 1000 * warp.corner_m) +
              text_of(" ± %.1f mm in the picture's corners", 2000 * warp.corner_u_m) +
              text_of(" at %.1f m", warp.range_m) +
              text_of(", and it says ± %.1f mm. ", 2000 * warp.stated_u_m) +
              "Nothing is ok until the sensor was checked on a flat wall (--sensor-check).",
          text_of("chi-square %.1f", warp.statistic) + " of " + std::to_string(warp.freedom) +
              text_of(", of honest calibrations %.2g in 100", 100 * warp.false_alarm) +
              text_of(" exceed %.1f", warp.limit)};
}

}  // namespace

std::vector<Finding> sensor_findings(const DesignModel& design, const Inspection& inspection) {
  std::vector<Finding> findings;
  if (inspection.scale && inspection.scale->is_contradicted)
    findings.push_back(scale_finding(design, *inspection.scale));
  if (inspection.warp && inspection.warp->is_contradicted)
    findings.push_back(warp_finding(*inspection.warp));
  return findings;
}

std::string sensor_doubt(const Inspection& inspection) {
  if (inspection.scale && inspection.scale->is_contradicted)
    return "But pieces of known size contradict the sensor's calibration: calibrate it anew.";
  if (inspection.warp && inspection.warp->is_contradicted)
    return "But what is flat contradicts the sensor's calibration: check it on a flat wall.";
  return "";
}

}  // namespace spool
