// What an inspection's folder says, as far as a non-conformance report shows it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "render/image.h"
#include "vision/core/result.h"
#include "vision/inspect/inspection.h"

namespace spool::ncr {

// A number of the drawing beside what was measured. Lengths m, angles rad; missing where the report
// has none.
struct Feature {
  std::string name, kind;
  bool is_angle = false;
  std::optional<double> nominal, measured, deviation;
  std::optional<double> u;  // standard uncertainty
  double coverage_factor = 2;
  std::optional<double> tolerance;    // either way
  std::optional<double> probability;  // of lying within the tolerance
  std::string clause;
  Verdict status = Verdict::kNotMeasured;
  std::string reason;
};

struct Picture {
  std::string file, caption, sha256;
  std::string png;  // bytes
  render::Image image;
};

struct Finding {
  std::string kind, part, text, evidence;
};

struct ReportEvidence {
  std::string report_sha256;
  std::string created;  // ISO 8601, UTC; "" not said
  std::string design_file, design_sha256;
  std::string scan_file, scan_kind, scan_sha256;
  std::string sensor, calibration_id, calibration_date;  // "" uncalibrated
  std::string standard, datum_text, decision_rule, software;
  std::vector<std::string> datum;
  Verdict status = Verdict::kNotMeasured;
  std::string status_reason;
  std::vector<std::string> warnings, corrections;  // corrections: the report's bumps in words
  std::vector<Finding> findings;
  std::vector<Feature> features;  // worst first
  std::vector<Picture> pictures;
};

// Reads report.json, overlay_*.png and, of report.html, their captions. kBadInput: no report of
// spoolsight-inspect, one of another design than `design_sha256`, a picture that is none. A missing
// report.html leaves captions empty. Any thread.
[[nodiscard]] Result<ReportEvidence> read_evidence(const std::filesystem::path& folder,
                                                   const std::string& design_sha256);

// The worst first: status, then how unlikely it is within tolerance, then how far it is off against
// its tolerance.
void put_worst_first(std::vector<Feature>& features);

}  // namespace spool::ncr
