// A program that runs beside the test: its lines as they come, ended with the test.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <sys/types.h>

namespace spool::test {

// The full path of a tool that the system has; nothing where it has none.
[[nodiscard]] std::optional<std::string> find_tool(const std::string& name);

class RunningProgram {
 public:
  // Starts `words[0]`; its standard output comes to next_line().
  RunningProgram(const std::vector<std::string>& words,
                 const std::vector<std::pair<std::string, std::string>>& environment = {});
  RunningProgram(const RunningProgram&) = delete;
  RunningProgram& operator=(const RunningProgram&) = delete;
  ~RunningProgram();  // ends it where it still runs

  // Nothing when `timeout` passed or there is no more.
  [[nodiscard]] std::optional<std::string> next_line(std::chrono::milliseconds timeout);
  void terminate() const;  // SIGTERM
  [[nodiscard]] int wait_for_end(
      std::chrono::seconds timeout);  // exit code; -1: a signal or no end

 private:
  pid_t child_ = -1;
  int pipe_ = -1;
  std::string buffer_;
};

}  // namespace spool::test
