// Fills the form in from the job, the inspection and what the operator said.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/ncr/fill_form.h"

#include <cmath>

#include <fmt/format.h>

#include "app/common/json_file.h"

namespace spool::ncr {
namespace {

void set(const char* key, const std::string& value, std::vector<FormField>& form) {
  if (FormField* at = field(form, key)) at->value = clean_text(value);
}

}  // namespace

std::string clean_text(const std::string& text) {
  // nlohmann knows UTF-8 and replaces what is none.
  std::string clean =
      nlohmann::json::parse(
          nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace))
          .get<std::string>();
  for (char& c : clean)
    if ((static_cast<unsigned char>(c) < ' ' && c != '\n') || c == 0x7F) c = ' ';
  // U+FFFE and U+FFFF are characters of UTF-8 and of no XML.
  for (const char* none : {"\xEF\xBF\xBE", "\xEF\xBF\xBF"})
    for (auto at = clean.find(none); at != std::string::npos; at = clean.find(none))
      clean.replace(at, 3, "\xEF\xBF\xBD");
  return clean;
}

Result<std::map<std::string, std::string>> read_fields(const std::filesystem::path& path) {
  const auto json = read_json(path);
  if (!json) return json.error();
  const auto refuse = [&](const std::string& why) {
    return Error{ErrorCode::kBadInput, path.string() + ": " + why};
  };
  if (!json->is_object()) return refuse("has to be an object of the form's fields and their texts");
  std::map<std::string, std::string> fields;
  for (const auto& [key, value] : json->items()) {
    if (!value.is_string()) return refuse("\"" + key + "\" has to be a text");
    fields[key] = value.get<std::string>();
  }
  return fields;
}

std::string number_text(const Feature& feature, const std::optional<double>& value,
                        LengthStyle style, bool with_sign) {
  if (!value || !std::isfinite(*value)) return "–";
  return quantity_text(*value, feature.is_angle, style, with_sign);
}

std::string description_of(const NcrDocument& document) {
  std::string text;
  if (!document.spool.empty()) text += "Spool " + document.spool;
  if (!document.line.empty()) text += (text.empty() ? "Line " : ", line ") + document.line;
  if (!document.revision.empty()) text += ", revision " + document.revision;
  if (!text.empty()) text += ".\n";
  for (const Finding& each : document.evidence.findings)
    text += (each.part.empty() ? "" : each.part + ": ") + each.text + "\n";
  constexpr int kMost = 5;  // the form stays on its page; the table of features has all
  int out = 0;
  for (const Feature& each : document.evidence.features) {
    if (each.status != Verdict::kNotOk || ++out > kMost) continue;
    text += fmt::format("{} ({}): the drawing requires {}", each.name, each.kind,
                        number_text(each, each.nominal, document.lengths));
    if (each.tolerance)
      text += fmt::format(" ± {}", number_text(each, each.tolerance, document.lengths));
    text += fmt::format("; installed is {}", number_text(each, each.measured, document.lengths));
    if (each.u)
      text += fmt::format(" ± {} (k = {:g})",
                          number_text(each, *each.u * each.coverage_factor, document.lengths),
                          each.coverage_factor);
    text += each.clause.empty() ? ".\n" : ", " + each.clause + ".\n";
  }
  if (out > kMost) text += fmt::format("And {} more, in the table of features.\n", out - kMost);
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text;
}

void set_number(const std::string& number, NcrDocument& document) {
  document.number = number;
  set("head.ncr_no", number, document.form);
}

Result<NcrDocument> fill_form(const job::Job& job, const std::filesystem::path& folder,
                              ReportEvidence evidence, const OperatorInput& input) {
  NcrDocument document;
  const DesignModel& design = job.design();
  document.form = empty_form();
  document.evidence = std::move(evidence);
  document.line = design.line;
  document.spool = job.file().spool.empty() ? design.spool : job.file().spool;
  document.revision = design.revision;
  document.operator_name = clean_text(input.operator_name);
  document.created = input.created;
  document.lengths = input.lengths;
  document.bounds = design.bounds().translated(design.origin);
  for (const Joint& each : design.joints)
    if (!each.weld.empty()) document.welds.push_back(each.weld);
  for (const Part& each : design.parts)
    if (!each.heat.empty()) document.heats.push_back(each.name + ": " + each.heat);
  set("head.date", input.created.substr(0, 10), document.form);
  set("head.tag_line_no", design.line, document.form);
  set("head.job_no", folder.stem().string(), document.form);
  set("description.text", description_of(document), document.form);
  set("root_cause.inspector", input.operator_name, document.form);
  std::map<std::string, std::string> fields;
  for (const auto& [key, value] : input.fields) fields[key] = clean_text(value);
  if (Status written = write_fields(fields, document.form); !written) return written.error();
  return document;
}

}  // namespace spool::ncr
