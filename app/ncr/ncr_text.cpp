// The report's evidence in words and cells, the same in PDF and HTML.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/ncr/ncr_text.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "app/evidence/html_parts.h"
#include "vision/core/version.h"

namespace spool::ncr {
namespace {

std::string said(const std::string& text) { return text.empty() ? "not said" : text; }

std::string joined(const std::vector<std::string>& texts) {
  std::string all;
  for (const std::string& each : texts) all += (all.empty() ? "" : ", ") + each;
  return said(all);
}

std::string file_with_hash(const std::string& file, const std::string& sha256) {
  return said(file) + (sha256.empty() ? "" : "\nSHA-256 " + sha256);
}

// Never 1 for less than all, nor 0 for more than none.
std::string probability_text(const std::optional<double>& probability) {
  if (!probability || !std::isfinite(*probability)) return "–";
  if (*probability < 0.001) return "< 0.001";
  if (*probability > 0.999) return "> 0.999";
  return fmt::format("{:.3f}", *probability);
}

}  // namespace

std::vector<Fact> spool_facts(const NcrDocument& document) {
  const ReportEvidence& evidence = document.evidence;
  return {{"Spool (SCN)", said(document.spool)},
          {"Line", said(document.line)},
          {"Isometric revision", said(document.revision)},
          {"Weld numbers", joined(document.welds)},
          {"Heat numbers", joined(document.heats)},
          {"Result of the inspection",
           std::string(evidence::word(evidence.status)) +
               (evidence.status_reason.empty() ? std::string() : ": " + evidence.status_reason)}};
}

std::vector<Fact> source_facts(const NcrDocument& document) {
  const ReportEvidence& evidence = document.evidence;
  return {{"Design", file_with_hash(evidence.design_file, evidence.design_sha256)},
          {"Scan", file_with_hash(evidence.scan_file, evidence.scan_sha256)},
          {"Sensor", said(evidence.sensor)},
          {"Calibration", evidence.calibration_id.empty()
                              ? "none"
                              : evidence.calibration_id + " of " + said(evidence.calibration_date)},
          {"Standard", said(evidence.standard)},
          {"Datum", joined(evidence.datum) +
                        (evidence.datum_text.empty() ? "" : "\n" + evidence.datum_text)},
          {"Inspected", said(evidence.created)},
          {"Inspection's report", "report.json\nSHA-256 " + evidence.report_sha256},
          {"Inspection's software", evidence.software},
          {"Operator", said(document.operator_name)},
          {"This report made", document.created + ", SpoolSight " + std::string(version()) +
                                   ", commit " + std::string(commit())}};
}

FeatureCells feature_heads(const NcrDocument& document) {
  double k = 2;
  if (!document.evidence.features.empty()) k = document.evidence.features.front().coverage_factor;
  return {"Feature",     "Drawing", "Measured",     "Off by", fmt::format("U (k = {:g})", k),
          "Tolerance ±", "Clause",  "Prob. within", "Status"};
}

FeatureCells feature_cells(const Feature& feature, LengthStyle style) {
  std::optional<double> expanded;
  if (feature.u) expanded = *feature.u * feature.coverage_factor;
  return {feature.name + (feature.kind.empty() ? "" : " (" + feature.kind + ")"),
          number_text(feature, feature.nominal, style),
          number_text(feature, feature.measured, style),
          number_text(feature, feature.deviation, style, true),
          number_text(feature, expanded, style),
          number_text(feature, feature.tolerance, style),
          feature.clause.empty() ? "–" : feature.clause,
          probability_text(feature.probability),
          std::string(evidence::word(feature.status))};
}

std::string finding_text(const Finding& finding) {
  return finding.kind + (finding.part.empty() ? "" : ", " + finding.part) + ": " + finding.text +
         (finding.evidence.empty() ? "" : " " + finding.evidence);
}

std::string picture_text(const Picture& picture) {
  return picture.file + (picture.caption.empty() ? "" : ": " + picture.caption);
}

}  // namespace spool::ncr
