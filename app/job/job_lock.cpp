// One program at a time works on a job: a lock file that says who does.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/job/job_lock.h"

#include <array>
#include <cerrno>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <fmt/format.h>

#include "app/job/check_record.h"

namespace spool::job {
namespace {

// "host table-3, process 4711, since 2026-11-29T06:15:00.250Z"
std::string own_name() {
  std::array<char, 256> host{};
  if (::gethostname(host.data(), host.size() - 1) != 0) host[0] = '?';
  return fmt::format("host {}, process {}, since {}", host.data(), ::getpid(),
                     utc_text(now().wall_s));
}

std::string holder_in(int descriptor) {
  std::array<char, 512> bytes{};
  const ssize_t count = ::pread(descriptor, bytes.data(), bytes.size(), 0);
  std::string text(bytes.data(), count > 0 ? static_cast<std::size_t>(count) : 0);
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  }
  while (!text.empty() && text.back() == ' ') text.pop_back();
  return text;
}

Error cannot(const std::filesystem::path& file, int code) {
  return {ErrorCode::kIo,
          fmt::format("{}: the job cannot be locked ({}); check the folder's rights "
                      "and free space",
                      file.string(), std::generic_category().message(code))};
}

}  // namespace

Result<JobLock> JobLock::take(const std::filesystem::path& file) {
  const int descriptor = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
  if (descriptor < 0) return cannot(file, errno);
  JobLock lock(descriptor, "");
  while (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
    if (errno == EINTR) continue;
    if (errno != EWOULDBLOCK) return cannot(file, errno);
    std::string holder = holder_in(descriptor);
    if (holder.empty()) holder = "another program";
    ::close(std::exchange(lock.descriptor_, -1));  // not ours: its text stays
    return Error{ErrorCode::kIo,
                 fmt::format("{}: the job is open elsewhere ({}); close it there first",
                             file.parent_path().string(), holder)};
  }
  lock.taken_over_from_ = holder_in(descriptor);
  const std::string text = own_name() + "\n";
  if (::ftruncate(descriptor, 0) != 0 ||
      ::pwrite(descriptor, text.data(), text.size(), 0) != static_cast<ssize_t>(text.size()))
    return cannot(file, errno);
  return lock;
}

JobLock::JobLock(JobLock&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)),
      taken_over_from_(std::move(other.taken_over_from_)) {}

JobLock::~JobLock() {
  if (descriptor_ < 0) return;
  // An empty file is one that was given back. It is not removed: who waits for it by name would
  // lock another file than who comes next.
  (void)!::ftruncate(descriptor_, 0);
  ::close(descriptor_);
}

}  // namespace spool::job
