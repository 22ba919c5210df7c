// Tells what of a job is not as it was recorded: changed, removed, added, re-dated, out of chain.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/evidence/verify.h"

#include <algorithm>
#include <system_error>

#include <fmt/format.h>

#include "app/evidence/capture.h"
#include "app/evidence/verify_entry.h"
#include "app/evidence/verify_reports.h"
#include "app/job/check_digest.h"
#include "app/job/job_seal.h"
#include "vision/core/file_digest.h"

namespace spool::evidence {
namespace {

namespace fs = std::filesystem;
using job::Change;
using Kind = job::Change::Kind;

// What the journal says, as far as it can be read.
struct JournalView {
  bool is_readable = false;
  std::int64_t version = job::kJournalVersion;
  std::vector<job::CheckRecord> records;
  std::vector<job::CaptureRow> captures;
};

class Verification {
 public:
  Verification(fs::path folder, const VerifyOptions& options)
      : folder_(std::move(folder)), options_(options) {}

  Verified run() {
    is_open_ = job::is_open_or_abandoned(folder_);
    const std::vector<Change> seal = job::seal_changes(folder_);  // before the journal is touched
    read_journal();
    take_seal(seal);
    read_job_file();
    verify_entries();
    expected_.merge(verify_reports(folder_, recorded_, verified_));
    find_added();
    tell_swaps();
    return std::move(verified_);
  }

 private:
  void change(Kind kind, const std::string& file, const std::string& text) {
    verified_.changes.push_back({kind, file, text});
  }
  [[nodiscard]] bool is_told(const std::string& file) const {
    return std::any_of(verified_.changes.begin(), verified_.changes.end(),
                       [&](const Change& each) { return each.file == file; });
  }
  void read_journal();
  void take_seal(const std::vector<Change>& changes);
  void read_job_file();
  void verify_entries();
  void verify_at(std::int64_t number, const std::optional<job::CaptureRow>& row);
  void verify_checks(const Entry& entry);
  void find_added();
  void tell_swaps();

