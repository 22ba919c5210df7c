// What every refusal owes its reader: the right code, and one sentence that says what is wrong.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "tests/support/process.h"
#include "vision/core/result.h"

namespace spool::test {

// One line of text that names `subject` (a file, a key, a flag; "" for none) and says `why`.
void expect_sentence(const Error& error, ErrorCode code, std::string_view subject,
                     std::string_view why);

// The same of a function's result, which has to be an error.
template <class T>
void expect_refused(const Result<T>& result, ErrorCode code, std::string_view subject,
                    std::string_view why) {
  if (result)
    ADD_FAILURE() << "not refused, though " << why;
  else
    expect_sentence(result.error(), code, subject, why);
}

// The same of a program: its exit code, nothing on stdout, on stderr one line that begins with the
// program's name.
void expect_refused(const ProcessResult& result, const std::string& program, int code,
                    std::string_view why);

}  // namespace spool::test
