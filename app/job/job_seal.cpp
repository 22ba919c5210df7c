// seal.json: what the files of a job's own folder were when it was last closed.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/job/job_seal.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <set>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>

#include "app/common/json_file.h"
#include "app/job/check_record.h"
#include "vision/core/file_digest.h"
#include "vision/core/file_io.h"

namespace spool::job {
namespace {

namespace fs = std::filesystem;
constexpr char kSchema[] = "spoolsight-seal/1";

// The text without "self", then with it: one flipped bit anywhere shows.
std::string sealed_text(nlohmann::json seal) {
  seal.erase("self");
  seal["self"] = sha256_hex(json_text(seal));
  return json_text(seal);
}

std::vector<std::string> sealed_names(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code code;
  for (const auto& entry : fs::directory_iterator(folder, code)) {
    const std::string file = entry.path().filename().string();
    if (entry.symlink_status(code).type() == fs::file_type::regular && !is_unsealed(file))
      names.push_back(file);
  }
  std::sort(names.begin(), names.end());
  return names;
}

Change seal_is(Change::Kind kind, const std::string& text) { return {kind, kSealFile, text}; }

}  // namespace

bool is_unsealed(const std::string& file) {
  return file == "lock" || file == kSealFile || file == "journal.db-wal" ||
         file == "journal.db-shm" || is_half_written(file);
}

bool is_half_written(const std::string& file) {
  return (file.starts_with("job.json.part-") || file.starts_with("seal.json.part-")) &&
         file.find('/') == std::string::npos;
}

void clear_half_written(const fs::path& folder) {
  std::error_code code;
  std::vector<fs::path> half;
  for (const auto& entry : fs::directory_iterator(folder, code)) {
    if (is_half_written(entry.path().filename().string())) half.push_back(entry.path());
  }
  for (const fs::path& each : half) fs::remove(each, code);
}

Status write_seal(const fs::path& folder) {
  std::vector<FileFacts> files;
  for (const std::string& each : sealed_names(folder)) {
    auto facts = facts_of(folder, each);
    if (!facts) return facts.error();
    files.push_back(*std::move(facts));
  }
  const double sealed_s = std::floor(now().wall_s);
  const fs::path path = folder / kSealFile;
  const nlohmann::json seal = {
      {"schema", kSchema}, {"sealed_s", sealed_s}, {"files", facts_json(files)}};
  if (Status written = write_file_whole(path, sealed_text(seal)); !written) return written;
  const timespec at{static_cast<time_t>(sealed_s), 0};
  const timespec times[2] = {at, at};
  if (::utimensat(AT_FDCWD, path.c_str(), times, AT_SYMLINK_NOFOLLOW) != 0)
    return Error{ErrorCode::kIo, path.string() + ": cannot be dated (" +
                                     std::generic_category().message(errno) +
                                     "); check its rights"};
  return {};
}

std::vector<Change> seal_changes(const fs::path& folder) {
  const fs::path path = folder / kSealFile;
  const auto facts = facts_of(folder, kSealFile);
  if (!facts) return {seal_is(Change::Kind::kRemoved, "is not there")};
  constexpr std::uint64_t kMaxBytes = std::uint64_t{1} << 20U;
  const auto bytes = read_file(path, kMaxBytes);
  if (!bytes) return {seal_is(Change::Kind::kChanged, "cannot be read")};
  const auto seal = parse_json(*bytes, path.string());
  if (!seal || !seal->is_object() || seal->value("schema", nlohmann::json()) != kSchema ||
      sealed_text(*seal) != *bytes || !(*seal)["sealed_s"].is_number())
    return {seal_is(Change::Kind::kChanged, "is not as it was written")};
  std::vector<Change> changes;
  if (std::abs(facts->modified_s - (*seal)["sealed_s"].get<double>()) > kDateSlack_s)
    changes.push_back(seal_is(Change::Kind::kRedated, "is not dated as it was written"));
  const auto files = facts_from_json((*seal)["files"], path.string());
  if (!files) return {seal_is(Change::Kind::kChanged, "is not as it was written")};
  std::set<std::string> known;
  for (const FileFacts& each : *files) {
    known.insert(each.file);
    if (auto change = changed(each, folder, "")) changes.push_back(*std::move(change));
  }
  for (const std::string& each : sealed_names(folder)) {
    if (!known.contains(each))
      changes.push_back({Change::Kind::kAdded, each, "was not there when the job was closed"});
  }
  return changes;
}

bool is_open_or_abandoned(const fs::path& folder) {
  std::error_code code;
  const auto size = fs::file_size(folder / "lock", code);
  return !code && size > 0;
}

}  // namespace spool::job
