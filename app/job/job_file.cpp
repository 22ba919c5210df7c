// job.json: which design, in which order, with which gaps.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/job/job_file.h"

#include <charconv>

#include <fmt/format.h>

#include "app/common/json_file.h"
#include "vision/core/file_io.h"

namespace spool::job {
namespace {

constexpr std::string_view kSchema = "spoolsight-job/";

Status check_schema(const std::string& schema, const std::string& file) {
  int version = 0;
  const bool is_ours = schema.starts_with(kSchema);
  if (is_ours) {
    const char* const end = schema.data() + schema.size();
    const auto [at, code] = std::from_chars(schema.data() + kSchema.size(), end, version);
    if (code != std::errc() || at != end) version = 0;
  }
  if (version < 1) return Error{ErrorCode::kBadInput, file + ": is no SpoolSight job"};
  if (version > kJobVersion)
    return Error{ErrorCode::kBadInput,
                 fmt::format("{}: is of schema {}, and this SpoolSight knows {}{}; use a newer "
                             "SpoolSight",
                             file, schema, kSchema, kJobVersion)};
  return {};
}

// A name in the job's own folder: no path leads out of it.
bool is_plain_name(const std::string& name) {
  return !name.empty() && name != "." && name != ".." && name.find('/') == std::string::npos;
}

}  // namespace

Result<JobFile> read_job_file(const std::filesystem::path& path) {
  const auto json = read_json(path);
  if (!json) return json.error();
  JsonObject object(*json, path.string());
  const std::string schema = object.text_or("schema", "");
  if (object.error()) return *object.error();
  if (Status known = check_schema(schema, path.string()); !known) return known.error();
  JobFile file;
  file.spool = object.text_or("spool", "");
  file.design = object.text_or("design", "");
  file.design_sha256 = object.text_or("design_sha256", "");
  file.source = object.text_or("source", "");
  file.source_sha256 = object.text_or("source_sha256", "");
  file.source_path = object.text_or("source_path", "");
  file.created = object.text_or("created", "");
  if (!is_plain_name(file.design)) object.fail("design", "has to name a file in the job's folder");
  if (!file.source.empty() && !is_plain_name(file.source))
    object.fail("source", "has to name a file in the job's folder");
  for (const auto& each : object.array("order")) {
    if (each.is_string())
      file.order.push_back(each.get<std::string>());
    else
      object.fail("order", "has to be a list of part names");
  }
  const auto rule = guide::parse_gap_rule(object.text_or("gap_rule", ""));
  if (!rule) object.fail("gap_rule", "has to be none, subtract or model-has-gaps");
  file.gaps.rule = rule.value_or(guide::GapRule::kNone);
  file.gaps.root_gap_m = object.number("root_gap_m");
  if (file.gaps.root_gap_m < 0) object.fail("root_gap_m", "has to be 0 or more");
  if (object.error()) return *object.error();
  return file;
}

Status write_job_file(const std::filesystem::path& path, const JobFile& file) {
  const nlohmann::json json = {{"schema", fmt::format("{}{}", kSchema, kJobVersion)},
                               {"spool", file.spool},
                               {"design", file.design},
                               {"design_sha256", file.design_sha256},
                               {"source", file.source},
                               {"source_sha256", file.source_sha256},
                               {"source_path", file.source_path},
                               {"created", file.created},
                               {"order", file.order},
                               {"gap_rule", guide::name(file.gaps.rule)},
                               {"root_gap_m", file.gaps.root_gap_m}};
  return write_file_whole(path, json_text(json));
}

}  // namespace spool::job
