// The report as one HTML file with its pictures inside.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/ncr/ncr_html.h"

#include "app/evidence/html_parts.h"
#include "app/ncr/ncr_text.h"

namespace spool::ncr {
namespace {

using evidence::escaped;

// Line ends of a text as line ends of the page.
std::string lines(const std::string& text) {
  std::string html;
  std::size_t at = 0;
  for (auto end = text.find('\n'); end != std::string::npos; end = text.find('\n', at)) {
    html += escaped(text.substr(at, end - at)) + "<br>";
    at = end + 1;
  }
  return html + escaped(text.substr(at));
}

std::string value_of(const FormField& field) {
  if (field.kind == FieldKind::kChoice) {
    std::string html;
    for (const std::string& each : field.choices)
      html +=
          std::string(each == field.value ? "&#9746; " : "&#9744; ") + escaped(each) + " &nbsp; ";
    return html;
  }
  if (field.value.empty()) return "<i>" + escaped(kToFillIn) + "</i>";
  return lines(field.value);
}

std::string form_section(const NcrDocument& document) {
  std::string html;
  for (const FormBlock& block : form_blocks()) {
    if (block.key != "head") html += "<h2>" + escaped(block.title) + "</h2>\n";
    html += "<table class=\"facts\">\n";
    for (const FormField& each : document.form)
      if (each.block == block.key)
        html +=
            evidence::row((each.who.empty() ? "" : each.who + ": ") + each.label, value_of(each));
    html += "</table>\n";
  }
  return html;
}

std::string facts_section(const std::string& title, const std::vector<Fact>& facts) {
  std::string html = "<h2>" + escaped(title) + "</h2>\n<table class=\"facts\">\n";
  for (const auto& [label, value] : facts) html += evidence::row(label, lines(value));
  return html + "</table>\n";
}

std::string list_section(const std::string& title, const std::vector<std::string>& texts) {
  if (texts.empty()) return "";
  std::string html = "<h2>" + escaped(title) + "</h2>\n<ul>";
  for (const std::string& each : texts) html += "<li>" + escaped(each) + "</li>\n";
  return html + "</ul>\n";
}

std::string pictures_section(const NcrDocument& document) {
  if (document.evidence.pictures.empty()) return "";
  std::string html = "<h2>Pictures</h2>\n";
  for (const Picture& each : document.evidence.pictures)
    html += "<figure><img alt=\"" + escaped(picture_text(each)) +
            "\" src=\"data:image/png;base64," + evidence::base64(each.png) + "\"><figcaption>" +
            escaped(picture_text(each)) + "</figcaption></figure>\n";
  return html;
}

std::string features_section(const NcrDocument& document) {
  std::string html = "<h2>Features, worst first</h2>\n<div class=\"wide\"><table><thead><tr>";
  for (const std::string& each : feature_heads(document)) html += "<th>" + escaped(each) + "</th>";
  html += "</tr></thead><tbody>\n";
  for (const Feature& each : document.evidence.features) {
    const FeatureCells cells = feature_cells(each, document.lengths);
    html += "<tr class=\"head\">";
    for (std::size_t c = 0; c + 1 < cells.size(); ++c)
      html += std::string(c == 0            ? "<td><b>"
                          : c < 6 || c == 7 ? "<td class=\"n\">"
                                            : "<td>") +
              escaped(cells[c]) + (c == 0 ? "</b></td>" : "</td>");
    html += "<td><span class=\"badge\">" + evidence::status_shape(each.status, 26) +
            escaped(cells.back()) + "</span></td></tr>\n<tr class=\"why\"><td colspan=\"9\">" +
            escaped(each.reason) + "</td></tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

}  // namespace

std::string ncr_html(const NcrDocument& document) {
  std::string html = evidence::page_start(document.number);
  html += "<h1>Non-Conformance Report " + escaped(document.number) + "</h1>\n";
  html += form_section(document);
  html += facts_section("Evidence: the spool", spool_facts(document));
  std::vector<std::string> findings;
  for (const Finding& each : document.evidence.findings) findings.push_back(finding_text(each));
  html += list_section("Findings", findings);
  html += list_section("What would put it right", document.evidence.corrections);
  html += pictures_section(document) + features_section(document);
  html += "<h2>Decision rule</h2>\n<div class=\"note\">" +
          escaped(document.evidence.decision_rule) + "</div>\n";
  html += list_section("Mind", document.evidence.warnings);
  html += facts_section("Made from", source_facts(document));
  return html + "</body></html>\n";
}

}  // namespace spool::ncr
