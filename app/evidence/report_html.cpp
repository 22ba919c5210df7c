// report.html: the inspection for people, one offline file for a tablet and for paper.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "app/common/length_text.h"
#include "app/evidence/html_parts.h"
#include "app/evidence/joints_report.h"
#include "app/evidence/part_pose_report.h"
#include "app/evidence/worst_first.h"
#include "app/evidence/writer.h"
#include "vision/core/version.h"

namespace spool::evidence {
namespace {

LengthStyle style_of(const InspectionRecord& record) {
  return record.feet_inches ? LengthStyle::kFeetInch : LengthStyle::kMillimetre;
}

std::string file_name(const std::string& path) {
  const auto name = std::filesystem::path(path).filename().string();
  return name.empty() ? path : name;
}

std::string count_text(std::size_t count) {
  std::string digits = std::to_string(count);
  for (std::size_t at = digits.size(); at > 3; at -= 3) digits.insert(at - 3, " ");
  return digits;
}

std::string badge(Verdict verdict) {
  return "<span class=\"badge\">" + status_shape(verdict, 26) + escaped(word(verdict)) + "</span>";
}

std::string verdict_box(const Inspection& inspection) {
  const std::string shape = status_shape(inspection.status, 72);
  // The frame takes the shape's own colour.
  const auto colour = shape.substr(shape.find("color:"), 13);
  return "<div class=\"verdict\" style=\"" + colour + "\">" + shape + "<div><div class=\"word\">" +
         escaped(word(inspection.status)) + "</div><div class=\"why\">" +
         escaped(inspection.status_reason) + "</div></div></div>\n";
}

// Nothing below is to be believed before this was read.
std::string sensor_banner(const Inspection& inspection) {
  std::string html;
  for (const Finding& finding : inspection.findings)
    if (finding.kind == "scale" && finding.part.empty())
      html += "<div class=\"note banner\"><b>" + escaped(finding.text) + "</b></div>\n";
  return html;
}

std::string warnings(const InspectionRecord& record) {
  if (record.warnings.empty()) return "";
  std::string html = "<h2>Mind</h2>\n<ul>";
  for (const auto& warning : record.warnings) html += "<li>" + escaped(warning) + "</li>\n";
  return html + "</ul>\n";
}

std::string pictures_section(const std::vector<OverlayPicture>& pictures, bool found) {
  std::string html = "<h2>Pictures</h2>\n";
  if (!found)
    return html +
           "<p>No pictures: the design was not placed on the scan, so the two would not belong "
           "together.</p>\n";
  if (pictures.empty())
    return html +
           "<p>No pictures: there was no graphics driver to draw them with. The numbers do not "
           "need it.</p>\n";
  html +=
      "<p>Measured points over the design. Blue lies inside the design's surface, red outside, "
      "grey within the noise. Dim points were not taken for the object; those that would hide it "
      "are left out.</p>\n";
  for (const auto& picture : pictures) {
    const auto png = render::encode_png(picture.image);
    html += "<figure>";
    if (png)
      html += "<img alt=\"" + escaped(picture.text) + "\" src=\"data:image/png;base64," +
              base64(*png) + "\">";
    html +=
        "<figcaption>" + escaped(picture.file + ": " + picture.text) + "</figcaption></figure>\n";
  }
  return html;
}

std::string part_rows(const Part& part, const PartFinding& finding, LengthStyle style) {
  const auto& deviation = finding.deviation;
  const bool measured = deviation.points > 0;
  const auto cell = [&](double value, bool with_sign) {
    const std::string text =
        with_sign ? signed_length_text(value, style) : length_text(value, style);
    return "<td class=\"n\">" + (measured ? escaped(text) : std::string("&ndash;")) + "</td>";
  };
  const int percent = static_cast<int>(std::lround(100 * std::clamp(deviation.coverage, 0.0, 1.0)));
  std::string html =
      "<tr class=\"head\"><td><b>" + escaped(part.name) + "</b></td><td>" +
      escaped(name(part.kind)) + "</td><td>" + badge(finding.status) +
      "</td><td class=\"n\"><span class=\"bar\"><i style=\"width:" + std::to_string(percent) +
      "%\"></i></span>" + escaped(percent_text(deviation.coverage)) + "</td><td class=\"n\">" +
      count_text(deviation.points) + "</td>";
  html += cell(deviation.mean_m, true) + cell(deviation.rms_m, false) +
          cell(deviation.p95_abs_m, false) + cell(deviation.max_abs_m, false) + "</tr>\n";
  return html + "<tr class=\"why\"><td colspan=\"9\">" +
         escaped(finding.reason + pose_words(finding.pose, style)) + "</td></tr>\n";
}

std::string parts_section(const InspectionRecord& record) {
  std::string html =
      "<h2>Parts</h2>\n<div "
      "class=\"wide\"><table><thead><tr><th>Part</th><th>Kind</th><th>Status</th>"
      "<th class=\"n\">Seen</th><th class=\"n\">Points</th><th class=\"n\">Mean</th><th "
      "class=\"n\">RMS</th>"
      "<th class=\"n\">95 % within</th><th class=\"n\">Largest</th></tr></thead><tbody>\n";
  const auto& parts = record.design->model.parts;
  std::vector<PartFinding> findings = record.inspection.parts;
  put_worst_first(findings);
  for (const auto& finding : findings)
    html += part_rows(parts.at(static_cast<std::size_t>(finding.part)), finding, style_of(record));
  return html +
         "</tbody></table></div>\n<p>Distances of measured points to the design's surface after "
         "alignment, + outside. "
         "Seen is the share of the part's surface that has measured points near.</p>\n";
}

std::string dimension_rows(const Dimension& dimension, LengthStyle style) {
  const auto text = [&](double value, bool with_sign) {
    return quantity_text(value, dimension.is_angle, style, with_sign);
  };
  const auto cell = [&](bool is_known, const std::string& value) {
    return "<td class=\"n\">" + (is_known ? escaped(value) : std::string("&ndash;")) + "</td>";
  };
  const bool measured = dimension.is_measured;
  std::string html = "<tr class=\"head\"><td><b>" + escaped(dimension.name) + "</b></td><td>" +
                     escaped(dimension.kind) + "</td><td>" + badge(dimension.status) + "</td>";
  html += cell(true, text(dimension.nominal, false)) +
          cell(measured, text(dimension.measured, false)) +
          cell(measured, text(dimension.deviation, true)) +
          cell(measured, text(2 * dimension.u.total(), false)) +
          cell(dimension.tolerance > 0, text(dimension.tolerance, false)) + "<td>" +
          escaped(dimension.rule) + "</td></tr>\n";
  return html + "<tr class=\"why\"><td colspan=\"9\">" + escaped(dimension.reason) + "</td></tr>\n";
}

std::string dimensions_section(const InspectionRecord& record) {
  std::vector<Dimension> dimensions = record.inspection.dimensions;
  if (dimensions.empty()) return "";
  put_worst_first(dimensions);
  std::string html =
      "<h2>Dimensions</h2>\n<div "
      "class=\"wide\"><table><thead><tr><th>Dimension</th><th>Kind</th><th>Status</th>"
      "<th class=\"n\">Drawing</th><th class=\"n\">Measured</th><th class=\"n\">Off by</th>"
      "<th class=\"n\">U (k = 2)</th><th class=\"n\">Allowed "
      "&plusmn;</th><th>Rule</th></tr></thead>"
      "<tbody>\n";
  for (const Dimension& dimension : dimensions) html += dimension_rows(dimension, style_of(record));
  return html +
         "</tbody></table></div>\n<p>Measured between features fitted to the points of the "
         "parts, never from a best fit over everything. Datum: " +
         escaped(record.inspection.datum) + "</p>\n";
}

std::string findings_section(const Inspection& inspection) {
  if (inspection.findings.empty()) return "";
  std::string html = "<h2>Findings</h2>\n<ul>";
  for (const auto& finding : inspection.findings)
    html += "<li><b>" + escaped(finding.kind + (finding.part.empty() ? "" : ", " + finding.part)) +
            "</b>: " + escaped(finding.text) + " " + escaped(finding.evidence) + "</li>\n";
  return html + "</ul>\n";
}

std::string other_poses(const Alignment& alignment) {
  if (alignment.ambiguous)
    return "yes, " + count_text(alignment.alternatives.size()) +
           ": which one is right cannot be told from this scan";
  const bool searched =
      alignment.method == AlignMethod::kPrincipalAxes || alignment.method == AlignMethod::kFind;
  return searched ? "none was found" : "not looked for: this one was given";
}

std::string alignment_section(const InspectionRecord& record) {
  const auto& alignment = record.inspection.alignment;
  const auto style = style_of(record);
  std::string html = "<h2>Alignment</h2>\n<table class=\"facts\">\n";
  html += row("Method", escaped(name(alignment.method)));
  if (!alignment.found)
    return html + row("Result", "not found: " + escaped(alignment.reason)) + "</table>\n";
  if (!alignment.reason.empty()) html += row("Mind", escaped(alignment.reason));
  html += row("Points on the design", escaped(percent_text(alignment.overlap)));
  html += row("Their distance to it (RMS)", escaped(length_text(alignment.rms_m, style)));
  if (!alignment.pair_residual_m.empty()) {
    std::string residuals;
    for (const double residual : alignment.pair_residual_m)
      residuals += (residuals.empty() ? "" : ", ") + length_text(residual, style);
    html += row("Picked pairs are off by", escaped(residuals));
  }
  for (const auto& weak : alignment.weak_directions)
    html += row("Not held by the scan", escaped(weak.text));
  html += row("Other poses fit as well", other_poses(alignment));
  html += row("All points to the design (RMS)",
              escaped(length_text(record.inspection.scan_rms_m, style)) +
                  ": quality of the scan, never a verdict on the spool");
  return html + "</table>\n";
}

std::string meaning_section() {
  return "<h2>What the words mean</h2>\n<table class=\"facts\">\n<tr><td>" + badge(Verdict::kOk) +
         "</td><td>Proved within tolerance.</td></tr>\n<tr><td>" + badge(Verdict::kSuspicious) +
         "</td><td>Seen, but not proved either way: the reason says what would settle it. Coloured "
         "distances to the surface are no measured dimension. Check the part by tape, square or "
         "level before it is welded or released.</td></tr>\n<tr><td>" +
         badge(Verdict::kNotOk) + "</td><td>Proved out of tolerance.</td></tr>\n<tr><td>" +
         badge(Verdict::kNotMeasured) +
         "</td><td>Too little of it was seen. Scan it from a side where it is not "
         "hidden.</td></tr>\n</table>\n"
         "<div class=\"note\">" +
         escaped(decision_rule()) + "</div>\n";
}

std::string unit_text(std::string_view unit, bool inferred) {
  return std::string(unit) + (inferred ? " (inferred from the size, not confirmed)" : "");
}

std::string sources_section(const InspectionRecord& record) {
  const auto& model = record.design->model;
  const auto& scan = record.scan;
  std::string html = "<h2>Made from</h2>\n<table class=\"facts\">\n";
  const std::string surface = model.is_cloud()
                                  ? count_text(model.cloud.size()) + " points"
                                  : count_text(model.mesh.triangles.size()) + " triangles";
  html += row("Design", escaped(model.path) + "<br>" + count_text(model.parts.size()) + " parts, " +
                            surface + ", unit " +
                            escaped(unit_text(name(model.unit), model.unit_inferred)) +
                            "<br><code>SHA-256 " + escaped(model.sha256) + "</code>");
  html += row("Scan", escaped(scan.file) + "<br>" + escaped(scan.kind) +
                          (scan.frame >= 0 ? ", frame " + std::to_string(scan.frame) : "") + ", " +
                          count_text(scan.points) + " measured points, unit " +
                          escaped(unit_text(scan.unit, scan.unit_inferred)) + "<br><code>SHA-256 " +
                          escaped(scan.sha256) + "</code>");
  html += row("Sensor", escaped(record.sensor));
  if (scan.kind != "cloud" || !record.calibration.id.empty()) {
    char scale[96];
    std::snprintf(scale, sizeof scale, ", depth scale uncertain by %.2g %%",
                  100 * record.calibration.scale_u);
    const std::string id = record.calibration.id.empty()
                               ? std::string("none")
                               : record.calibration.id + " of " + record.calibration.date;
    std::string used = id + scale;
    if (!record.calibration.warp.is_flat()) used += ", its warp is taken off the depth";
    html += row("Calibration", escaped(used));
  }
  if (const auto& check = record.inspection.scale) {
    char left[160];
    std::snprintf(left, sizeof left,
                  "%zu of known size read %+.2f %% ± %.2f %%; lengths are counted uncertain by "
                  "%.2g %%",
                  check->gauges.size(), 100 * check->found, 200 * check->found_u,
                  100 * check->scale_u);
    std::string text = left;
    if (check->correction != 0) {
      std::snprintf(left, sizeof left, " and were corrected by %+.2f %%", -100 * check->correction);
      text += left;
    }
    html += row("Pieces as gauges", escaped(text));
  }
  html += row("Standard", escaped(record.standard));
  std::string datum;
  for (const auto& part : record.datum) datum += (datum.empty() ? "" : ", ") + part;
  html += row("Datum", escaped(datum.empty() ? "none named" : datum));
  if (!record.created.empty()) html += row("Made", escaped(record.created));
  html += row("Software", "SpoolSight " + escaped(version()) + ", commit " + escaped(commit()));
  return html + "</table>\n";
}

}  // namespace

std::string report_html(const InspectionRecord& record,
                        const std::vector<OverlayPicture>& pictures) {
  const auto& model = record.design->model;
  const std::string subject = model.spool.empty() ? file_name(model.path) : model.spool;
  std::string html = page_start("Inspection of " + subject);
  html += "<h1>Inspection of " + escaped(subject) + "</h1>\n<p class=\"sub\">";
  if (!model.line.empty()) html += "line " + escaped(model.line) + " &middot; ";
  if (!model.revision.empty()) html += "revision " + escaped(model.revision) + " &middot; ";
  html += "design " + escaped(file_name(model.path)) + " &middot; scan " +
          escaped(file_name(record.scan.file));
  if (!record.created.empty()) html += " &middot; " + escaped(record.created);
  html += "</p>\n" + verdict_box(record.inspection) + sensor_banner(record.inspection) +
          warnings(record);
  html += dimensions_section(record) +
          joints_section(model, record.inspection.chain, style_of(record)) + parts_section(record) +
          findings_section(record.inspection) +
          pictures_section(pictures, record.inspection.alignment.found);
  html += alignment_section(record) + meaning_section() + sources_section(record);
  return html + "</body></html>\n";
}

}  // namespace spool::evidence
