// A soak of the whole program, watched from outside.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <system_error>
#include <thread>
#include <vector>

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tools/soak/long_recording.h"
#include "tools/soak/soak.h"
#include "tools/soak/soak_log.h"

namespace spool::soak {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kLook{250};
constexpr double kLineEvery = 60;  // s

Result<pid_t> start(std::vector<std::string> words) {
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  pid_t child = 0;
  const int code =
      ::posix_spawn(&child, words.front().c_str(), nullptr, nullptr, arguments.data(), environ);
  if (code != 0)
    return Error{ErrorCode::kIo, words.front() + ": does not start (" +
                                     std::generic_category().message(code) + "); build spoolsight"};
  return child;
}

// Memory by wall time until the child ends; its exit code.
Result<int> watch(pid_t child, const std::atomic<bool>& stop, std::vector<double>& seconds,
                  std::vector<Resident>& resident) {
  const auto begun = Clock::now();
  double line_at = 0;
  bool is_told = false;
  std::printf("| wall min | resident MiB |\n|---|---|\n");
  for (;;) {
    int status = 0;
    const pid_t ended = ::waitpid(child, &status, WNOHANG);
    if (ended < 0)
      return Error{ErrorCode::kInternal, "spoolsight cannot be waited for (" +
                                             std::generic_category().message(errno) + ")"};
    if (ended == child) return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    const double now = std::chrono::duration<double>(Clock::now() - begun).count();
    if (const auto held = resident_memory(child)) {
      seconds.push_back(now);
      resident.push_back(*held);
      if (now >= line_at) {
        line_at += kLineEvery;
        std::printf("| %7.2f | %7.1f |\n", now / 60, held->now_mib);
        std::fflush(stdout);
      }
    }
    if (stop && !is_told) {
      ::kill(child, SIGTERM);  // it ends as when its window is closed
      is_told = true;
    }
    std::this_thread::sleep_for(kLook);
  }
}

}  // namespace

Result<int> soak_program(const SoakRequest& request) {
  const auto recording = LongRecording::make(request.source, 60 * request.minutes);
  if (!recording) return recording.error();
  std::error_code failed;
  const fs::path program = fs::read_symlink("/proc/self/exe", failed).parent_path() / "spoolsight";
  const fs::path out = recording->folder() / "out";
  const auto begun = Clock::now();
  const auto child =
      start({program.string(), "--design", request.design, "--source", recording->folder().string(),
             "--headless", "--script", request.script.string(), "--out", out.string()});
  if (!child) return child.error();
  std::vector<double> seconds;
  std::vector<Resident> resident;
  const auto code = watch(*child, *request.stop, seconds, resident);
  if (!code) return code.error();
  if (*code != 0)
    return Error{ErrorCode::kInternal, "spoolsight ended with " + std::to_string(*code)};
  if (*request.stop) {
    std::printf("\nended early: nobody knows how much was played\n");
    return 1;
  }
  const double wall = std::chrono::duration<double>(Clock::now() - begun).count();
  const double played = 60 * request.minutes;
  MemoryLog memory(played);
  // In lock step a recording goes by as evenly as frames are drawn.
  for (std::size_t i = 0; i < seconds.size(); ++i)
    memory.add(seconds[i] * played / wall, resident[i]);
  std::printf("\nplayed %.1f min, %zu frames in %.1f min, %.1f ms each with their screens\n",
              request.minutes, recording->frames(), wall / 60,
              1e3 * wall / static_cast<double>(recording->frames()));
  // What the program inspects at its end is the last frame that it was sure of.
  std::printf("the spool %s\n", fs::exists(out / "report.json", failed)
                                    ? "was followed, and inspected at the end"
                                    : "was NEVER followed: the taps align nothing");
  return print_verdict(memory);
}

}  // namespace spool::soak
