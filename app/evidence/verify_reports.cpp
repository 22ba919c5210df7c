// What of a job's non-conformance reports is not as it was written.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/evidence/verify_reports.h"

#include <cstdint>
#include <cstdlib>
#include <string_view>
#include <system_error>

#include "app/common/json_file.h"
#include "app/job/file_facts.h"

namespace spool::evidence {
namespace {

namespace fs = std::filesystem;
using Kind = job::Change::Kind;

std::string text_of(const nlohmann::json& object, const char* key) {
  const auto found = object.is_object() ? object.find(key) : object.end();
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

// A name alone: nothing that leads elsewhere.
bool is_name(const std::string& name) {
  return !name.empty() && name != "." && name != ".." && name.find('/') == std::string::npos;
}

// Whether the number was never given: the report was being written when a program ended.
bool is_pending(const nlohmann::json& all, const std::string& number) {
  constexpr std::string_view kMiddle = "-NCR-";
  const std::size_t at = number.rfind(kMiddle);
  if (at == std::string::npos) return false;
  const auto given = all.find(number.substr(0, at));
  const std::int64_t last =
      given != all.end() && given->is_number_integer() ? given->get<std::int64_t>() : 0;
  return std::atoll(number.c_str() + at + kMiddle.size()) > last;
}

// One report's files against its list.
void verify_report(const fs::path& job_folder, const std::string& number,
                   const std::string& list_sha256, std::set<std::string>& files,
                   std::map<std::string, std::string>& recorded, Verified& verified) {
  const std::string prefix = "ncr/" + number + "/", list = prefix + kReportFiles;
  files.insert(list);
  files.insert(prefix + "void.json");  // is written later, and says itself when and by whom
  const auto facts = job::facts_of(job_folder, list);
  if (!facts) {
    verified.changes.push_back({Kind::kRemoved, list, "the report " + number + " has no list"});
    return;
  }
  recorded[list_sha256] = list;
  if (facts->sha256 != list_sha256) {
    verified.changes.push_back({Kind::kChanged, list, "is not as the register knows it"});
    return;
  }
  const auto json = read_json(job_folder / list);
  const auto held =
      json && json->is_object() ? json->find("files") : nlohmann::json::const_iterator();
  if (!json || !json->is_object() || held == json->end() || !held->is_array()) {
    verified.changes.push_back({Kind::kChanged, list, "is no list of files"});
    return;
  }
  for (const nlohmann::json& each : *held) {
    const std::string name = text_of(each, "name"), sha256 = text_of(each, "sha256");
    if (!is_name(name)) continue;
    files.insert(prefix + name);
    recorded[sha256] = prefix + name;
    const auto now = job::facts_of(job_folder, prefix + name);
    if (!now)
      verified.changes.push_back({Kind::kRemoved, prefix + name, "is not there any more"});
    else if (now->sha256 != sha256)
      verified.changes.push_back({Kind::kChanged, prefix + name, "is not as it was written"});
  }
}

// Forms that are not written yet; nobody relies on them.
std::set<std::string> drafts_in(const fs::path& job_folder, Verified& verified) {
  std::set<std::string> drafts;
  for (const std::string& file : job::files_below(job_folder / "ncr")) {
    constexpr std::string_view kStart = "draft-", kEnd = ".json";
    if (!file.starts_with(kStart) || !file.ends_with(kEnd)) continue;
    const std::string number =
        file.substr(kStart.size(), file.size() - kStart.size() - kEnd.size());
    constexpr std::size_t kDigits = 6;
    if (number.size() < kDigits || number.find_first_not_of("0123456789") != std::string::npos)
      continue;
    drafts.insert("ncr/" + file);
    verified.notes.push_back("ncr/" + file + " is a report that is not written yet");
  }
  return drafts;
}

}  // namespace

std::set<std::string> verify_reports(const fs::path& job_folder,
                                     std::map<std::string, std::string>& recorded,
                                     Verified& verified) {
  std::set<std::string> files;
  std::error_code code;
  if (!fs::is_directory(job_folder / "ncr", code)) return files;
  const std::string path = "ncr/register.json";
  files = drafts_in(job_folder, verified);
  // Before the first report there is nothing else.
  if (!files.empty() && job::files_below(job_folder / "ncr").size() == files.size()) return files;
  files.insert({path, "ncr/lock"});
  const auto json = read_json(job_folder / path);
  const auto lists =
      json && json->is_object() ? json->find("lists") : nlohmann::json::const_iterator();
  if (!json || !json->is_object() || lists == json->end() || !lists->is_object()) {
    verified.changes.push_back({Kind::kChanged, path, "is no register of reports"});
    return files;
  }
  for (const auto& [number, list] : lists->items())
    if (is_name(number) && list.is_string() &&
        (fs::exists(job_folder / "ncr" / number, code) || !is_pending(*json, number)))
      verify_report(job_folder, number, list.get<std::string>(), files, recorded, verified);
  return files;
}

}  // namespace spool::evidence
