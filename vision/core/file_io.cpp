// Files read whole and written whole or not at all.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/core/file_io.h"

#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace spool {
namespace {

std::string reason(int code) { return std::generic_category().message(code); }

// A file descriptor that closes itself.
class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  [[nodiscard]] int get() const { return fd_; }
  // Closes now; false where the system only then tells that a write failed.
  bool close() { return ::close(std::exchange(fd_, -1)) == 0; }

 private:
  int fd_;
};

bool write_all(int fd, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t n = ::write(fd, bytes.data(), bytes.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(n));
  }
  return true;
}

}  // namespace

Result<std::string> read_file(const std::filesystem::path& path, std::uint64_t limit_bytes) {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (file.get() < 0) {
    const bool missing = errno == ENOENT || errno == ENOTDIR;
    return Error{missing ? ErrorCode::kBadInput : ErrorCode::kIo,
                 path.string() + ": cannot be opened (" + reason(errno) + "); check the path"};
  }
  struct stat info {};
  if (::fstat(file.get(), &info) != 0)
    return Error{ErrorCode::kIo, path.string() + ": " + reason(errno)};
  if (!S_ISREG(info.st_mode))
    return Error{ErrorCode::kBadInput, path.string() + ": is not a file; name a file"};
  const auto size = static_cast<std::uint64_t>(info.st_size);
  if (size > limit_bytes)
    return Error{ErrorCode::kBadInput, path.string() + ": is " + std::to_string(size) +
                                           " bytes, more than the " + std::to_string(limit_bytes) +
                                           " that are read; use a smaller file"};
  std::string bytes(size, '\0');
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t n = ::read(file.get(), bytes.data() + done, bytes.size() - done);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0)
      return Error{ErrorCode::kIo, path.string() + ": reading failed (" + reason(errno) + ")"};
    if (n == 0) break;  // it shrank while it was read: the reader will call it truncated
    done += static_cast<std::size_t>(n);
  }
  bytes.resize(done);
  return bytes;
}

Status write_file_whole(const std::filesystem::path& path, std::string_view bytes) {
  const std::string temporary = path.string() + ".part-" + std::to_string(::getpid());
  const auto failed = [&](int code) {
    ::unlink(temporary.c_str());
    return Error{ErrorCode::kIo, path.string() + ": cannot be written (" + reason(code) +
                                     "); free space or choose another folder"};
  };
  Descriptor file(::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644));
  if (file.get() < 0) return failed(errno);
  if (!write_all(file.get(), bytes)) return failed(errno);
  if (::fsync(file.get()) != 0) return failed(errno);
  if (!file.close()) return failed(errno);
  if (::rename(temporary.c_str(), path.c_str()) != 0) return failed(errno);
  // The rename itself lasts only once the folder is synced.
  const std::filesystem::path parent = path.has_parent_path() ? path.parent_path() : ".";
  const Descriptor folder(::open(parent.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (folder.get() >= 0) ::fsync(folder.get());
  return {};
}

Status make_folder(const std::filesystem::path& path) {
  std::error_code code;
  std::filesystem::create_directories(path, code);
  if (code || !std::filesystem::is_directory(path, code))
    return Error{ErrorCode::kIo, path.string() + ": the folder cannot be made (" +
                                     (code ? code.message() : "a file is in its place") +
                                     "); choose another folder"};
  return {};
}

}  // namespace spool
