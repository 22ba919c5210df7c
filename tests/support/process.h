// Runs a built program as a user does, and gives what it said and how it ended.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace spool::test {

struct ProcessResult {
  int code = -1;   // exit code; -1 where a signal ended it
  int signal = 0;  // that signal
  std::string out, err;
};

struct ProcessOptions {
  std::uint64_t file_size_limit_bytes = 0;  // over 0: no file may grow beyond it, as on a full disk
  std::vector<std::pair<std::string, std::string>> environment;  // set beside what is inherited
};

// Waits for the end. stdin is empty.
[[nodiscard]] ProcessResult run(const std::filesystem::path& program,
                                const std::vector<std::string>& arguments,
                                const ProcessOptions& options = {});

}  // namespace spool::test
