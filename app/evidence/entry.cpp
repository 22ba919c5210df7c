// entry.json: what one capture holds, made from, and follows.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/evidence/entry.h"

#include <fmt/format.h>

#include "app/common/json_file.h"
#include "vision/core/file_io.h"

namespace spool::evidence {
namespace {

using nlohmann::json;
constexpr char kSchema[] = "spoolsight-evidence/1";

std::string text_of(const json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

std::int64_t integer_of(const json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_number_integer() ? found->get<std::int64_t>() : 0;
}

}  // namespace

std::string entry_name(std::int64_t number) { return fmt::format("{:06}", number); }

std::string entry_text(const Entry& entry) {
  const job::CheckRecord& check = entry.check;
  json object = entry.context.is_object() ? entry.context : json::object();
  object.update({{"schema", kSchema},
                 {"number", entry.number},
                 {"previous_sha256", entry.previous_sha256},
                 {"state", entry.state},
                 {"time", job::utc_text(entry.time_s)},
                 {"time_s", entry.time_s},
                 {"spool", entry.spool},
                 {"check", check.id},
                 {"step", check.step},
                 {"part", check.part},
                 {"joint", check.joint},
                 {"phase", job::name(check.phase)},
                 {"outcome", job::name(check.outcome)},
                 {"status", check.status},
                 {"remark", check.remark},
                 {"operator", check.operator_name},
                 {"override_reason", check.override_reason},
                 {"report_sha256", check.report_sha256},
                 {"checks_sha256", entry.checks_sha256},
                 {"design", {{"file", entry.design}, {"sha256", entry.design_sha256}}},
                 {"options", entry.options},
                 {"files", job::facts_json(entry.files)}});
  return json_text(object);
}

Result<Entry> parse_entry(const std::string& text, const std::string& name) {
  const auto refuse = [&](const std::string& why) {
    return Error{ErrorCode::kBadInput, name + ": " + why};
  };
  const auto parsed = parse_json(text, name);
  if (!parsed) return parsed.error();
  if (!parsed->is_object() || text_of(*parsed, "schema") != kSchema)
    return refuse(std::string("is no entry that this SpoolSight knows (schema ") + kSchema + ")");
  Entry entry;
  entry.number = integer_of(*parsed, "number");
  entry.previous_sha256 = text_of(*parsed, "previous_sha256");
  entry.state = text_of(*parsed, "state");
  const auto time = parsed->find("time_s");
  if (time == parsed->end() || !time->is_number()) return refuse("\"time_s\" has to be a number");
  entry.time_s = time->get<double>();
  entry.spool = text_of(*parsed, "spool");
  entry.check.id = integer_of(*parsed, "check");
  entry.check.step = static_cast<int>(integer_of(*parsed, "step"));
  entry.check.part = text_of(*parsed, "part");
  entry.check.operator_name = text_of(*parsed, "operator");
  entry.checks_sha256 = text_of(*parsed, "checks_sha256");
  const auto design = parsed->find("design");
  if (design == parsed->end() || !design->is_object()) return refuse("names no design");
  entry.design = text_of(*design, "file");
  entry.design_sha256 = text_of(*design, "sha256");
  if (entry.design.empty() || entry.design.find('/') != std::string::npos || entry.design == "..")
    return refuse("\"design\" has to name a file in the job's folder");
  const auto options = parsed->find("options");
  if (options == parsed->end() || !options->is_object()) return refuse("holds no options");
  for (const auto& [key, value] : options->items()) {
    if (!value.is_string()) return refuse("\"options\" holds what is no text");
    entry.options[key] = value.get<std::string>();
  }
  auto files = job::facts_from_json(parsed->value("files", json()), name);
  if (!files) return files.error();
  entry.files = *std::move(files);
  return entry;
}

Result<Entry> read_entry(const std::filesystem::path& folder) {
  const std::filesystem::path path = folder / kEntryFile;
  constexpr std::uint64_t kMaxBytes = std::uint64_t{4} << 20U;
  const auto text = read_file(path, kMaxBytes);
  if (!text) return text.error();
  return parse_entry(*text, path.string());
}

}  // namespace spool::evidence
