// SQLite behind two handles: a database and a statement; every failure is an Error with the file's
// name.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "vision/core/result.h"

struct sqlite3;
struct sqlite3_stmt;

namespace spool::job {

enum class OpenFor { kReading, kWriting, kCreating };

class Statement;

// One connection. One thread at a time.
class Database {
 public:
  // kBadInput: missing or no database; kIo: the disk or the folder's rights. A file that is only
  // read, in a folder that nothing can be written to, is read as it stands.
  [[nodiscard]] static Result<Database> open(const std::filesystem::path& path, OpenFor use);

  [[nodiscard]] Status execute(const std::string& sql);
  [[nodiscard]] Result<Statement> prepare(const std::string& sql);
  // The first column of the first row.
  [[nodiscard]] Result<std::int64_t> integer(const std::string& sql);
  [[nodiscard]] Result<std::string> text(const std::string& sql);
  [[nodiscard]] std::int64_t last_row() const;
  // What went wrong last, as a sentence. Codes: damage is kBadInput, all else kIo.
  [[nodiscard]] Error error() const;
  [[nodiscard]] bool is_damaged() const;  // the last failure was that of a damaged file

 private:
  struct Close {
    void operator()(sqlite3* handle) const;
  };
  std::string file_;
  std::unique_ptr<sqlite3, Close> handle_;
};

// A prepared statement; columns count from 0, parameters from 1. It must not outlive its database.
class Statement {
 public:
  explicit Statement(sqlite3_stmt* handle) : handle_(handle) {}
  void bind(int at, std::int64_t value);
  void bind(int at, const std::string& value);
  void bind(int at, std::optional<double> value);  // nothing: NULL
  [[nodiscard]] bool step_row();                   // true: a row; else done or failed
  [[nodiscard]] bool is_done() const { return is_done_; }
  void reset();
  [[nodiscard]] std::int64_t integer(int column) const;
  [[nodiscard]] std::string text(int column) const;
  [[nodiscard]] std::optional<double> number(int column) const;
  [[nodiscard]] bool is_null(int column) const;

 private:
  struct Finalize {
    void operator()(sqlite3_stmt* handle) const;
  };
  std::unique_ptr<sqlite3_stmt, Finalize> handle_;
  bool is_done_ = false;
};

}  // namespace spool::job
