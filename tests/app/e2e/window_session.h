// The program in a window, followed by what it prints of its screen.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "tests/app/e2e/running_program.h"

namespace spool::test {

// True where this machine must have what the window's tests need: its absence is a failure then.
[[nodiscard]] bool display_is_required();

class WindowSession {
 public:
  // `arguments` of the program beside --print-targets; `display` as in DISPLAY.
  WindowSession(const std::string& display, const std::vector<std::string>& arguments);

  // Reads what the screen says until `wanted` holds; false where it never does.
  [[nodiscard]] bool until(const std::function<bool(const nlohmann::json&)>& wanted);
  [[nodiscard]] bool until_offered(const std::string& target);
  [[nodiscard]] const nlohmann::json& screen() const { return screen_; }
  [[nodiscard]] static bool until_written(const std::filesystem::path& file);
  [[nodiscard]] int end();  // by SIGTERM; its exit code

 private:
  RunningProgram app_;
  nlohmann::json screen_;
};

}  // namespace spool::test

// Skips the test with `reason`, or fails it where this machine must be able to.
#define SPOOL_SKIP_WITHOUT_DISPLAY(reason)                    \
  do {                                                        \
    if (spool::test::display_is_required()) FAIL() << reason; \
    GTEST_SKIP() << reason;                                   \
  } while (false)
