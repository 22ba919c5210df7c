// A non-conformance report made by hand: the orifice flange whose tap points the wrong way.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/app/ncr/sample_ncr.h"

#include <nlohmann/json.hpp>

#include "tests/support/write_file.h"

namespace spool::test {
namespace {

// Colours that run, and one that hardly packs.
render::Image stripes(int width, int height) {
  render::Image image{width, height, {}};
  for (int v = 0; v < height; ++v)
    for (int u = 0; u < width; ++u)
      for (const int value :
           {u * 255 / width, v * 255 / height, (u * 7919 + v * 104729 + u * u * v) % 251, 255})
        image.rgba.push_back(static_cast<std::uint8_t>(value));
  return image;
}

}  // namespace

std::string sample_value(const ncr::FormField& field) {
  if (field.kind == ncr::FieldKind::kChoice) return field.choices.back();
  if (field.kind == ncr::FieldKind::kSignature) return "";
  if (field.kind == ncr::FieldKind::kText) return "Text of " + field.key + ": " + kAwkward;
  return "<" + field.key + "> & é";
}

ncr::NcrDocument sample_ncr(int features) {
  ncr::NcrDocument document;
  document.form = ncr::empty_form();
  for (ncr::FormField& each : document.form) each.value = sample_value(each);
  document.spool = "SP-1 & é";
  document.line = "L<1>";
  document.revision = "2";
  document.welds = {"W1", "W2"};
  document.heats = {"flange-1: H42"};
  document.operator_name = "operator 1 <é>";
  document.created = "2026-11-29T06:15:00.250Z";
  document.bounds = {Eigen::Vector3d(1000, 2, -3), Eigen::Vector3d(1001, 3, -1)};
  ncr::ReportEvidence& evidence = document.evidence;
  evidence.report_sha256 = evidence.design_sha256 = evidence.scan_sha256 = std::string(64, 'a');
  evidence.created = "2026-11-29T06:00:00Z";
  evidence.design_file = "SP-1.spooljob/design.glb";
  evidence.scan_file = "scan.ply";
  evidence.scan_kind = "cloud";
  evidence.sensor = "cloud file";
  evidence.standard = "pfi-es3";
  evidence.datum = {"flange-2"};
  evidence.datum_text = "offsets are relative to flange-2";
  evidence.decision_rule = "ok from 0.95 on, not_ok to 0.05 (JCGM 106)";
  evidence.software = "SpoolSight 1, commit abc";
  evidence.status = Verdict::kNotOk;
  evidence.status_reason = "One dimension is out & one <cannot> be told.";
  evidence.warnings = {"a warning <w>"};
  evidence.corrections = {"Turn W1 by 90° & tack again."};
  evidence.findings = {{"one_holed", "flange-1", "The tap points N 45° down.", "tap"}};
  for (int k = 0; k < features; ++k) {
    ncr::Feature feature;
    feature.name = "feature-" + std::to_string(k) + "-é<&>-";
    while (feature.name.size() < 80) feature.name += "long";
    feature.kind = "face_to_face";
    feature.nominal = 0.5 + 0.001 * k;
    feature.measured = 0.5061 + 0.001 * k;
    feature.deviation = 0.0061;
    feature.u = 0.0005;
    feature.tolerance = 0.003;
    feature.probability = 0.001;
    feature.clause = "PFI ES-3 2.2";
    feature.status = static_cast<Verdict>(k % 4);
    feature.reason = "Off by 6.1 mm, feature " + std::to_string(k) + ".";
    if (k == 1) {
      feature.is_angle = true;
      feature.nominal = M_PI_2;
      feature.measured.reset();
      feature.deviation.reset();
    }
    evidence.features.push_back(feature);
  }
  put_worst_first(evidence.features);
  int number = 0;
  for (const char* caption : {"seen from +x -y +z", "seen by the camera <é>"}) {
    ncr::Picture picture;
    picture.file = "overlay_" + std::to_string(++number) + ".png";
    picture.caption = caption;
    picture.image = stripes(64, 40);
    picture.png = *render::encode_png(picture.image);
    picture.sha256 = std::string(64, 'b');
    evidence.pictures.push_back(picture);
  }
  ncr::set_number("JOB-F01-NCR-007", document);
  return document;
}

void write_report(const std::filesystem::path& folder, const std::string& design_sha256) {
  const nlohmann::json report = {
      {"schema", "spoolsight-report/1"},
      {"design", {{"file", "design.glb"}, {"sha256", design_sha256}}},
      {"scan", {{"file", "scan.ply"}, {"kind", "cloud"}, {"sha256", std::string(64, 'c')}}},
      {"parts",
       {{{"name", "pipe-1"},
         {"size_checks",
          {{{"quantity", "outside_diameter"},
            {"nominal_m", 0.1},
            {"measured_m", 0.102},
            {"u_m", 0.0005},
            {"status", "suspicious"}}}}}}},
      {"dimensions",
       {{{"name", "flange-1/a to pipe-1/b"},
         {"kind", "face_to_face"},
         {"nominal_m", 0.3},
         {"measured_m", 0.303},
         {"deviation_m", 0.003},
         {"u_m", 0.0004},
         {"tolerance_m", 0.003},
         {"coverage_factor", 2},
         {"conformance_probability", 0.5},
         {"rule", "PFI ES-3 2.2"},
         {"status", "ok"}},
        {{"name", "flange-1/holes"},
         {"kind", "rotation"},
         {"nominal_rad", 0},
         {"measured_rad", M_PI_2},
         {"deviation_rad", M_PI_2},
         {"u_rad", 0.004},
         {"tolerance_rad", 0.003},
         {"conformance_probability", 0},
         {"rule", "PFI ES-3 3.1"},
         {"status", "not_ok"},
         {"reason", "Turned by 90°."}}}},
      {"bumps", {{{"part", "flange-1"}, {"text", "Turn flange-1 by 90°."}}}},
      {"findings",
       {{{"kind", "one_holed"},
         {"part", "flange-1"},
         {"text", "Turned & so."},
         {"evidence", "e"}}}},
      {"status", "not_ok"},
      {"status_reason", "One is out."},
      {"decision_rule", "rule of decision"},
      {"standard", "pfi-es3"},
      {"datum", {"flange-1"}},
      {"warnings", {"mind this"}},
      {"software", {{"name", "SpoolSight"}, {"version", "1"}, {"commit", "abc"}}},
      {"sensor",
       {{"description", "cloud file"},
        {"calibration", {{"id", "cal-7"}, {"date", "2026-11-01"}}}}}};
  write_file(folder / "report.json", report.dump());
  write_file(folder / "report.html",
             "<figcaption>overlay_1.png: seen from +x &amp; &lt;y&gt;</figcaption>"
             "<figcaption>overlay_2.png: seen from -z</figcaption>");
  for (const char* file : {"overlay_1.png", "overlay_2.png"})
    write_file(folder / file, *render::encode_png(stripes(320, 200)));
}

}  // namespace spool::test
