// Files and folders that are on the disk once a function returns.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/evidence/durable_folder.h"

#include <cerrno>
#include <string>
#include <system_error>
#include <vector>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace spool::evidence {
namespace {

namespace fs = std::filesystem;

Error failed(const fs::path& path, const char* what, int code, ErrorCode kind = ErrorCode::kIo) {
  return {kind, path.string() + ": cannot be " + what + " (" +
                    std::generic_category().message(code) + "); free space or check its rights"};
}

struct Descriptor {
  explicit Descriptor(int opened) : number(opened) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (number >= 0) ::close(number);
  }
  int number;
};

}  // namespace

Status copy_durably(const fs::path& from, const fs::path& to) {
  const Descriptor source(::open(from.c_str(), O_RDONLY | O_CLOEXEC));
  if (source.number < 0) return failed(from, "read", errno, ErrorCode::kBadInput);
  const Descriptor target(::open(to.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644));
  if (target.number < 0) return failed(to, "written", errno);
  std::vector<char> part(std::size_t{1} << 20U);
  while (true) {
    const ssize_t count = ::read(source.number, part.data(), part.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return failed(from, "read", errno, ErrorCode::kBadInput);
    if (count == 0) break;
    for (ssize_t done = 0; done < count;) {
      const ssize_t n =
          ::write(target.number, part.data() + done, static_cast<std::size_t>(count - done));
      if (n < 0 && errno == EINTR) continue;
      if (n < 0) return failed(to, "written", errno);
      done += n;
    }
  }
  if (::fsync(target.number) != 0) return failed(to, "written", errno);
  return {};
}

Status date_file(const fs::path& path, double seconds) {
  const Descriptor file(::open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NOFOLLOW));
  const timespec at{static_cast<time_t>(seconds), 0};
  const timespec times[2] = {at, at};
  if (file.number < 0 || ::futimens(file.number, times) != 0 || ::fsync(file.number) != 0)
    return failed(path, "dated", errno);
  return {};
}

Status sync_folder(const fs::path& folder) {
  const Descriptor opened(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (opened.number < 0 || ::fsync(opened.number) != 0) return failed(folder, "synced", errno);
  return {};
}

Status sync_folders(const fs::path& folder) {
  std::error_code code;
  for (const auto& each : fs::recursive_directory_iterator(folder, code)) {
    if (!each.is_directory(code)) continue;
    if (Status done = sync_folder(each.path()); !done) return done;
  }
  return sync_folder(folder);
}

}  // namespace spool::evidence
