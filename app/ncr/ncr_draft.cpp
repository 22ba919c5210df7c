// A form that is being filled in, kept in the job until its report is written.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/ncr/ncr_draft.h"

#include <system_error>

#include <fmt/format.h>

#include "app/common/json_file.h"
#include "vision/core/file_io.h"

namespace spool::ncr {

namespace {
constexpr char kSchema[] = "spoolsight-ncr-draft/1";
}  // namespace

std::filesystem::path draft_path(const std::filesystem::path& job_folder, std::int64_t capture) {
  return job_folder / "ncr" / fmt::format("draft-{:06}.json", capture);
}

Status write_draft(const std::filesystem::path& job_folder, const NcrDraft& draft) {
  if (Status made = make_folder(job_folder / "ncr"); !made) return made;
  return write_file_whole(draft_path(job_folder, draft.capture),
                          json_text({{"schema", kSchema},
                                     {"capture", draft.capture},
                                     {"shop", draft.shop},
                                     {"fields", draft.fields}}));
}

NcrDraft read_draft(const std::filesystem::path& job_folder, std::int64_t capture) {
  NcrDraft draft{.capture = capture, .shop = "", .fields = {}};
  const auto path = draft_path(job_folder, capture);
  std::error_code code;
  if (!std::filesystem::is_regular_file(path, code)) return draft;
  const auto json = read_json(path);
  if (!json || !json->is_object()) return draft;
  const auto text = [](const nlohmann::json& object, const char* key) {
    const auto found = object.find(key);
    return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
  };
  if (text(*json, "schema") != kSchema) return draft;
  draft.shop = text(*json, "shop");
  const auto fields = json->find("fields");
  if (fields == json->end() || !fields->is_object()) return draft;
  for (const auto& [key, value] : fields->items())
    if (value.is_string()) draft.fields[key] = value.get<std::string>();
  return draft;
}

void remove_draft(const std::filesystem::path& job_folder, std::int64_t capture) {
  std::error_code code;
  std::filesystem::remove(draft_path(job_folder, capture), code);
}

}  // namespace spool::ncr