  fs::path folder_;
  const VerifyOptions& options_;
  bool is_open_ = false;
  JournalView journal_;
  std::optional<job::JobFile> job_;
  std::string previous_sha256_;
  std::set<std::string> expected_;               // files that belong to the job
  std::map<std::string, std::string> recorded_;  // SHA-256 to the name it was recorded under
  Verified verified_;
};

void Verification::read_journal() {
  const auto path = job::journal_path(folder_);
  if (!job::facts_of(folder_, "journal.db")) {
    change(Kind::kRemoved, "journal.db", "is not there, or is no file that can be read");
    return;
  }
  auto journal = job::Journal::open(path, job::OpenFor::kReading);
  if (!journal || !journal->damage().empty()) {
    change(Kind::kChanged, "journal.db",
           "cannot be read (" + (journal ? journal->damage() : journal.error().message) + ")");
    return;
  }
  auto records = journal->records();
  auto captures = journal->captures();
  if (!records || !captures) {
    change(Kind::kChanged, "journal.db", "holds what no SpoolSight wrote");
    return;
  }
  journal_ = {true, journal->version(), *std::move(records), *std::move(captures)};
}

// A program that died, or is at work, has not sealed what it wrote: that is no alteration.
void Verification::take_seal(const std::vector<Change>& changes) {
  const bool has_no_seals = journal_.is_readable && journal_.version < 2;
  if (has_no_seals) verified_.notes.emplace_back("the job was made before jobs were sealed");
  bool is_stale = false;
  for (const Change& each : changes) {
    const bool is_work = each.file == "journal.db" || each.file == "job.json" ||
                         each.file == job::kSealFile || each.file.starts_with("journal.");
    if (has_no_seals && each.file == job::kSealFile) continue;
    if (is_open_ && is_work && each.kind != Kind::kRemoved)
      is_stale = true;
    else if (!is_told(each.file))
      verified_.changes.push_back(each);
  }
  if (is_open_)
    verified_.notes.emplace_back(
        "the job is open, or the last program on it ended without closing it" +
        std::string(is_stale ? ": what that wrote into job.json and journal.db is not sealed yet"
                             : ""));
}

void Verification::read_job_file() {
  expected_ = {"lock", job::kSealFile, "job.json", "journal.db", "journal.db-shm", "evidence/"};
  std::error_code code;
  const auto log = fs::symlink_status(folder_ / "journal.db-wal", code);
  const bool has_log = log.type() == fs::file_type::regular;
  if (has_log && (is_open_ || fs::file_size(folder_ / "journal.db-wal", code) == 0))
    expected_.insert("journal.db-wal");
  const auto facts = job::facts_of(folder_, "job.json");
  if (!facts) {
    if (!is_told("job.json")) change(Kind::kRemoved, "job.json", "is not there");
    return;
  }
  auto file = job::read_job_file(folder_ / "job.json");
  if (!file) {
    if (!is_told("job.json")) change(Kind::kChanged, "job.json", file.error().message);
    return;
  }
  const auto check = [&](const std::string& name, const std::string& sha256) {
    if (name.empty()) return;
    expected_.insert(name);
    const auto there = job::facts_of(folder_, name);
    if (is_told(name)) return;
    if (!there)
      change(Kind::kRemoved, name, "is not there");
    else if (there->sha256 != sha256)
      change(Kind::kChanged, name, "has another SHA-256 than job.json says");
  };
  check(file->design, file->design_sha256);
  check(file->source, file->source_sha256);
  job_ = *std::move(file);
}

// All that an entry says of the job around it.
void Verification::verify_checks(const Entry& entry) {
  if (!journal_.is_readable) return;
  const auto name = entry_name(entry.number);
  const auto is_later = [&](const job::CheckRecord& each) { return each.id > entry.check.id; };
  const auto end = std::find_if(journal_.records.begin(), journal_.records.end(), is_later);
  const auto count = static_cast<std::size_t>(end - journal_.records.begin());
  if (job::checks_sha256({journal_.records.data(), count}) != entry.checks_sha256)
    change(Kind::kChanged, "journal.db",
           fmt::format("checks 1 to {} are not those that evidence/{} was made with",
                       entry.check.id, name));
  if (job_ && (job_->design != entry.design || job_->design_sha256 != entry.design_sha256))
    change(Kind::kChanged, "job.json",
           "names another design than evidence/" + name + " was made with");
}

void Verification::verify_at(std::int64_t number, const std::optional<job::CaptureRow>& row) {
  const fs::path evidence = folder_ / "evidence";
  const std::string name = entry_name(number);
  EntryPlace place{evidence / name, "evidence/" + name + "/", number, previous_sha256_, row};
  std::error_code code;
  const auto is_folder = [&](const fs::path& path) {
    return fs::symlink_status(path, code).type() == fs::file_type::directory;
  };
  std::string there = place.prefix;
  if (!is_folder(place.folder) && row && is_folder(evidence / staging_name(number))) {
    place.folder = evidence / staging_name(number);
    there = "evidence/" + staging_name(number) + "/";
    verified_.notes.push_back("evidence/" + name +
                              " waits for its name; the next capture gives it");
  }
  previous_sha256_ = row ? row->entry_sha256 : std::string();
  if (!is_folder(place.folder)) {
    change(Kind::kRemoved, "evidence/" + name, "the whole entry is not there");
    return;
  }
  const EntryVerdict verdict = verify_entry(place, options_, recorded_, verified_);
  if (!row) previous_sha256_ = verdict.sha256;
  if (!verdict.entry) {
    // Nothing says any more what belongs there.
    for (const std::string& file : job::files_below(place.folder)) expected_.insert(there + file);
    verified_.notes.push_back("the files of evidence/" + name +
                              " cannot be checked without its entry");
  }
  for (const std::string& file : verdict.files)
    expected_.insert(there + file.substr(place.prefix.size()));
  if (verdict.entry && (!row || verdict.sha256 == row->entry_sha256)) verify_checks(*verdict.entry);
}

void Verification::verify_entries() {
  if (journal_.is_readable) {
    std::int64_t next = 1;
    for (const job::CaptureRow& row : journal_.captures) {
      if (row.number != next)
        change(Kind::kChanged, "journal.db",
               fmt::format("entry {} follows entry {}", row.number, next - 1));
      next = row.number + 1;
      verify_at(row.number, row);
    }
    return;
  }
  // Without a journal the entries still vouch for each other, but not for how many there were.
  std::int64_t last = 0;
  std::error_code code;
  for (const auto& each : fs::directory_iterator(folder_ / "evidence", code)) {
    const std::string name = each.path().filename().string();
    constexpr std::size_t kDigits = 6;
    if (name.size() == kDigits && name.find_first_not_of("0123456789") == std::string::npos)
      last = std::max(last, static_cast<std::int64_t>(std::stol(name)));
  }
  constexpr std::int64_t kMost = 100000;  // a single folder 999999 is no reason to name the rest
  if (last > kMost) last = 0;
  for (std::int64_t number = 1; number <= last; ++number) verify_at(number, std::nullopt);
}

void Verification::find_added() {
  std::set<std::string> pictures;  // that a person put there and a check names
  for (const job::CheckRecord& record : journal_.records) {
    if (!record.picture.empty()) pictures.insert("evidence/" + record.picture);
  }
  std::set<std::string> begun;
  for (const std::string& file : job::files_below(folder_)) {
    if (expected_.contains(file) || is_told(file)) continue;
    constexpr std::string_view kBegun = "evidence/.capture-";
    if (file.starts_with("journal.damaged-") && file.find('/') == std::string::npos)
      continue;  // the seal has it
    if (is_open_ && job::is_half_written(file)) {
      verified_.notes.push_back(file + " was being written when a program ended");
    } else if (file.starts_with(kBegun)) {
      begun.insert(file.substr(0, file.find('/', kBegun.size())));
    } else if (pictures.contains(file)) {
      verified_.notes.push_back(file + " is a check's picture that no entry holds");
    } else {
      change(Kind::kAdded, file, "belongs to nothing that was recorded");
    }
  }
  for (const std::string& each : begun)
    verified_.notes.push_back(each +
                              " is left of a capture that was broken off; the next clears it");
}

void Verification::tell_swaps() {
  for (Change& each : verified_.changes) {
    if (each.kind != Kind::kChanged || recorded_.empty()) continue;
    const auto now = job::facts_of(folder_, each.file);
    const auto other = now ? recorded_.find(now->sha256) : recorded_.end();
    if (other != recorded_.end() && other->second != each.file)
      each.text += "; it holds what was recorded as " + other->second;
  }
}

}  // namespace

Result<Verified> verify_job(const fs::path& folder, const VerifyOptions& options) {
  std::error_code code;
  const auto has = [&](const char* name) {
    return fs::symlink_status(folder / name, code).type() != fs::file_type::not_found;
  };
  if (!fs::is_directory(folder, code) || !(has("job.json") || has("journal.db")))
    return Error{ErrorCode::kBadInput,
                 folder.string() + ": is no job's folder; name a NAME.spooljob"};
  return Verification(folder, options).run();
}

}  // namespace spool::evidence
