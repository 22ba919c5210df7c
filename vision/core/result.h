// Result<T>: a value, or the one sentence that says what failed outside and what to do about it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cassert>
#include <string>
#include <utility>
#include <variant>

namespace spool {

// What kind of thing in the outside world failed. The numbers are the programs' exit codes
// (sysexits), fixed by ARCHITECTURE, Command lines.
enum class ErrorCode {
  kUsage = 64,     // the command line makes no sense
  kBadInput = 65,  // a file is missing, damaged, hostile or of the wrong kind
  kNoDevice = 69,  // no camera, no display, no GL driver
  kInternal = 70,  // a fault of ours
  kIo = 74,        // reading or writing failed: disk full, no permission
};

// One sentence that names the file or device and says what to do.
struct Error {
  ErrorCode code = ErrorCode::kInternal;
  std::string message;
};

[[nodiscard]] constexpr int exit_code(ErrorCode code) { return static_cast<int>(code); }

// A value or an Error. Spelled as std::expected so that it can be replaced by it one day.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value)
      : state_(std::in_place_index<0>, std::move(value)) {}  // NOLINT(google-explicit-constructor)
  Result(Error error)
      : state_(std::in_place_index<1>, std::move(error)) {}  // NOLINT(google-explicit-constructor)

  [[nodiscard]] bool has_value() const { return state_.index() == 0; }
  explicit operator bool() const { return has_value(); }

  [[nodiscard]] T& value() & {
    assert(has_value() && "value() of a Result that holds an error");
    return std::get<0>(state_);
  }
  [[nodiscard]] const T& value() const& {
    assert(has_value() && "value() of a Result that holds an error");
    return std::get<0>(state_);
  }
  [[nodiscard]] T&& value() && {
    assert(has_value() && "value() of a Result that holds an error");
    return std::get<0>(std::move(state_));
  }
  T& operator*() & { return value(); }
  const T& operator*() const& { return value(); }
  T&& operator*() && { return std::move(*this).value(); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }

  [[nodiscard]] const Error& error() const {
    assert(!has_value() && "error() of a Result that holds a value");
    return std::get<1>(state_);
  }

 private:
  std::variant<T, Error> state_;
};

// Success or an Error, for functions that only act.
template <>
class [[nodiscard]] Result<void> {
 public:
  Result() = default;
  Result(Error error)
      : error_(std::move(error)), ok_(false) {}  // NOLINT(google-explicit-constructor)
  [[nodiscard]] bool has_value() const { return ok_; }
  explicit operator bool() const { return ok_; }
  [[nodiscard]] const Error& error() const {
    assert(!ok_ && "error() of a Result that succeeded");
    return error_;
  }

 private:
  Error error_;
  bool ok_ = true;
};

using Status = Result<void>;

}  // namespace spool
