// What an inspection's folder says, as far as a non-conformance report shows it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/ncr/report_evidence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "app/common/json_file.h"
#include "vision/core/file_digest.h"
#include "vision/core/file_io.h"

namespace spool::ncr {
namespace {

using nlohmann::json;

constexpr std::uint64_t kMaxBytes = std::uint64_t{64} << 20;

const json& member(const json& object, const char* key) {
  static const json none;
  if (!object.is_object()) return none;
  const auto found = object.find(key);
  return found == object.end() ? none : *found;
}

std::string text_of(const json& object, const char* key) {
  const json& value = member(object, key);
  return value.is_string() ? value.get<std::string>() : std::string();
}

std::optional<double> number_of(const json& object, const std::string& key) {
  const json& value = member(object, key.c_str());
  if (!value.is_number()) return std::nullopt;
  return value.get<double>();
}

std::vector<std::string> texts_of(const json& object, const char* key) {
  std::vector<std::string> texts;
  for (const json& each : member(object, key))
    if (each.is_string()) texts.push_back(each.get<std::string>());
  return texts;
}

Verdict verdict_of(const json& object) {
  const std::string text = text_of(object, "status");
  for (const Verdict each : {Verdict::kOk, Verdict::kSuspicious, Verdict::kNotOk})
    if (text == name(each)) return each;
  return Verdict::kNotMeasured;
}

Feature dimension_of(const json& entry) {
  Feature feature;
  feature.name = text_of(entry, "name");
  feature.kind = text_of(entry, "kind");
  feature.is_angle = entry.contains("nominal_rad");
  const std::string end = feature.is_angle ? "_rad" : "_m";
  feature.nominal = number_of(entry, "nominal" + end);
  feature.measured = number_of(entry, "measured" + end);
  feature.deviation = number_of(entry, "deviation" + end);
  feature.u = number_of(entry, "u" + end);
  feature.coverage_factor = number_of(entry, "coverage_factor").value_or(2);
  feature.tolerance = number_of(entry, "tolerance" + end);
  feature.probability = number_of(entry, "conformance_probability");
  feature.clause = text_of(entry, "rule");
  feature.status = verdict_of(entry);
  feature.reason = text_of(entry, "reason");
  return feature;
}

Feature size_of(const json& entry, const std::string& part) {
  Feature feature;
  feature.name = part + ": " + text_of(entry, "quantity");
  feature.kind = "size";
  feature.nominal = number_of(entry, "nominal_m");
  feature.measured = number_of(entry, "measured_m");
  if (feature.nominal && feature.measured) feature.deviation = *feature.measured - *feature.nominal;
  feature.u = number_of(entry, "u_m");
  feature.status = verdict_of(entry);
  feature.reason = text_of(entry, "reason");
  return feature;
}

std::string unescaped(std::string text) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 5> kEntities{
      {{"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&#39;", "'"}, {"&amp;", "&"}}};
  for (const auto& [entity, letter] : kEntities)
    for (auto at = text.find(entity); at != std::string::npos;
         at = text.find(entity, at + letter.size()))
      text.replace(at, entity.size(), letter);
  return text;
}

// "overlay_1.png" to "seen from +x -y +z", out of the captions of report.html.
std::map<std::string, std::string> captions_of(const std::filesystem::path& html) {
  std::map<std::string, std::string> captions;
  const auto text = read_file(html, kMaxBytes);
  if (!text) return captions;
  constexpr std::string_view kStart = "<figcaption>";
  for (auto at = text->find(kStart); at != std::string::npos; at = text->find(kStart, at)) {
    at += kStart.size();
    const auto end = text->find("</figcaption>", at);
    if (end == std::string::npos) break;
    const std::string caption = unescaped(text->substr(at, end - at));
    const auto colon = caption.find(": ");
    if (colon != std::string::npos) captions[caption.substr(0, colon)] = caption.substr(colon + 2);
  }
  return captions;
}

Status read_pictures(const std::filesystem::path& folder, std::vector<Picture>& pictures) {
  const auto captions = captions_of(folder / "report.html");
  for (int k = 1;; ++k) {
    Picture picture;
    picture.file = "overlay_" + std::to_string(k) + ".png";
    std::error_code code;
    if (!std::filesystem::exists(folder / picture.file, code)) return {};
    auto png = read_file(folder / picture.file, kMaxBytes);
    if (!png) return png.error();
    auto image = render::decode_png(*png);
    if (!image)
      return Error{image.error().code, (folder / picture.file).string() + ": is no whole PNG"};
    picture.image = *std::move(image);
    picture.sha256 = sha256_hex(*png);
    picture.png = *std::move(png);
    if (const auto at = captions.find(picture.file); at != captions.end())
      picture.caption = at->second;
    pictures.push_back(std::move(picture));
  }
}

void read_sources(const json& report, ReportEvidence& evidence) {
  evidence.created = text_of(report, "created");
  evidence.design_file = text_of(member(report, "design"), "file");
  evidence.design_sha256 = text_of(member(report, "design"), "sha256");
  const json& scan = member(report, "scan");
  evidence.scan_file = text_of(scan, "file");
  evidence.scan_kind = text_of(scan, "kind");
  evidence.scan_sha256 = text_of(scan, "sha256");
  const json& sensor = member(report, "sensor");
  evidence.sensor = text_of(sensor, "description");
  evidence.calibration_id = text_of(member(sensor, "calibration"), "id");
  evidence.calibration_date = text_of(member(sensor, "calibration"), "date");
  evidence.standard = text_of(report, "standard");
  evidence.datum = texts_of(report, "datum");
  evidence.datum_text = text_of(report, "datum_text");
  evidence.decision_rule = text_of(report, "decision_rule");
  const json& software = member(report, "software");
  evidence.software = text_of(software, "name") + " " + text_of(software, "version") + ", commit " +
                      text_of(software, "commit");
}

void read_results(const json& report, ReportEvidence& evidence) {
  evidence.status = verdict_of(report);
  evidence.status_reason = text_of(report, "status_reason");
  evidence.warnings = texts_of(report, "warnings");
  for (const json& each : member(report, "bumps"))
    if (!text_of(each, "text").empty()) evidence.corrections.push_back(text_of(each, "text"));
  for (const json& each : member(report, "findings"))
    evidence.findings.push_back({text_of(each, "kind"), text_of(each, "part"),
                                 text_of(each, "text"), text_of(each, "evidence")});
  for (const json& each : member(report, "dimensions"))
    if (each.is_object()) evidence.features.push_back(dimension_of(each));
  for (const json& part : member(report, "parts"))
    for (const json& each : member(part, "size_checks"))
      if (each.is_object()) evidence.features.push_back(size_of(each, text_of(part, "name")));
  put_worst_first(evidence.features);
}

}  // namespace

