// Writing a depth folder one frame after another.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

#include "app/common/json_file.h"
#include "app/sensor/depth_folder.h"
#include "app/sensor/depth_png.h"
#include "vision/core/file_io.h"

namespace spool::sensor {
namespace {

namespace fs = std::filesystem;

// Appends one line and hands it to the system at once.
Status append_line(const fs::path& path, const std::string& line) {
  const auto close = [](std::FILE* file) { return std::fclose(file); };
  std::unique_ptr<std::FILE, decltype(close)> file(std::fopen(path.c_str(), "ae"), close);
  const bool written =
      file != nullptr && std::fwrite(line.data(), 1, line.size(), file.get()) == line.size();
  const bool kept = file != nullptr && std::fclose(file.release()) == 0;
  if (written && kept) return {};
  return Error{ErrorCode::kIo, path.string() + ": cannot be written (" +
                                   std::generic_category().message(errno) +
                                   "); free space or choose another folder"};
}

}  // namespace

Result<DepthFolderWriter> DepthFolderWriter::create(const fs::path& folder, const Camera& camera) {
  std::error_code code;
  if (fs::exists(folder, code) && (!fs::is_directory(folder, code) || !fs::is_empty(folder, code)))
    return Error{
        ErrorCode::kUsage,
        folder.string() + ": already holds something; name a new folder for the recording"};
  if (const Status made = make_folder(folder / "depth"); !made) return made.error();
  const Status camera_written =
      write_file_whole(folder / "camera.json", camera_to_json(camera).dump(1) + "\n");
  if (!camera_written) return camera_written.error();
  if (const Status s = append_line(folder / "times.csv", "frame,seconds\n"); !s) return s.error();
  return DepthFolderWriter(folder, camera.width, camera.height);
}

Status DepthFolderWriter::write(const DepthFrame& frame) {
  if (!frame.is_consistent() || frame.width != width_ || frame.height != height_)
    return Error{ErrorCode::kBadInput,
                 folder_.string() + ": frame " + std::to_string(frame.index) +
                     " has not the size of the camera that is recorded; start a new recording"};
  const auto png = encode_depth_png(frame.depth, width_, height_);
  if (!png) return png.error();
  char name[32];
  char time[64];
  std::snprintf(name, sizeof name, "%06lld.png", static_cast<long long>(count_));
  std::snprintf(time, sizeof time, "%lld,%.6f\n", static_cast<long long>(count_), frame.seconds);
  // The time first: a line without its frame is harmless, a frame without its time is not.
  if (Status status = append_line(folder_ / "times.csv", time); !status) return status;
  if (Status status = write_file_whole(folder_ / "depth" / name, *png); !status) return status;
  ++count_;
  return {};
}

}  // namespace spool::sensor
