// The program in a window.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/app/e2e/window_session.h"

#include <cstdlib>
#include <thread>
#include <utility>
#include <vector>

#include "tests/app/application/robot_fitter.h"
#include "tests/support/shared_data.h"

namespace spool::test {

namespace {
using std::chrono::milliseconds;

// A software renderer on a busy machine draws a few frames a second, with a sanitizer fewer.
#ifdef __SANITIZE_ADDRESS__
constexpr std::chrono::seconds kPatience{400};
#else
constexpr std::chrono::seconds kPatience{90};
#endif

std::vector<std::pair<std::string, std::string>> environment(const std::string& display) {
  return {{"DISPLAY", display},
#ifdef __SANITIZE_ADDRESS__
          // The window's library unloads those of the X server's extensions before the program
          // ends: what they forgot of the display lies in no module that a suppression could name.
          // Without a window the program is searched for leaks.
          {"ASAN_OPTIONS", "detect_leaks=0:detect_stack_use_after_return=1"}
#endif
  };
}

std::vector<std::string> command_line(const std::vector<std::string>& arguments) {
  std::vector<std::string> words{program("spoolsight").string(), "--print-targets"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  return words;
}
}  // namespace

bool display_is_required() { return std::getenv("SPOOL_REQUIRE_GL") != nullptr; }

WindowSession::WindowSession(const std::string& display, const std::vector<std::string>& arguments)
    : app_(command_line(arguments), environment(display)) {}

bool WindowSession::until(const std::function<bool(const nlohmann::json&)>& wanted) {
  const auto deadline = std::chrono::steady_clock::now() + kPatience;
  while (std::chrono::steady_clock::now() < deadline) {
    if (screen_.is_object() && wanted(screen_)) return true;
    const auto line = app_.next_line(milliseconds(500));
    if (!line) continue;
    screen_ = nlohmann::json::parse(*line, nullptr, false);
  }
  return false;
}

bool WindowSession::until_offered(const std::string& target_name) {
  return until([&](const nlohmann::json& s) { return target(s, target_name).has_value(); });
}

bool WindowSession::until_written(const std::filesystem::path& file) {
  const auto deadline = std::chrono::steady_clock::now() + kPatience;
  while (!std::filesystem::exists(file)) {
    if (std::chrono::steady_clock::now() > deadline) return false;
    std::this_thread::sleep_for(milliseconds(20));
  }
  return true;
}

int WindowSession::end() {
  app_.terminate();
  return app_.wait_for_end(kPatience);
}

}  // namespace spool::test
