// Plays an .oni file in a child process before this one trusts it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/sensor/oni_check.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <mutex>
#include <optional>
#include <set>
#include <system_error>

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "vision/core/file_digest.h"
#include "vision/core/file_io.h"

namespace spool::sensor {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr int kStillRunning = -1;

Error bad(const std::string& path, const std::string& why) {
  return Error{ErrorCode::kBadInput, path + ": " + why + "; record it again"};
}

// The folder that remembers recordings; nothing where the user has no home.
std::optional<fs::path> cache_folder() {
  if (const char* cache = std::getenv("XDG_CACHE_HOME"); cache != nullptr && *cache == '/')
    return fs::path(cache) / "spoolsight" / "played-oni";
  if (const char* home = std::getenv("HOME"); home != nullptr && *home == '/')
    return fs::path(home) / ".cache" / "spoolsight" / "played-oni";
  return std::nullopt;
}

// Which recordings this process saw pass.
class Passed {
 public:
  bool contains(const std::string& digest) {
    {
      const std::scoped_lock lock(mutex_);
      if (digests_.count(digest) != 0) return true;
    }
    std::error_code ignored;
    const auto folder = cache_folder();
    return folder && fs::is_regular_file(*folder / digest, ignored);
  }
  void add(const std::string& digest, const std::string& path) {
    {
      const std::scoped_lock lock(mutex_);
      digests_.insert(digest);
    }
    // Without a writable cache the file is only played again by the next process.
    const auto folder = cache_folder();
    if (folder && make_folder(*folder))
      static_cast<void>(write_file_whole(*folder / digest, path + "\n"));
  }

 private:
  std::mutex mutex_;
  std::set<std::string> digests_;
};

Passed& passed() {
  static Passed all;
  return all;
}

// Reads what the child says until it closes its end; false when `deadline` came first.
bool read_until_closed(int fd, Clock::time_point deadline, std::string& text) {
  for (;;) {
    const auto left =
        std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
    pollfd waiting{fd, POLLIN, 0};
    const int ready = ::poll(&waiting, 1, static_cast<int>(std::max<long long>(left, 0)));
    if (ready < 0 && errno == EINTR) continue;
    if (ready <= 0) return false;
    std::array<char, 1024> part{};
    const ssize_t n = ::read(fd, part.data(), part.size());
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return true;
    if (text.size() < 4096) text.append(part.data(), static_cast<std::size_t>(n));
  }
}

struct Outcome {
  int status = kStillRunning;  // of waitpid; kStillRunning: it was stopped at the deadline
  std::string text;            // what it said
};

// Runs `program path` with no input, its output caught and its complaints dropped.
Result<Outcome> run(const fs::path& program, const std::string& path, Clock::duration limit) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0)
    return Error{ErrorCode::kInternal,
                 path + ": no pipe for its check (" + std::generic_category().message(errno) + ")"};
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, ends[1], 1);
  posix_spawn_file_actions_addopen(&actions, 2, "/dev/null", O_WRONLY, 0);
  std::string name = program.string(), argument = path;
  std::array<char*, 3> arguments = {name.data(), argument.data(), nullptr};
  pid_t child = 0;
  const int code =
      ::posix_spawn(&child, name.c_str(), &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  ::close(ends[1]);
  if (code != 0) {
    ::close(ends[0]);
    return Error{ErrorCode::kInternal, name + ": does not run (" +
                                           std::generic_category().message(code) +
                                           "); .oni files need it beside the programs"};
  }
  Outcome outcome;
  const bool closed = read_until_closed(ends[0], Clock::now() + limit, outcome.text);
  ::close(ends[0]);
  if (!closed) ::kill(child, SIGKILL);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (closed) outcome.status = status;
  return outcome;
}

}  // namespace

Status check_oni(const std::string& path) {
  std::error_code code;
  if (!fs::is_regular_file(path, code))
    return Error{ErrorCode::kBadInput, path + ": is no file that can be read; check the path"};
  const auto size = fs::file_size(path, code);
  if (size == 0) return bad(path, "is empty");
  const auto digest = sha256_file(path);
  if (!digest) return digest.error();
  if (passed().contains(*digest)) return {};
  const fs::path self = fs::read_symlink("/proc/self/exe", code);
  // A sound recording plays at 100 MB/s and more: this is slow by far, and an end for one that
  // hangs.
  const std::chrono::seconds limit(30 + static_cast<long long>(size / 5'000'000));
  const auto outcome = run(self.parent_path() / "spoolsight-oni-check", path, limit);
  if (!outcome) return outcome.error();
  if (outcome->status == kStillRunning) return bad(path, "does not come to its end");
  if (WIFSIGNALED(outcome->status)) return bad(path, "is damaged, playing it crashes OpenNI2");
  const int exit = WEXITSTATUS(outcome->status);
  if (exit == 0) {
    passed().add(*digest, path);
    return {};
  }
  if (!outcome->text.empty() && exit == exit_code(ErrorCode::kBadInput))
    return Error{ErrorCode::kBadInput, outcome->text.substr(0, outcome->text.find('\n'))};
  if (!outcome->text.empty() && exit == exit_code(ErrorCode::kNoDevice))
    return Error{ErrorCode::kNoDevice, outcome->text.substr(0, outcome->text.find('\n'))};
  return bad(path, "is damaged, OpenNI2 cannot play it");
}

}  // namespace spool::sensor
