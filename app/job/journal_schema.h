// The tables of journal.db (ARCHITECTURE, Job), and how a row is a record.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/job/check_record.h"
#include "app/job/sqlite.h"

namespace spool::job {

inline constexpr int kApplicationId = 0x53504a4c;  // "SPJL", PRAGMA application_id

// Tables, and triggers that refuse every change of what was written.
inline constexpr char kJournalSchema[] = R"(
CREATE TABLE checks (
  id INTEGER PRIMARY KEY AUTOINCREMENT,
  step INTEGER NOT NULL,
  part TEXT NOT NULL,
  joint TEXT NOT NULL,
  phase TEXT NOT NULL CHECK (phase IN ('before-tack', 'after-tack', 'before-weld', 'after-weld')),
  outcome TEXT NOT NULL CHECK (outcome IN ('accept', 'remark', 'redo')),
  status TEXT NOT NULL,
  remark TEXT NOT NULL,
  operator TEXT NOT NULL,
  override_reason TEXT NOT NULL,
  picture TEXT NOT NULL,
  report_sha256 TEXT NOT NULL,
  wall_s REAL NOT NULL,
  boot_s REAL NOT NULL,
  boot TEXT NOT NULL,
  T_design_part TEXT,
  covariance TEXT);
CREATE TABLE numbers (
  check_id INTEGER NOT NULL REFERENCES checks(id),
  position INTEGER NOT NULL,
  name TEXT NOT NULL,
  kind TEXT NOT NULL,
  unit TEXT NOT NULL CHECK (unit IN ('m', 'rad')),
  nominal REAL, measured REAL, deviation REAL, u REAL, tolerance REAL,
  status TEXT NOT NULL,
  PRIMARY KEY (check_id, position)) WITHOUT ROWID;
CREATE TRIGGER checks_stay BEFORE UPDATE ON checks
  BEGIN SELECT RAISE(ABORT, 'a check is never changed'); END;
CREATE TRIGGER checks_last BEFORE DELETE ON checks
  BEGIN SELECT RAISE(ABORT, 'a check is never deleted'); END;
CREATE TRIGGER numbers_stay BEFORE UPDATE ON numbers
  BEGIN SELECT RAISE(ABORT, 'a check is never changed'); END;
CREATE TRIGGER numbers_last BEFORE DELETE ON numbers
  BEGIN SELECT RAISE(ABORT, 'a check is never deleted'); END;
)";

// Since version 2. A capture's row is written in the transaction of its check.
inline constexpr char kCaptureSchema[] = R"(
CREATE TABLE captures (
  number INTEGER PRIMARY KEY,
  check_id INTEGER NOT NULL REFERENCES checks(id),
  entry_sha256 TEXT NOT NULL,
  signer TEXT NOT NULL,
  wall_s REAL NOT NULL);
CREATE TRIGGER captures_stay BEFORE UPDATE ON captures
  BEGIN SELECT RAISE(ABORT, 'a capture is never changed'); END;
CREATE TRIGGER captures_last BEFORE DELETE ON captures
  BEGIN SELECT RAISE(ABORT, 'a capture is never deleted'); END;
)";

inline constexpr char kCheckColumns[] =
    "id, step, part, joint, phase, outcome, status, remark, operator, override_reason, picture, "
    "report_sha256, wall_s, boot_s, boot, T_design_part, covariance";
inline constexpr char kNumberColumns[] =
    "check_id, position, name, kind, unit, nominal, measured, deviation, u, tolerance, status";

inline constexpr char kCaptureColumns[] = "number, check_id, entry_sha256, signer, wall_s";

// Binds all columns of a check in that order; id 0 is given by the journal.
void bind_check(Statement& insert, const CheckRecord& record);
void bind_number(Statement& insert, std::int64_t check, std::int64_t position,
                 const CheckNumber& number);
// A row of these columns; nothing where its words or numbers are none of ours (a damaged page).
[[nodiscard]] std::optional<CheckRecord> check_of(const Statement& row);
[[nodiscard]] CheckNumber number_of(const Statement& row);
void bind_capture(Statement& insert, const CaptureRow& capture);
[[nodiscard]] CaptureRow capture_of(const Statement& row);

}  // namespace spool::job
