// The flags of an inspection as a report and an entry keep them, so that it can be made again.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/replay_options.h"

#include <charconv>
#include <filesystem>

#include "vision/core/file_digest.h"

namespace spool::tools {
namespace {

// The text fields by the name of their flag.
std::map<std::string, std::string*> fields_of(InspectOptions& options) {
  return {{"align", &options.align},
          {"pairs", &options.pairs},
          {"pose", &options.pose},
          {"posed_by", &options.posed_by},
          {"datum", &options.datum},
          {"standard", &options.standard},
          {"design_unit", &options.design_unit},
          {"scan_unit", &options.scan_unit},
          {"units", &options.units},
          {"calibration", &options.calibration},
          {"scan", &options.scan}};
}

template <class Number>
bool parse(const std::string& text, Number& number) {
  const char* const end = text.data() + text.size();
  const auto [at, code] = std::from_chars(text.data(), end, number);
  return code == std::errc() && at == end;
}

}  // namespace

const std::vector<std::string>& file_flags() {
  static const std::vector<std::string> flags{"pairs", "pose", "standard", "calibration"};
  return flags;
}

Result<std::map<std::string, std::string>> options_text(const InspectOptions& options) {
  InspectOptions given = options;
  given.align = method_text(options);
  given.scan.clear();
  std::map<std::string, std::string> text;
  for (const auto& [name, field] : fields_of(given)) {
    if (!field->empty()) text[name] = *field;
  }
  text["seed"] = std::to_string(options.seed);
  if (options.frame) text["frame"] = std::to_string(*options.frame);
  for (const std::string& name : file_flags()) {
    std::error_code code;
    const auto found = text.find(name);
    if (found == text.end() || !std::filesystem::is_regular_file(found->second, code)) continue;
    auto sha256 = sha256_file(found->second);
    if (!sha256) return sha256.error();
    text[name + "_sha256"] = *std::move(sha256);
  }
  return text;
}

Result<InspectOptions> options_from(const std::map<std::string, std::string>& text,
                                    const std::string& where) {
  InspectOptions options;
  const auto fields = fields_of(options);
  for (const auto& [name, value] : text) {
    bool is_known = true;
    if (const auto field = fields.find(name); field != fields.end())
      *field->second = value;
    else if (name == "seed")
      is_known = parse(value, options.seed);
    else if (name == "frame")
      is_known = parse(value, options.frame.emplace());
    else
      is_known = name.ends_with("_sha256");
    if (!is_known)
      return Error{ErrorCode::kBadInput, where + ": the option " + name + " = " + value +
                                             " is none that this SpoolSight knows"};
  }
  if (!parse_align_method(options.align) ||
      (!options.posed_by.empty() && !parse_align_method(options.posed_by)))
    return Error{ErrorCode::kBadInput,
                 where + ": says no method of alignment that this SpoolSight knows"};
  return options;
}

}  // namespace spool::tools