void put_worst_first(std::vector<Feature>& features) {
  const auto off = [](const Feature& each) {
    return each.deviation && each.tolerance && *each.tolerance > 0
               ? std::abs(*each.deviation) / *each.tolerance
               : 0.0;
  };
  std::stable_sort(features.begin(), features.end(), [&](const Feature& a, const Feature& b) {
    if (a.status != b.status) return worse(a.status, b.status) == a.status;
    const double p_a = a.probability.value_or(2), p_b = b.probability.value_or(2);
    return p_a != p_b ? p_a < p_b : off(a) > off(b);
  });
}

Result<ReportEvidence> read_evidence(const std::filesystem::path& folder,
                                     const std::string& design_sha256) {
  const std::filesystem::path path = folder / "report.json";
  const auto bytes = read_file(path, kMaxBytes);
  if (!bytes) return bytes.error();
  const auto report = parse_json(*bytes, path.string());
  if (!report) return report.error();
  const auto refuse = [&](const std::string& why) {
    return Error{ErrorCode::kBadInput, path.string() + ": " + why};
  };
  if (text_of(*report, "schema") != "spoolsight-report/1")
    return refuse("is no report of spoolsight-inspect (schema spoolsight-report/1)");
  ReportEvidence evidence;
  evidence.report_sha256 = sha256_hex(*bytes);
  read_sources(*report, evidence);
  if (evidence.design_sha256 != design_sha256)
    return refuse("is of another design; inspect against the job's own design.glb");
  read_results(*report, evidence);
  if (Status done = read_pictures(folder, evidence.pictures); !done) return done.error();
  return evidence;
}

}  // namespace spool::ncr
