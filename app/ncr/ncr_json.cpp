// The report as JSON for other programs.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/ncr/ncr_json.h"

#include <cmath>

#include "app/common/json_file.h"
#include "vision/core/version.h"

namespace spool::ncr {
namespace {

using nlohmann::json;

json form_json(const std::vector<FormField>& form) {
  json list = json::array();
  for (const FormField& each : form) {
    json entry = {{"key", each.key},
                  {"block", each.block},
                  {"label", each.label},
                  {"kind", name(each.kind)},
                  {"source", name(each.source)},
                  {"value", each.value.empty() ? json(nullptr) : json(each.value)}};
    if (!each.who.empty()) entry["who"] = each.who;
    if (!each.choices.empty()) entry["choices"] = each.choices;
    list.push_back(std::move(entry));
  }
  return list;
}

json feature_json(const Feature& feature) {
  const std::string unit = feature.is_angle ? "_rad" : "_m";
  json object = {{"name", feature.name},     {"kind", feature.kind},
                 {"clause", feature.clause}, {"status", name(feature.status)},
                 {"reason", feature.reason}, {"coverage_factor", feature.coverage_factor}};
  const auto add = [&](const char* key, const std::optional<double>& value,
                       const std::string& end) {
    if (value && std::isfinite(*value)) object[key + end] = *value;
  };
  add("nominal", feature.nominal, unit);
  add("measured", feature.measured, unit);
  add("deviation", feature.deviation, unit);
  add("u", feature.u, unit);
  add("tolerance", feature.tolerance, unit);
  add("conformance_probability", feature.probability, "");
  return object;
}

}  // namespace

std::string ncr_json(const NcrDocument& document) {
  const ReportEvidence& evidence = document.evidence;
  json features = json::array(), findings = json::array(), pictures = json::array();
  for (const Feature& each : evidence.features) features.push_back(feature_json(each));
  for (const Finding& each : evidence.findings)
    findings.push_back({{"kind", each.kind},
                        {"part", each.part},
                        {"text", each.text},
                        {"evidence", each.evidence}});
  for (const Picture& each : evidence.pictures)
    pictures.push_back({{"file", each.file}, {"caption", each.caption}, {"sha256", each.sha256}});
  return json_text(
      {{"schema", "spoolsight-ncr/1"},
       {"number", document.number},
       {"created", document.created},
       {"operator", document.operator_name},
       {"spool", document.spool},
       {"line", document.line},
       {"revision", document.revision},
       {"welds", document.welds},
       {"heats", document.heats},
       {"form", form_json(document.form)},
       {"status", name(evidence.status)},
       {"status_reason", evidence.status_reason},
       {"findings", findings},
       {"corrections", evidence.corrections},
       {"features", features},
       {"pictures", pictures},
       {"decision_rule", evidence.decision_rule},
       {"standard", evidence.standard},
       {"datum", evidence.datum},
       {"datum_text", evidence.datum_text},
       {"warnings", evidence.warnings},
       {"inspection",
        {{"created", evidence.created},
         {"report_sha256", evidence.report_sha256},
         {"design_file", evidence.design_file},
         {"design_sha256", evidence.design_sha256},
         {"scan_file", evidence.scan_file},
         {"scan_kind", evidence.scan_kind},
         {"scan_sha256", evidence.scan_sha256},
         {"sensor", evidence.sensor},
         {"calibration_id", evidence.calibration_id},
         {"calibration_date", evidence.calibration_date},
         {"software", evidence.software}}},
       {"software", {{"name", "SpoolSight"}, {"version", version()}, {"commit", commit()}}}});
}

}  // namespace spool::ncr
