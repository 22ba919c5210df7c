// The fields of the non-conformance report's form, in the form's own order, each with where its
// value comes from.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/ncr/form.h"

#include <algorithm>

namespace spool::ncr {
namespace {

using Kind = FieldKind;
using Source = FieldSource;

class Builder {
 public:
  void block(std::string key) {
    block_ = std::move(key);
    row_ = 0;
  }
  void row() { ++row_; }
  void add(const std::string& key, const std::string& label, Kind kind = Kind::kLine,
           Source source = Source::kPerson, std::vector<std::string> choices = {}) {
    const std::string middle = person_.empty() ? "." : "." + person_ + ".";
    fields.push_back(
        {block_, block_ + middle + key, who_, label, kind, source, row_, std::move(choices), ""});
  }
  void sign_row(const std::string& person, const std::string& who) {
    row();
    person_ = person;
    who_ = who;
    add("signature", "Signature", Kind::kSignature);
    add("print", "Print");
    add("date", "Date");
    person_.clear();
    who_.clear();
  }
  std::vector<FormField> fields;

 private:
  std::string block_, person_, who_;
  int row_ = 0;
};

}  // namespace

std::string_view name(FieldKind kind) {
  switch (kind) {
    case Kind::kLine:
      return "line";
    case Kind::kText:
      return "text";
    case Kind::kChoice:
      return "choice";
    case Kind::kSignature:
      break;
  }
  return "signature";
}

std::string_view name(FieldSource source) {
  switch (source) {
    case Source::kNumber:
      return "number";
    case Source::kClock:
      return "clock";
    case Source::kJob:
      return "job";
    case Source::kReport:
      return "report";
    case Source::kOperator:
      return "operator";
    case Source::kPerson:
      break;
  }
  return "person";
}

const std::vector<FormBlock>& form_blocks() {
  static const std::vector<FormBlock> blocks{{"head", "Non-Conformance Report"},
                                             {"description", "Description of non-conformance"},
                                             {"recommended_action", "Recommended action"},
                                             {"root_cause", "Root cause"},
                                             {"proposed_disposition",
                                              "Proposed disposition (to be completed by the "
                                              "addressee)"},
                                             {"acceptance", "Acceptance of proposal"},
                                             {"completion", "Completion of disposition"},
                                             {"final_sign_off", "Final sign-off"}};
  return blocks;
}

std::vector<FormField> empty_form() {
  Builder form;
  form.block("head");
  form.add("place", "Shop / Field construction", Kind::kChoice, Source::kPerson,
           {"Shop", "Field construction"});
  form.add("ncr_no", "NCR No.", Kind::kLine, Source::kNumber);
  form.row();
  form.add("issued_to", "Issued to");
  form.add("date", "Date", Kind::kLine, Source::kClock);
  form.row();
  form.add("department", "Dept / plant / location");
  form.add("tag_line_no", "Tag No. / Line No.", Kind::kLine, Source::kJob);
  form.add("job_no", "Job No.", Kind::kLine, Source::kJob);
  form.block("description");
  form.add("text", "Component, spool number (SCN), what is installed, what the isometric requires",
           Kind::kText, Source::kReport);
  form.block("recommended_action");
  form.add("action", "Check one", Kind::kChoice, Source::kPerson,
           {"Scrap", "Rework", "Use as is", "Return"});
  form.block("root_cause");
  form.add("text", "What led to it", Kind::kText);
  form.row();
  form.add("inspector", "Inspector", Kind::kLine, Source::kOperator);
  form.add("signature", "Signature", Kind::kSignature);
  form.add("date", "Date");
  form.block("proposed_disposition");
  form.add("text", "What is to be done", Kind::kText);
  form.row();
  form.add("name", "Name");
  form.add("signature", "Signature", Kind::kSignature);
  form.add("date", "Date");
  form.block("acceptance");
  form.add("client_approval", "Client approval", Kind::kChoice, Source::kPerson, {"Yes", "No"});
  form.add("authorized_inspector", "Authorized inspector", Kind::kChoice, Source::kPerson,
           {"Yes", "No"});
  form.sign_row("qc", "Q.C. representative");
  form.sign_row("contractor", "Contractor representative");
  form.sign_row("owner", "Owner representative");
  form.block("completion");
  form.add("action_completed", "Action completed", Kind::kText);
  form.row();
  form.add("inspector", "Inspector");
  form.add("print", "Print");
  form.add("date", "Date");
  form.add("completed", "Completed");
  form.block("final_sign_off");
  form.sign_row("qc", "Q.C. representative");
  form.sign_row("contractor", "Contractor representative");
  form.sign_row("owner", "Owner representative");
  form.sign_row("design_engineer", "Design engineer (if applicable)");
  return form.fields;
}

const FormField* field(const std::vector<FormField>& form, std::string_view key) {
  const auto at = std::find_if(form.begin(), form.end(),
                               [&](const FormField& each) { return each.key == key; });
  return at == form.end() ? nullptr : &*at;
}

FormField* field(std::vector<FormField>& form, std::string_view key) {
  return const_cast<FormField*>(field(std::as_const(form), key));
}

Status write_fields(const std::map<std::string, std::string>& values,
                    std::vector<FormField>& form) {
  for (const auto& [key, value] : values) {
    FormField* at = field(form, key);
    const auto refuse = [&, name = key](const std::string& why) {
      return Error{ErrorCode::kBadInput, "\"" + name + "\": " + why};
    };
    if (at == nullptr) return refuse("is no field of the form; its keys are in ncr.schema.json");
    if (at->source == FieldSource::kNumber) return refuse("the number is given, not chosen");
    if (at->kind == FieldKind::kSignature) return refuse("is signed by hand, on paper");
    if (at->kind == FieldKind::kChoice && !value.empty() &&
        std::find(at->choices.begin(), at->choices.end(), value) == at->choices.end()) {
      std::string all;
      for (const std::string& each : at->choices) all += (all.empty() ? "" : ", ") + each;
      return refuse("has to be one of: " + all);
    }
    at->value = value;
  }
  return {};
}

}  // namespace spool::ncr
