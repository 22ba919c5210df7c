// The report as PDF: the form's page, then pages of evidence.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/ncr/ncr_pdf.h"

#include <algorithm>
#include <array>
#include <memory>

#include "app/ncr/form_pages.h"
#include "app/ncr/ncr_text.h"
#include "app/ncr/page_flow.h"

namespace spool::ncr {
namespace {

using isometric::PageCanvas;
using isometric::TextAlign;
using isometric::wrapped_lines;

void lay_out_facts(const std::vector<Fact>& facts, PageFlow& flow) {
  constexpr double kLabelWidth_mm = 42;
  for (const auto& [label, value] : facts) {
    const auto lines = wrapped_lines(value, kSmall_mm, kWidth_mm - kLabelWidth_mm);
    bool is_first = true;
    for (const std::string& each : lines) {
      flow.need(line_mm(kSmall_mm));
      const double y = flow.y() + 0.5 * line_mm(kSmall_mm);
      if (is_first) flow.text(label, kSide_mm, y, kSmall_mm, true);
      is_first = false;
      flow.text(each, kSide_mm + kLabelWidth_mm, y, kSmall_mm);
      flow.skip(line_mm(kSmall_mm));
    }
    flow.skip(0.8);
  }
}

void lay_out_list(const std::string& title, const std::vector<std::string>& texts, PageFlow& flow) {
  if (texts.empty()) return;
  flow.title(title);
  for (const std::string& each : texts) {
    flow.paragraph("• " + each, kSmall_mm + 0.2);
    flow.skip(0.8);
  }
}

void lay_out_pictures(const std::vector<Picture>& pictures, PageFlow& flow) {
  if (pictures.empty()) return;
  flow.title("Pictures");
  flow.paragraph(
      "Measured points over the design. Blue lies inside the design's surface, red outside, grey "
      "within the noise; hatched steel contradicts the design.",
      kSmall_mm);
  flow.skip(1.5);
  for (const Picture& each : pictures) {
    constexpr double kHighest_mm = 92;  // two on a page, also below the facts
    if (each.image.width <= 0 || each.image.height <= 0) continue;
    const double scale = std::min(kWidth_mm / each.image.width, kHighest_mm / each.image.height);
    const double width = scale * each.image.width, height = scale * each.image.height;
    const auto caption = wrapped_lines(picture_text(each), kSmall_mm, kWidth_mm);
    flow.need(height + static_cast<double>(caption.size()) * line_mm(kSmall_mm) + 4);
    const double x = kSide_mm + 0.5 * (kWidth_mm - width), y = flow.y();
    const auto image = std::make_shared<const render::Image>(each.image);
    flow.draw([=](PageCanvas& page) { page.image(*image, x, y, width, height); });
    flow.box(x, y, width, height);
    flow.skip(height + 1.5);
    for (const std::string& line : caption) {
      flow.text(line, kSide_mm, flow.y() + 0.5 * line_mm(kSmall_mm), kSmall_mm);
      flow.skip(line_mm(kSmall_mm));
    }
    flow.skip(3);
  }
}

// Widths in mm, of the columns of FeatureCells; their sum is kWidth_mm.
constexpr std::array<double, kFeatureColumns> kColumns{47, 19, 19, 17, 16, 18, 22, 13, 15};
constexpr double kCellLetters_mm = 1.9;

bool is_number(std::size_t column) { return (column >= 1 && column <= 5) || column == 7; }

struct TableRow {
  std::array<std::vector<std::string>, kFeatureColumns> cells;
  std::vector<std::string> reason;
  double height = 0;
};

TableRow row_of(const FeatureCells& cells, const std::string& reason, bool is_bold) {
  TableRow row;
  std::size_t most = 1;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    row.cells[c] = wrapped_lines(cells[c], kCellLetters_mm, kColumns[c] - 1.6,
                                 is_bold || c == 0 || c + 1 == cells.size());
    most = std::max(most, row.cells[c].size());
  }
  row.reason = wrapped_lines(reason, kCellLetters_mm, kWidth_mm - 6);
  row.height = static_cast<double>(most + row.reason.size()) * line_mm(kCellLetters_mm) + 1.6;
  return row;
}

void draw_row(const TableRow& row, bool is_bold, PageFlow& flow) {
  double x = kSide_mm;
  std::size_t most = 1;
  const double line = line_mm(kCellLetters_mm), top = flow.y() + 0.8;
  for (std::size_t c = 0; c < row.cells.size(); ++c) {
    for (std::size_t k = 0; k < row.cells[c].size(); ++k) {
      const double y = top + (static_cast<double>(k) + 0.5) * line;
      flow.text(row.cells[c][k], is_number(c) ? x + kColumns[c] - 0.8 : x + 0.8, y, kCellLetters_mm,
                is_bold || c == 0 || c + 1 == row.cells.size(),
                is_number(c) ? TextAlign::kRight : TextAlign::kLeft);
    }
    most = std::max(most, row.cells[c].size());
    x += kColumns[c];
  }
  for (std::size_t k = 0; k < row.reason.size(); ++k)
    flow.text(row.reason[k], kSide_mm + 4, top + (static_cast<double>(most + k) + 0.5) * line,
              kCellLetters_mm);
  const double bottom = flow.y() + row.height;
  flow.draw([=](PageCanvas& page) {
    page.line(kSide_mm, bottom, kSide_mm + kWidth_mm, bottom, is_bold ? 0.35 : 0.1);
  });
  flow.skip(row.height);
}

void lay_out_features(const NcrDocument& document, PageFlow& flow) {
  flow.title("Features, worst first");
  if (document.evidence.features.empty()) {
    flow.paragraph("The inspection took no dimension.");
    return;
  }
  const TableRow head = row_of(feature_heads(document), "", true);
  draw_row(head, true, flow);
  for (const Feature& each : document.evidence.features) {
    const TableRow row = row_of(feature_cells(each, document.lengths), each.reason, false);
    if (flow.left() < row.height) {
      flow.new_page();
      draw_row(head, true, flow);
    }
    draw_row(row, false, flow);
  }
}

}  // namespace

isometric::Pages ncr_pages(const NcrDocument& document) {
  PageFlow flow("Non-Conformance Report " + document.number);
  lay_out_form(document, flow);
  flow.new_page();
  flow.title("Evidence: the spool");
  lay_out_facts(spool_facts(document), flow);
  std::vector<std::string> findings;
  for (const Finding& each : document.evidence.findings) findings.push_back(finding_text(each));
  lay_out_list("Findings", findings, flow);
  lay_out_list("What would put it right", document.evidence.corrections, flow);
  lay_out_pictures(document.evidence.pictures, flow);
  lay_out_features(document, flow);
  flow.title("Decision rule");
  flow.paragraph(document.evidence.decision_rule, kSmall_mm);
  lay_out_list("Mind", document.evidence.warnings, flow);
  flow.title("Made from");
  lay_out_facts(source_facts(document), flow);
  return flow.pages(document.number);
}

Result<std::string> ncr_pdf(const NcrDocument& document) {
  return isometric::draw_pdf(ncr_pages(document), "Non-Conformance Report " + document.number, kA4);
}

}  // namespace spool::ncr
