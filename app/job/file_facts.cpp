// What is recorded of a file so that any later change of it shows: bytes, SHA-256, time.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/job/file_facts.h"

#include <algorithm>
#include <cmath>
#include <system_error>

#include <sys/stat.h>

#include <fmt/format.h>

#include "app/job/check_record.h"
#include "vision/core/file_digest.h"

namespace spool::job {
namespace {

namespace fs = std::filesystem;

double modified_of(const struct stat& info) {
  return static_cast<double>(info.st_mtim.tv_sec) +
         1e-9 * static_cast<double>(info.st_mtim.tv_nsec);
}

// Every folder on the way is a folder, not a link to one.
bool has_plain_folders(const fs::path& folder, const std::string& file) {
  fs::path way = folder;
  const fs::path relative = file;
  for (const fs::path& each : relative.parent_path()) {
    way /= each;
    struct stat info {};
    if (::lstat(way.c_str(), &info) != 0 || !S_ISDIR(info.st_mode)) return false;
  }
  return true;
}

bool stays_inside(const std::string& file) {
  if (file.empty() || file.size() > 1024 || file.find('\0') != std::string::npos) return false;
  std::size_t at = 0;
  while (true) {
    const std::size_t end = std::min(file.find('/', at), file.size());
    const std::string part = file.substr(at, end - at);
    if (part.empty() || part == "." || part == "..") return false;
    if (end == file.size()) return true;
    at = end + 1;
  }
}

}  // namespace

std::string_view name(Change::Kind kind) {
  switch (kind) {
    case Change::Kind::kChanged:
      return "changed";
    case Change::Kind::kRemoved:
      return "removed";
    case Change::Kind::kAdded:
      return "added";
    case Change::Kind::kRedated:
      return "re-dated";
  }
  return "changed";
}

Result<FileFacts> facts_of(const fs::path& folder, const std::string& file) {
  const fs::path path = folder / file;
  struct stat info {};
  if (!has_plain_folders(folder, file) || ::lstat(path.c_str(), &info) != 0)
    return Error{ErrorCode::kBadInput, path.string() + ": is not there; check the path"};
  if (!S_ISREG(info.st_mode))
    return Error{ErrorCode::kBadInput,
                 path.string() + ": is no plain file; put the file itself there"};
  auto sha256 = sha256_file(path);
  if (!sha256) return sha256.error();
  return FileFacts{file, static_cast<std::uint64_t>(info.st_size), *std::move(sha256),
                   modified_of(info)};
}

std::optional<Change> changed(const FileFacts& recorded, const fs::path& folder,
                              const std::string& prefix) {
  const std::string file = prefix + recorded.file;
  struct stat info {};
  const fs::path path = folder / recorded.file;
  if (!has_plain_folders(folder, recorded.file) || ::lstat(path.c_str(), &info) != 0)
    return Change{Change::Kind::kRemoved, file, "is not there"};
  if (!S_ISREG(info.st_mode))
    return Change{Change::Kind::kChanged, file, "is no plain file any more"};
  const auto bytes = static_cast<std::uint64_t>(info.st_size);
  if (bytes != recorded.bytes)
    return Change{Change::Kind::kChanged, file,
                  fmt::format("is {} bytes long and was {}", bytes, recorded.bytes)};
  const auto sha256 = sha256_file(path);
  if (!sha256) return Change{Change::Kind::kChanged, file, "cannot be read"};
  if (*sha256 != recorded.sha256)
    return Change{Change::Kind::kChanged, file, "has another SHA-256 than was recorded"};
  if (!(std::abs(modified_of(info) - recorded.modified_s) <= kDateSlack_s))
    return Change{Change::Kind::kRedated, file,
                  fmt::format("is dated {} and was written {}", utc_text(modified_of(info)),
                              utc_text(recorded.modified_s))};
  return std::nullopt;
}

nlohmann::json facts_json(const std::vector<FileFacts>& files) {
  nlohmann::json list = nlohmann::json::array();
  for (const FileFacts& each : files)
    list.push_back({{"file", each.file},
                    {"bytes", each.bytes},
                    {"sha256", each.sha256},
                    {"modified_s", each.modified_s}});
  return list;
}

Result<std::vector<FileFacts>> facts_from_json(const nlohmann::json& list,
                                               const std::string& where) {
  const auto refuse = [&](const std::string& what) {
    return Error{ErrorCode::kBadInput, where + ": \"files\" " + what};
  };
  if (!list.is_array()) return refuse("has to be a list");
  std::vector<FileFacts> files;
  std::set<std::string> names;
  for (const auto& each : list) {
    if (!each.is_object() || !each.contains("file") || !each["file"].is_string() ||
        !each.contains("bytes") || !each["bytes"].is_number_unsigned() ||
        !each.contains("sha256") || !each["sha256"].is_string() || !each.contains("modified_s") ||
        !each["modified_s"].is_number())
      return refuse("has an entry without file, bytes, sha256 or modified_s");
    FileFacts file{each["file"].get<std::string>(), each["bytes"].get<std::uint64_t>(),
                   each["sha256"].get<std::string>(), each["modified_s"].get<double>()};
    if (!stays_inside(file.file)) return refuse("names a file that is not in its folder");
    if (!names.insert(file.file).second) return refuse("names a file twice");
    files.push_back(std::move(file));
  }
  return files;
}

std::set<std::string> files_below(const fs::path& folder) {
  std::set<std::string> files;
  std::error_code code;
  fs::recursive_directory_iterator at(folder, fs::directory_options::skip_permission_denied, code);
  for (; !code && at != fs::recursive_directory_iterator(); at.increment(code)) {
    std::error_code ignored;
    std::string file = at->path().lexically_relative(folder).generic_string();
    const bool is_folder = at->symlink_status(ignored).type() == fs::file_type::directory;
    if (is_folder && !fs::is_empty(at->path(), ignored)) continue;
    if (is_folder) file += '/';
    files.insert(std::move(file));
  }
  return files;
}

}  // namespace spool::job
