// SQLite behind two handles: a database and a statement.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/job/sqlite.h"

#include <cstring>
#include <utility>

#include <sqlite3.h>

namespace spool::job {
namespace {

// A path as a file: URI, every byte that could mean something escaped.
std::string uri_of(const std::filesystem::path& path, const char* query) {
  constexpr char kHex[] = "0123456789ABCDEF";
  std::string uri = "file:";
  for (const char c : std::filesystem::absolute(path).string()) {
    const bool is_plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                          (c >= '0' && c <= '9') || std::strchr("/-_.~", c) != nullptr;
    const auto byte = static_cast<unsigned char>(c);
    if (is_plain && c != 0)
      uri += c;
    else
      uri += {'%', kHex[byte >> 4], kHex[byte & 15]};
  }
  return uri + query;
}

int flags_of(OpenFor use) {
  constexpr int kAlways = SQLITE_OPEN_URI | SQLITE_OPEN_NOMUTEX | SQLITE_OPEN_EXRESCODE;
  switch (use) {
    case OpenFor::kReading:
      return kAlways | SQLITE_OPEN_READONLY;
    case OpenFor::kWriting:
      return kAlways | SQLITE_OPEN_READWRITE;
    case OpenFor::kCreating:
      return kAlways | SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE;
  }
  return kAlways | SQLITE_OPEN_READONLY;
}

}  // namespace

void Database::Close::operator()(sqlite3* handle) const { sqlite3_close_v2(handle); }
void Statement::Finalize::operator()(sqlite3_stmt* handle) const { sqlite3_finalize(handle); }

Result<Database> Database::open(const std::filesystem::path& path, OpenFor use) {
  std::error_code code;
  if (use != OpenFor::kCreating && !std::filesystem::is_regular_file(path, code))
    return Error{ErrorCode::kBadInput, path.string() + ": is not there; check the path"};
  const auto opened = [&](const std::string& uri) -> Result<Database> {
    Database database;
    database.file_ = path.string();
    sqlite3* handle = nullptr;
    const int done = sqlite3_open_v2(uri.c_str(), &handle, flags_of(use), nullptr);
    database.handle_.reset(handle);
    if (handle == nullptr) return Error{ErrorCode::kIo, database.file_ + ": no memory to open it"};
    if (done != SQLITE_OK) return database.error();
    sqlite3_busy_timeout(handle, 2000);  // ms: a reader waits for a commit of the writer
    return database;
  };
  Result<Database> database = opened(uri_of(path, ""));
  if (!database || use != OpenFor::kReading) return database;
  // A reader keeps a file of its own beside a journal of this kind; where the folder takes none,
  // and nothing is left in the log, the file can be read as it stands.
  if (const auto tried = database->integer("SELECT count(*) FROM sqlite_schema"); tried)
    return database;
  const int failure = sqlite3_errcode(database->handle_.get()) & 0xff;
  const bool has_log = std::filesystem::exists(path.string() + "-wal", code) &&
                       std::filesystem::file_size(path.string() + "-wal", code) > 0;
  if ((failure == SQLITE_CANTOPEN || failure == SQLITE_READONLY) && !has_log)
    return opened(uri_of(path, "?immutable=1"));
  return database;
}

Status Database::execute(const std::string& sql) {
  if (sqlite3_exec(handle_.get(), sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK)
    return error();
  return {};
}

Result<Statement> Database::prepare(const std::string& sql) {
  sqlite3_stmt* handle = nullptr;
  if (sqlite3_prepare_v2(handle_.get(), sql.c_str(), -1, &handle, nullptr) != SQLITE_OK)
    return error();
  return Statement(handle);
}

Result<std::int64_t> Database::integer(const std::string& sql) {
  auto statement = prepare(sql);
  if (!statement) return statement.error();
  if (!statement->step_row()) return error();
  return statement->integer(0);
}

Result<std::string> Database::text(const std::string& sql) {
  auto statement = prepare(sql);
  if (!statement) return statement.error();
  if (!statement->step_row()) return error();
  return statement->text(0);
}

std::int64_t Database::last_row() const { return sqlite3_last_insert_rowid(handle_.get()); }

bool Database::is_damaged() const {
  const int code = sqlite3_errcode(handle_.get()) & 0xff;
  return code == SQLITE_CORRUPT || code == SQLITE_NOTADB;
}

Error Database::error() const {
  const std::string reason = sqlite3_errmsg(handle_.get());
  switch (sqlite3_errcode(handle_.get()) & 0xff) {
    case SQLITE_CORRUPT:
    case SQLITE_NOTADB:
      return {ErrorCode::kBadInput, file_ + ": is damaged (" + reason + "); salvage it"};
    case SQLITE_FULL:
      return {ErrorCode::kIo,
              file_ + ": nothing more can be written, the disk is full; free space"};
    case SQLITE_READONLY:
    case SQLITE_CANTOPEN:
    case SQLITE_PERM:
      return {ErrorCode::kIo,
              file_ + ": cannot be opened for this (" + reason + "); check the folder's rights"};
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return {ErrorCode::kIo, file_ + ": another program is writing to it; close that first"};
    default:
      return {ErrorCode::kIo,
              file_ + ": reading or writing failed (" + reason + "); check disk and space"};
  }
}

void Statement::bind(int at, std::int64_t value) { sqlite3_bind_int64(handle_.get(), at, value); }

void Statement::bind(int at, const std::string& value) {
  sqlite3_bind_text(handle_.get(), at, value.data(), static_cast<int>(value.size()),
                    SQLITE_TRANSIENT);
}

void Statement::bind(int at, std::optional<double> value) {
  if (value)
    sqlite3_bind_double(handle_.get(), at, *value);
  else
    sqlite3_bind_null(handle_.get(), at);
}

bool Statement::step_row() {
  const int code = sqlite3_step(handle_.get());
  is_done_ = code == SQLITE_DONE;
  return code == SQLITE_ROW;
}

void Statement::reset() {
  sqlite3_reset(handle_.get());
  sqlite3_clear_bindings(handle_.get());
}

std::int64_t Statement::integer(int column) const {
  return sqlite3_column_int64(handle_.get(), column);
}

std::string Statement::text(int column) const {
  const auto* bytes = sqlite3_column_text(handle_.get(), column);
  if (bytes == nullptr) return {};
  return {reinterpret_cast<const char*>(bytes),
          static_cast<std::size_t>(sqlite3_column_bytes(handle_.get(), column))};
}

std::optional<double> Statement::number(int column) const {
  if (is_null(column)) return std::nullopt;
  return sqlite3_column_double(handle_.get(), column);
}

bool Statement::is_null(int column) const {
  return sqlite3_column_type(handle_.get(), column) == SQLITE_NULL;
}

}  // namespace spool::job
