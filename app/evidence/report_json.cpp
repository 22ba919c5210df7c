// report.json: the inspection for scripts and shops, as ARCHITECTURE, What inspect writes fixes it
// (schema spoolsight- report/1).
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <nlohmann/json.hpp>

#include "app/common/json_file.h"
#include "app/evidence/joints_report.h"
#include "app/evidence/part_pose_report.h"
#include "app/evidence/writer.h"
#include "vision/core/version.h"

namespace spool::evidence {
namespace {

using nlohmann::json;

// JSON knows no NaN and no infinity: what is no number is null, never a number that was not
// measured.
json number(double value) { return std::isfinite(value) ? json(value) : json(nullptr); }

json matrix36(const Matrix6d& matrix) {
  json list = json::array();
  for (int row = 0; row < 6; ++row)
    for (int column = 0; column < 6; ++column) list.push_back(number(matrix(row, column)));
  return list;
}

std::string_view declutter_name(DeclutterMethod method) {
  switch (method) {
    case DeclutterMethod::kThreeClasses:
      return "three-classes";
    case DeclutterMethod::kKnnRatio:
      return "knn-ratio";
    case DeclutterMethod::kKnnClosedForm:
      break;
  }
  return "knn-closed-form";
}

json design_json(const DesignModel& model) {
  return {{"file", model.path},
          {"sha256", model.sha256},
          {"parts", model.parts.size()},
          {"triangles", model.mesh.triangles.size()},
          {"points", model.cloud.size()},
          {"unit", name(model.unit)},
          {"unit_inferred", model.unit_inferred}};
}

json scan_json(const ScanRecord& scan, std::size_t points_in) {
  json object = {{"file", scan.file},
                 {"sha256", scan.sha256},
                 {"kind", scan.kind},
                 {"points", points_in},
                 {"points_measured", scan.points},
                 {"unit", scan.unit},
                 {"unit_inferred", scan.unit_inferred}};
  if (scan.frame >= 0) {
    object["frame"] = scan.frame;
    object["frames_used"] = 1;
  }
  return object;
}

json weak_directions_json(const std::vector<WeakDirection>& directions) {
  json list = json::array();
  for (const auto& weak : directions) {
    json direction = json::array();
    for (int i = 0; i < 6; ++i) direction.push_back(number(weak.direction(i)));
    list.push_back({{"direction", direction}, {"sigma", number(weak.sigma)}, {"text", weak.text}});
  }
  return list;
}

json alignment_json(const Alignment& alignment) {
  json alternatives = json::array();
  for (const auto& pose : alignment.alternatives)
    alternatives.push_back({{"T_design_scan", row_major(pose)}});
  json residuals = json::array();
  for (const double residual : alignment.pair_residual_m) residuals.push_back(number(residual));
  return {
      {"method", name(alignment.method)},
      {"found", alignment.found},
      {"reason", alignment.reason},
      {"T_design_scan", alignment.found ? json(row_major(alignment.T_design_scan)) : json(nullptr)},
      {"covariance", matrix36(alignment.covariance)},
      {"weak_directions", weak_directions_json(alignment.weak_directions)},
      {"rms_m", alignment.overlap > 0 ? number(alignment.rms_m) : json(nullptr)},
      {"overlap", number(alignment.overlap)},
      {"ambiguous", alignment.ambiguous},
      {"alternatives", alternatives},
      {"pair_residual_m", residuals},
      {"seconds", number(alignment.seconds)}};
}

json declutter_json(const DeclutterResult& declutter) {
  return {{"method", declutter_name(declutter.method)},
          {"k", declutter.k},
          {"points_in", declutter.classes.size()},
          {"points_object", declutter.object},
          {"points_clutter", declutter.clutter},
          {"points_contradicting", declutter.contradicting}};
}

json over_frames_json(const PartReading& reading) {
  return {{"mean_m", reading.is_seen ? number(reading.mean_m) : json(nullptr)},
          {"u_m", reading.is_seen ? number(reading.u_m) : json(nullptr)},
          {"coverage", number(reading.coverage)}};
}

json size_checks_json(const std::vector<SizeCheck>& checks) {
  json list = json::array();
  for (const SizeCheck& check : checks)
    list.push_back({{"quantity", check.quantity},
                    {"nominal_m", number(check.nominal_m)},
                    {"measured_m", number(check.measured_m)},
                    {"u_m", number(check.u_m)},
                    {"status", name(check.status)},
                    {"reason", check.reason}});
  return list;
}

// Expanded uncertainties are printed as U = k u with this k.
constexpr double kCoverageFactor = 2;

json dimension_json(const Dimension& dimension) {
  const std::string unit = dimension.is_angle ? "_rad" : "_m";
  json object = {{"name", dimension.name},     {"kind", dimension.kind},
                 {"from", dimension.from},     {"to", dimension.to},
                 {"rule", dimension.rule},     {"status", name(dimension.status)},
                 {"reason", dimension.reason}, {"nominal" + unit, number(dimension.nominal)}};
  if (dimension.tolerance > 0) object["tolerance" + unit] = number(dimension.tolerance);
  if (!dimension.is_measured) return object;
  const UncertaintyBudget& u = dimension.u;
  object["measured" + unit] = number(dimension.measured);
  object["deviation" + unit] = number(dimension.deviation);
  object["u" + unit] = number(u.total());
  object["coverage_factor"] = kCoverageFactor;
  object["budget" + unit] = {
      {"fit", number(u.fit)}, {"scale", number(u.scale)}, {"warp", number(u.warp)}};
  if (dimension.tolerance > 0) object["conformance_probability"] = number(dimension.probability);
  return object;
}

json dimensions_json(const std::vector<Dimension>& dimensions) {
  json list = json::array();
  for (const Dimension& dimension : dimensions) list.push_back(dimension_json(dimension));
  return list;
}

json scale_check_json(const ScaleCheck& check) {
  json gauges = json::array();
  for (const Gauge& gauge : check.gauges)
    gauges.push_back({{"kind", name(gauge.kind)},
                      {"part", gauge.part},
                      {"nominal_m", number(gauge.nominal_m)},
                      {"measured_m", number(gauge.measured_m)},
                      {"u_m", number(std::hypot(gauge.u_m, gauge.tolerance_u_m))},
                      {"range_m", gauge.range_m ? number(*gauge.range_m) : json(nullptr)}});
  return {{"gauges", gauges},
          {"found", number(check.found)},
          {"found_u", number(check.found_u)},
          {"range_m", check.range_m ? number(*check.range_m) : json(nullptr)},
          {"a", number(check.a)},
          {"b_per_m", number(check.b_per_m)},
          {"correction", number(check.correction)},
          {"scale_u", number(check.scale_u)},
          {"statistic", number(check.statistic)},
          {"limit", number(check.limit)},
          {"false_alarm", number(check.false_alarm)},
          {"contradicted", check.is_contradicted}};
}

json warp_check_json(const WarpCheck& check) {
  return {{"corner_m", number(check.corner_m)},   {"corner_u_m", number(check.corner_u_m)},
          {"range_m", number(check.range_m)},     {"statistic", number(check.statistic)},
          {"limit", number(check.limit)},         {"false_alarm", number(check.false_alarm)},
          {"contradicted", check.is_contradicted}};
}

json sensor_json(const InspectionRecord& record) {
  const Inspection& inspection = record.inspection;
  json sensor = {{"description", record.sensor},
                 {"calibration", calibration_to_json(record.calibration)}};
  if (inspection.scale) sensor["scale_check"] = scale_check_json(*inspection.scale);
  if (inspection.warp) sensor["warp_check"] = warp_check_json(*inspection.warp);
  return sensor;
}

json part_json(const Part& part, const PartFinding& finding) {
  const auto& deviation = finding.deviation;
  const auto measured = [&](double value) {
    return deviation.points > 0 ? number(value) : json(nullptr);
  };
  return {{"name", part.name},
          {"kind", name(part.kind)},
          {"status", name(finding.status)},
          {"reason", finding.reason},
          {"coverage", number(deviation.coverage)},
          {"points", deviation.points},
          {"deviation",
           {{"mean_m", measured(deviation.mean_m)},
            {"rms_m", measured(deviation.rms_m)},
            {"p95_abs_m", measured(deviation.p95_abs_m)},
            {"max_abs_m", measured(deviation.max_abs_m)}}},
          {"size_checks", size_checks_json(finding.size_checks)},
          {"pose_error", pose_error_json(finding.pose)},
          {"pose_error_reason", finding.pose.reason}};
}

}  // namespace

std::string decision_rule() {
  return "Dimensions are measured between features fitted to the parts and compared with their "
         "tolerance by the probability of lying within it (JCGM 106): ok from 0.95 on, not_ok to "
         "0.05, suspicious between, not_measured where a feature is missing; U = 2 u. A part that "
         "answers for a dimension that is not_ok, is of another size, or sits at a joint that is "
         "turned, of the wrong length or exchanged, is not_ok; else it is as its worst dimension; "
         "one without a dimension, or on which steel too many sits, is suspicious; one of which "
         "too little was seen is not_measured.";
}

std::string report_json(const InspectionRecord& record) {
  const auto& model = record.design->model;
  const auto& inspection = record.inspection;
  json parts = json::array();
  for (const auto& finding : inspection.parts) {
    const auto part = static_cast<std::size_t>(finding.part);
    parts.push_back(part_json(model.parts.at(part), finding));
    if (part < record.over_frames.size())
      parts.back()["over_frames"] = over_frames_json(record.over_frames[part]);
  }
  json findings = json::array();
  for (const auto& finding : inspection.findings)
    findings.push_back({{"kind", finding.kind},
                        {"part", finding.part},
                        {"text", finding.text},
                        {"evidence", finding.evidence}});
  json timing = json::object();
  for (const auto& [stage, seconds] : inspection.timing_s) timing[stage] = number(seconds);
  json report = {
      {"schema", "spoolsight-report/1"},
      {"design", design_json(model)},
      {"scan", scan_json(record.scan, inspection.scan_design.size())},
      {"alignment", alignment_json(inspection.alignment)},
      {"declutter", declutter_json(inspection.declutter)},
      {"parts", parts},
      {"dimensions", dimensions_json(inspection.dimensions)},
      {"joints", joints_json(inspection.chain)},
      {"joints_not_measured", joints_not_measured_json(inspection.chain)},
      {"chain", chain_json(inspection.chain)},
      {"bumps", bumps_json(model, inspection.chain)},
      {"fit_up", fit_up_json(inspection.chain)},
      {"findings", findings},
      {"status", name(inspection.status)},
      {"status_reason", inspection.status_reason},
      {"scan_quality",
       {{"rms_m", inspection.declutter.object > 0 ? number(inspection.scan_rms_m) : json(nullptr)},
        {"noise_m", number(record.noise_m)}}},
      {"decision_rule", decision_rule()},
      {"standard", record.standard},
      {"datum", record.datum},
      {"datum_text", inspection.datum},
      {"warnings", record.warnings},
      {"software", {{"name", "SpoolSight"}, {"version", version()}, {"commit", commit()}}},
      {"sensor", sensor_json(record)},
      {"timing_s", timing}};
  if (!record.created.empty()) report["created"] = record.created;
  if (!record.options.empty()) report["options"] = record.options;
  return json_text(report);
}

}  // namespace spool::evidence
