// A capture: everything that one check rests on, put into the job's evidence whole or not at all.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/evidence/capture.h"

#include <cmath>
#include <system_error>

#include <fmt/format.h>

#include "app/common/json_file.h"
#include "app/evidence/durable_folder.h"
#include "app/job/check_digest.h"
#include "vision/core/file_digest.h"
#include "vision/core/file_io.h"

namespace spool::evidence {
namespace {

namespace fs = std::filesystem;

// The journal, folders and rounding to blocks need some, too.
constexpr std::uint64_t kSpareBytes = std::uint64_t{8} << 20U;

Status check_operator(const std::string& operator_name) {
  const auto refuse = [](const std::string& why) { return Error{ErrorCode::kUsage, why}; };
  if (operator_name.find_first_not_of(" \t") == std::string::npos)
    return refuse("a capture needs the name of who checked; say who you are");
  if (operator_name.size() > kMaxNameBytes)
    return refuse(
        fmt::format("the operator's name is {} bytes long, more than the {} that are "
                    "kept; shorten it",
                    operator_name.size(), kMaxNameBytes));
  if (nlohmann::json::parse(nlohmann::json(operator_name)
                                .dump(-1, ' ', false, nlohmann::json::error_handler_t::replace))
          .get<std::string>() != operator_name)
    return refuse("the operator's name is no UTF-8 text; type it again");
  return {};
}

Status check_space(const fs::path& folder, const CaptureRequest& request) {
  std::uint64_t needed = request.more_bytes + kSpareBytes;
  for (const StoredFile& file : request.files) {
    std::error_code code;
    const auto bytes = fs::file_size(file.from, code);
    if (code)
      return Error{ErrorCode::kBadInput, file.from.string() + ": cannot be read (" +
                                             code.message() + "); check the path"};
    needed += bytes;
  }
  std::error_code code;
  const auto space = fs::space(folder, code);
  if (code || space.available >= needed) return {};
  constexpr double kMega = 1e6;
  return Error{ErrorCode::kIo,
               fmt::format("{}: the capture needs {:.1f} MB and {:.1f} MB are free; free space and "
                           "capture again, nothing was written",
                           folder.string(), static_cast<double>(needed) / kMega,
                           static_cast<double>(space.available) / kMega)};
}

Status fill(const fs::path& folder, const CaptureRequest& request) {
  if (Status made = make_folder(folder); !made) return made;
  for (const StoredFile& file : request.files) {
    const fs::path to = folder / file.to;
    if (Status made = make_folder(to.parent_path()); !made) return made;
    if (Status copied = copy_durably(file.from, to); !copied) return copied;
    if (file.sha256.empty()) continue;
    const auto sha256 = sha256_file(to);
    if (!sha256) return sha256.error();
    if (*sha256 != file.sha256)
      return Error{ErrorCode::kBadInput, file.from.string() +
                                             ": is not the file that the report was made with "
                                             "(its SHA-256 is another); inspect again"};
  }
  return request.write_more ? request.write_more(folder) : Status{};
}

Result<std::vector<job::FileFacts>> facts_below(const fs::path& folder) {
  std::vector<job::FileFacts> files;
  for (const std::string& each : job::files_below(folder)) {
    if (each.ends_with('/')) continue;
    auto facts = job::facts_of(folder, each);
    if (!facts) return facts.error();
    files.push_back(*std::move(facts));
  }
  return files;
}

// entry.json and its signature, dated as the entry says, and all of the folder on the disk.
Result<std::string> write_entry(const fs::path& folder, const Entry& entry,
                                const std::optional<SigningKey>& key) {
  const std::string text = entry_text(entry);
  if (Status done = write_file_whole(folder / kEntryFile, text); !done) return done.error();
  if (Status done = date_file(folder / kEntryFile, entry.time_s); !done) return done.error();
  if (key) {
    const std::string signature = "ed25519\n" + key->public_key() + "\n" + key->sign(text) + "\n";
    if (Status done = write_file_whole(folder / kSignatureFile, signature); !done)
      return done.error();
    if (Status done = date_file(folder / kSignatureFile, entry.time_s); !done) return done.error();
  }
  if (Status done = sync_folders(folder); !done) return done.error();
  return sha256_hex(text);
}

// The path as people know it in what failed while it was prepared.
Error as_named(Error error, const fs::path& staging, const fs::path& folder) {
  const auto at = error.message.find(staging.string());
  if (at != std::string::npos) error.message.replace(at, staging.string().size(), folder.string());
  return error;
}

}  // namespace

std::string staging_name(std::int64_t number) { return ".capture-" + entry_name(number); }

Status settle_captures(job::Job& job) {
  const auto captures = job.captures();
  if (!captures) return captures.error();
  const fs::path evidence = job.folder() / "evidence";
  if (Status made = make_folder(evidence); !made) return made;
  std::error_code code;
  for (const job::CaptureRow& row : *captures) {
    const fs::path staging = evidence / staging_name(row.number);
    if (!fs::exists(staging, code) || fs::exists(evidence / entry_name(row.number), code)) continue;
    fs::rename(staging, evidence / entry_name(row.number), code);
    if (!code) (void)sync_folder(evidence);
  }
  // What is left is of captures that never were; ours, as the job is.
  std::vector<fs::path> begun;
  for (const auto& each : fs::directory_iterator(evidence, code)) {
    if (each.path().filename().string().starts_with(".capture-")) begun.push_back(each.path());
  }
  for (const fs::path& each : begun) fs::remove_all(each, code);
  return {};
}

Result<Captured> capture(job::Job& job, const CaptureRequest& request) {
  if (Status named = check_operator(request.check.operator_name); !named) return named.error();
  const fs::path evidence = job.folder() / "evidence";
  if (Status settled = settle_captures(job); !settled) return settled.error();
  const auto before = job.captures();
  if (!before) return before.error();
  const auto check_id = job.next_check();
  if (!check_id) return check_id.error();
  Captured captured;
  captured.check_id = *check_id;
  captured.number = before->empty() ? 1 : before->back().number + 1;
  const std::string name = entry_name(captured.number);
  job::CheckRecord check = request.check;
  check.at = job::now();
  if (!request.picture.empty()) check.picture = name + "/" + request.picture;
  const auto record = job.as_added(request.step, std::move(check));
  if (!record) return record.error();
  if (Status room = check_space(evidence, request); !room) return room.error();
  captured.folder = evidence / name;
  std::error_code code;
  if (fs::exists(captured.folder, code))
    return Error{ErrorCode::kBadInput,
                 captured.folder.string() +
                     ": lies where the next capture belongs, and is none of the job's; verify it"};
  Entry entry{.number = captured.number,
              .previous_sha256 = before->empty() ? "" : before->back().entry_sha256,
              .state = request.state,
              .time_s = std::floor(record->at.wall_s),
              .spool = job.file().spool,
              .check = *record,
              .checks_sha256 = "",
              .design = job.file().design,
              .design_sha256 = job.file().design_sha256,
              .options = request.options,
              .context = request.context,
              .files = {}};
  entry.check.id = captured.check_id;
  std::vector<job::CheckRecord> checks = job.records();
  checks.push_back(entry.check);
  entry.checks_sha256 = job::checks_sha256(checks);
  const fs::path staging = evidence / staging_name(captured.number);
  const auto failed = [&](const Error& error) {
    fs::remove_all(staging, code);
    return as_named(error, staging, captured.folder);
  };
  if (Status filled = fill(staging, request); !filled) return failed(filled.error());
  auto files = facts_below(staging);
  if (!files) return failed(files.error());
  entry.files = *std::move(files);
  const auto sha256 = write_entry(staging, entry, request.key);
  if (!sha256) return failed(sha256.error());
  if (Status synced = sync_folder(evidence); !synced) return failed(synced.error());
  captured.entry_sha256 = *sha256;
  const auto id = job.add_captured(*record, {.number = captured.number,
                                             .check_id = captured.check_id,
                                             .entry_sha256 = *sha256,
                                             .signer = request.key ? request.key->public_key() : "",
                                             .wall_s = entry.time_s});
  if (!id) return failed(id.error());
  // From here on it is there. Where the folder cannot get its name, the next capture gives it.
  fs::rename(staging, captured.folder, code);
  if (code) captured.folder = staging;
  (void)sync_folder(evidence);
  return captured;
}

}  // namespace spool::evidence
