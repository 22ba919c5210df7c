// Fills the form in from the job, the inspection and what the operator said.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "app/common/length_text.h"
#include "app/job/job.h"
#include "app/ncr/form.h"
#include "app/ncr/report_evidence.h"

namespace spool::ncr {

struct OperatorInput {
  std::string operator_name;                  // "" nobody said
  std::map<std::string, std::string> fields;  // key of the form to what is to stand there
  std::string created;                        // UTC, 2026-11-29T06:15:00.250Z
  LengthStyle lengths = LengthStyle::kMillimetre;
};

// All that the PDF, HTML, JSON and BCF are written from.
struct NcrDocument {
  std::string number;  // "" until it is given
  std::vector<FormField> form;
  ReportEvidence evidence;
  std::string line, spool, revision;
  std::vector<std::string> welds, heats;  // of the spool; heats "part: heat"
  std::string operator_name, created;
  LengthStyle lengths = LengthStyle::kMillimetre;
  Eigen::AlignedBox3d bounds;  // m, the design file's own coordinates
};

// The form's fields by name from a file: an object of texts. kBadInput names file and key.
[[nodiscard]] Result<std::map<std::string, std::string>> read_fields(
    const std::filesystem::path& path);

// `folder` is the job's. What nobody said stays empty. kBadInput: a field that is not the form's.
[[nodiscard]] Result<NcrDocument> fill_form(const job::Job& job,
                                            const std::filesystem::path& folder,
                                            ReportEvidence evidence, const OperatorInput& input);

// Gives the document its number.
void set_number(const std::string& number, NcrDocument& document);

// The description that findings and dimensions make: what is out, what the drawing asks for.
[[nodiscard]] std::string description_of(const NcrDocument& document);

// A feature's number as people read it: a length in `style`, an angle in degrees; "–" for none.
[[nodiscard]] std::string number_text(const Feature& feature, const std::optional<double>& value,
                                      LengthStyle style, bool with_sign = false);

// Valid UTF-8 without control characters but line ends; what is none becomes U+FFFD or a space.
[[nodiscard]] std::string clean_text(const std::string& text);

}  // namespace spool::ncr
