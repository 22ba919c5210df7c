// Saves the last seconds of the sensor.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/application/last_seconds.h"

#include <system_error>

#include <fmt/format.h>

#include "app/sensor/depth_folder.h"

namespace spool {

namespace {

namespace fs = std::filesystem;

Status write_folder(const fs::path& folder, const LastSeconds& last) {
  auto writer = sensor::DepthFolderWriter::create(folder, last.camera);
  if (!writer) return writer.error();
  for (const sensor::PackedDepthPtr& frame : last.frames)
    if (Status written = writer->write(sensor::unpack(*frame)); !written) return written;
  return last.poses.write(folder / "poses.csv");
}

fs::path free_name(const fs::path& out) {
  std::error_code ignored;
  for (int number = 1;; ++number) {
    fs::path folder = out / fmt::format("last_{:03}", number);
    if (!fs::exists(folder, ignored)) return folder;
  }
}

}  // namespace

Result<fs::path> save_last_seconds(const fs::path& out, const LastSeconds& last) {
  if (last.frames.empty())
    return Error{ErrorCode::kUsage, "The sensor has given no picture yet that could be saved."};
  const fs::path folder = free_name(out);
  const fs::path part = folder.string() + ".part";
  std::error_code code, ignored;
  fs::remove_all(part, ignored);  // of a run that was ended in the middle
  Status written = write_folder(part, last);
  if (written) {
    fs::rename(part, folder, code);
    if (!code) return folder;
    written = Error{ErrorCode::kIo, folder.string() + ": cannot be written (" + code.message() +
                                        "); choose another folder"};
  }
  fs::remove_all(part, ignored);
  return written.error();
}

}  // namespace spool
