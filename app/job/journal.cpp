// The journal of a job: every check that was made, appended and never changed.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/job/journal.h"

#include <algorithm>

#include <fmt/format.h>

#include "app/job/journal_schema.h"

namespace spool::job {
namespace {

std::string select_checks() { return fmt::format("SELECT {} FROM checks ", kCheckColumns); }

std::string select_numbers() {
  return fmt::format("SELECT {} FROM numbers WHERE check_id = ? ORDER BY position", kNumberColumns);
}

// Writes go to the log first and are synced at each commit.
Status make_durable(Database& database) {
  const auto mode = database.text("PRAGMA journal_mode = WAL");
  if (!mode) return mode.error();
  return database.execute("PRAGMA synchronous = FULL; PRAGMA foreign_keys = ON");
}

// A file of another program, or of a later one of ours.
Status check_version(Database& database, const std::filesystem::path& path) {
  const auto version = database.integer("PRAGMA user_version");
  if (!version) return version.error();
  const auto application = database.integer("PRAGMA application_id");
  if (!application) return application.error();
  if (*application != kApplicationId)
    return Error{ErrorCode::kBadInput, path.string() + ": is no SpoolSight journal"};
  if (*version < 1 || *version > kJournalVersion)
    return Error{ErrorCode::kBadInput,
                 fmt::format("{}: is a journal of version {}, and this SpoolSight knows version "
                             "{}; use a newer SpoolSight",
                             path.string(), *version, kJournalVersion)};
  return {};
}

// Version 1 had no captures.
Status bring_up_to_date(Database& database) {
  const auto version = database.integer("PRAGMA user_version");
  if (!version) return version.error();
  if (*version == kJournalVersion) return {};
  return database.execute(fmt::format("BEGIN IMMEDIATE; {} PRAGMA user_version = {}; COMMIT;",
                                      kCaptureSchema, kJournalVersion));
}

}  // namespace

Result<Journal> Journal::create(const std::filesystem::path& path) {
  std::error_code code;
  if (std::filesystem::exists(path, code))
    return Error{ErrorCode::kIo, path.string() + ": is there already; choose another name"};
  auto database = Database::open(path, OpenFor::kCreating);
  if (!database) return database.error();
  if (Status done = make_durable(*database); !done) return done.error();
  const std::string schema = fmt::format(
      "BEGIN IMMEDIATE; {} {} PRAGMA application_id = {}; PRAGMA user_version = {}; COMMIT;",
      kJournalSchema, kCaptureSchema, kApplicationId, kJournalVersion);
  if (Status done = database->execute(schema); !done) return done.error();
  Journal journal(*std::move(database), path);
  journal.is_writable_ = true;
  return journal;
}

Result<Journal> Journal::open(const std::filesystem::path& path, OpenFor use) {
  auto database = Database::open(path, use);
  if (!database) return database.error();
  Journal journal(*std::move(database), path);
  const auto damaged = [&](const Error& error) -> Result<Journal> {
    if (!journal.database_.is_damaged()) return error;
    journal.damage_ = error.message;
    return std::move(journal);
  };
  if (Status known = check_version(journal.database_, path); !known) return damaged(known.error());
  if (const auto version = journal.database_.integer("PRAGMA user_version"); version)
    journal.version_ = *version;
  const auto sound = journal.database_.text("PRAGMA integrity_check(1)");
  if (!sound) return damaged(sound.error());
  if (*sound != "ok") {
    std::string what = *sound;
    std::replace(what.begin(), what.end(), '\n', ' ');
    journal.damage_ = path.string() + ": is damaged (" + what + "); salvage it";
    return journal;
  }
  if (use != OpenFor::kReading) {
    if (Status done = make_durable(journal.database_); !done) return done.error();
    if (Status done = bring_up_to_date(journal.database_); !done) return done.error();
    journal.version_ = kJournalVersion;
    journal.is_writable_ = true;
  }
  return journal;
}

Status Journal::write(const CheckRecord& record) {
  auto check = database_.prepare(fmt::format(
      "INSERT INTO checks ({}) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)",
      kCheckColumns));
  if (!check) return check.error();
  bind_check(*check, record);
  if (check->step_row() || !check->is_done()) return database_.error();
  const std::int64_t id = database_.last_row();
  auto number = database_.prepare(fmt::format(
      "INSERT INTO numbers ({}) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)", kNumberColumns));
  if (!number) return number.error();
  std::int64_t position = 0;
  for (const CheckNumber& each : record.numbers) {
    number->reset();
    bind_number(*number, id, position++, each);
    if (number->step_row() || !number->is_done()) return database_.error();
  }
  return {};
}

Status Journal::insert(const CaptureRow& capture) {
  auto insert = database_.prepare(
      fmt::format("INSERT INTO captures ({}) VALUES (?, ?, ?, ?, ?)", kCaptureColumns));
  if (!insert) return insert.error();
  bind_capture(*insert, capture);
  if (insert->step_row() || !insert->is_done()) return database_.error();
  return {};
}

Status Journal::write(const CaptureRow& capture) {
  const auto check = database_.integer("SELECT max(id) FROM checks");
  if (!check) return check.error();
  const auto last = database_.integer("SELECT ifnull(max(number), 0) FROM captures");
  if (!last) return last.error();
  if (capture.check_id != *check || capture.number != *last + 1)
    return Error{ErrorCode::kUsage,
                 fmt::format("{}: capture {} of check {} does not follow capture {} and check {}",
                             path_.string(), capture.number, capture.check_id, *last, *check)};
  return insert(capture);
}

Result<std::int64_t> Journal::append(const CheckRecord& record) { return append(record, nullptr); }

Result<std::int64_t> Journal::append(const CheckRecord& record, const CaptureRow& capture) {
  return append(record, &capture);
}

Result<std::int64_t> Journal::next_id() {
  const auto last =
      database_.integer("SELECT ifnull(max(seq), 0) FROM sqlite_sequence WHERE name = 'checks'");
  if (!last) return last.error();
  return *last + 1;
}

Result<std::int64_t> Journal::append(const CheckRecord& record, const CaptureRow* capture) {
  if (!is_writable_)
    return Error{ErrorCode::kBadInput,
                 damage_.empty() ? path_.string() + ": is open for reading only" : damage_};
  if (Status begun = database_.execute("BEGIN IMMEDIATE"); !begun) return begun.error();
  Status written = write(record);
  const std::int64_t id = database_.last_row();
  if (written && capture != nullptr) written = write(*capture);
  if (written) written = database_.execute("COMMIT");
  if (!written) {
    // The first failure is the one to tell; the transaction may be gone already.
    (void)database_.execute("ROLLBACK");
    return written.error();
  }
  return id;
}

Result<std::vector<CheckRecord>> Journal::records() {
  if (!damage_.empty()) return Error{ErrorCode::kBadInput, damage_};
  auto checks = database_.prepare(select_checks() + "ORDER BY id");
  if (!checks) return checks.error();
  auto numbers = database_.prepare(select_numbers());
  if (!numbers) return numbers.error();
  std::vector<CheckRecord> records;
  while (checks->step_row()) {
    auto record = check_of(*checks);
    if (!record)
      return Error{ErrorCode::kBadInput,
                   fmt::format("{}: check {} cannot be understood; salvage it", path_.string(),
                               checks->integer(0))};
    numbers->reset();
    numbers->bind(1, record->id);
    while (numbers->step_row()) record->numbers.push_back(number_of(*numbers));
    if (!numbers->is_done()) return database_.error();
    records.push_back(*std::move(record));
  }
  if (!checks->is_done()) return database_.error();
  return records;
}

Result<std::vector<CaptureRow>> Journal::captures() {
  if (!damage_.empty()) return Error{ErrorCode::kBadInput, damage_};
  std::vector<CaptureRow> captures;
  if (version_ < 2) return captures;
  auto rows =
      database_.prepare(fmt::format("SELECT {} FROM captures ORDER BY number", kCaptureColumns));
  if (!rows) return rows.error();
  while (rows->step_row()) captures.push_back(capture_of(*rows));
  if (!rows->is_done()) return database_.error();
  return captures;
}

Result<Journal::Salvaged> Journal::salvage(const std::filesystem::path& damaged,
                                           const std::filesystem::path& fresh) {
  auto source = Database::open(damaged, OpenFor::kReading);
  if (!source) return source.error();
  auto numbers = source->prepare(select_numbers());
  auto one = source->prepare(select_checks() + "WHERE id = ?");
  if (!one) return one.error();
  auto target = create(fresh);
  if (!target) return target.error();
  Salvaged salvaged;
  // A check and what is left of its numbers, as one transaction; what is no check is left out.
  const auto keep = [&](const Statement& row) -> Status {
    auto record = check_of(row);
    if (!record || record->id <= 0) return {};
    if (numbers) {
      numbers->reset();
      numbers->bind(1, record->id);
      while (numbers->step_row()) {
        CheckNumber number = number_of(*numbers);
        if (number.unit == "m" || number.unit == "rad") record->numbers.push_back(number);
      }
    }
    const auto id = target->append(*record);
    if (!id) return id.error();
    ++salvaged.checks;
    salvaged.numbers += static_cast<std::int64_t>(record->numbers.size());
    salvaged.last_id = std::max(salvaged.last_id, record->id);
    return {};
  };
  const auto keep_captures = [&]() -> Status {
    auto rows =
        source->prepare(fmt::format("SELECT {} FROM captures ORDER BY number", kCaptureColumns));
    if (!rows) return {};  // of version 1, or lost
    while (rows->step_row()) {
      const CaptureRow capture = capture_of(*rows);
      // A capture whose check is lost cannot be kept; its folder is there and says of itself.
      if (target->insert(capture)) ++salvaged.captures;
    }
    return {};
  };
  // From the front to the damage, from the back to the damage, then one by one what lies between.
  std::int64_t front = 0, back = 0;
  bool is_whole = false;
  if (auto rows = source->prepare(select_checks() + "ORDER BY id"); rows) {
    while (rows->step_row()) {
      if (Status kept = keep(*rows); !kept) return kept.error();
      front = std::max(front, rows->integer(0));
    }
    is_whole = rows->is_done();
  }
  if (is_whole) {
    if (Status kept = keep_captures(); !kept) return kept.error();
    return salvaged;
  }
  if (auto rows = source->prepare(select_checks() + "WHERE id > ? ORDER BY id DESC"); rows) {
    rows->bind(1, front);
    while (rows->step_row()) {
      if (Status kept = keep(*rows); !kept) return kept.error();
      back = rows->integer(0);
    }
  }
  constexpr std::int64_t kBlind = 20000;  // ids tried where nothing tells how many there were
  for (std::int64_t id = front + 1; id < (back > 0 ? back : front + kBlind); ++id) {
    one->reset();
    one->bind(1, id);
    if (!one->step_row()) continue;
    if (Status kept = keep(*one); !kept) return kept.error();
  }
  if (Status kept = keep_captures(); !kept) return kept.error();
  return salvaged;
}

}  // namespace spool::job
