// A recording of any length by links.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/soak/long_recording.h"

#include <cmath>
#include <cstdio>
#include <string>
#include <system_error>
#include <utility>

#include <unistd.h>

#include "app/sensor/depth_folder.h"
#include "vision/core/file_io.h"

namespace spool::soak {

namespace fs = std::filesystem;

LongRecording::LongRecording(LongRecording&& other) noexcept
    : folder_(std::exchange(other.folder_, {})), frames_(other.frames_) {}

LongRecording::~LongRecording() {
  std::error_code ignored;
  if (!folder_.empty()) fs::remove_all(folder_, ignored);
}

Result<LongRecording> LongRecording::make(const fs::path& of, double seconds) {
  const auto recording = sensor::read_depth_folder(of);
  if (!recording) return recording.error();
  const auto& files = recording->files;
  if (files.size() < 2 || files.back().seconds <= files.front().seconds)
    return Error{ErrorCode::kBadInput,
                 of.string() + ": has fewer than two frames in time; record a sequence"};

  LongRecording made;
  std::error_code failed;
  std::string name = (fs::temp_directory_path(failed) / "spoolsight-soak-XXXXXX").string();
  if (failed || ::mkdtemp(name.data()) == nullptr)
    return Error{ErrorCode::kIo, name + ": cannot be made; set TMPDIR to a folder with room"};
  made.folder_ = name;
  if (const Status status = make_folder(made.folder_ / "depth"); !status) return status.error();
  fs::copy_file(of / "camera.json", made.folder_ / "camera.json", failed);
  std::string times = "frame,seconds\n";
  std::size_t at = 0;
  bool back = false;
  for (double now = 0; now <= seconds && !failed; ++made.frames_) {
    char number[16];
    std::snprintf(number, sizeof number, "%07zu", made.frames_);
    fs::create_symlink(fs::absolute(files[at].path),
                       made.folder_ / "depth" / (std::string(number) + ".png"), failed);
    times += std::to_string(made.frames_) + "," + std::to_string(now) + "\n";
    if (at == 0) back = false;
    if (at + 1 == files.size()) back = true;
    const std::size_t next = back ? at - 1 : at + 1;
    now += std::abs(files[next].seconds - files[at].seconds);
    at = next;
  }
  if (failed)
    return Error{ErrorCode::kIo, name + ": cannot be filled (" + failed.message() +
                                     "); set TMPDIR to a folder with room"};
  if (const Status written = write_file_whole(made.folder_ / "times.csv", times); !written)
    return written.error();
  return made;
}

}  // namespace spool::soak
