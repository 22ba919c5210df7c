// The fields of the non-conformance report's form, in the form's own order, each with where its
// value comes from.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "vision/core/result.h"

namespace spool::ncr {

enum class FieldKind { kLine, kText, kChoice, kSignature };
[[nodiscard]] std::string_view name(FieldKind kind);  // line text choice signature

// Who fills a field in before a person may write over it. Nothing is ever made up: what its source
// does not say stays empty.
enum class FieldSource { kNumber, kClock, kJob, kReport, kOperator, kPerson };
[[nodiscard]] std::string_view name(FieldSource source);  // number clock job report operator person

struct FormField {
  std::string block;  // key of its block
  std::string key;    // "block.field" or "block.person.field", unique
  std::string who;    // whose row it is ("Q.C. representative"); "" of the block itself
  std::string label;
  FieldKind kind = FieldKind::kLine;
  FieldSource source = FieldSource::kPerson;
  int row = 0;                       // fields of a block on one line of the form
  std::vector<std::string> choices;  // of kChoice; one is checked, or none
  std::string value;                 // UTF-8; "" to be filled in
};

struct FormBlock {
  std::string key, title;
};
[[nodiscard]] const std::vector<FormBlock>& form_blocks();

// All fields, empty.
[[nodiscard]] std::vector<FormField> empty_form();

// The field of a key; nullptr where there is none.
[[nodiscard]] FormField* field(std::vector<FormField>& form, std::string_view key);
[[nodiscard]] const FormField* field(const std::vector<FormField>& form, std::string_view key);

// Writes what a person said over what is there. kBadInput names the key: not of the form, the
// number (it is given, once), a signature (made by hand), a choice that is none of the field's.
[[nodiscard]] Status write_fields(const std::map<std::string, std::string>& values,
                                  std::vector<FormField>& form);

}  // namespace spool::ncr
