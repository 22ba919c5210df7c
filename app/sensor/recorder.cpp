// Records what any source gives, to a depth folder or an .oni file.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/sensor/recorder.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <functional>
#include <system_error>

#include "app/sensor/depth_folder.h"
#include "app/sensor/oni_check.h"
#include "app/sensor/openni.h"

namespace spool::sensor {
namespace {

namespace fs = std::filesystem;
using std::chrono::milliseconds;

// Gives each frame of `source` to `write` until a limit is reached.
Result<Recorded> pump(DepthSource& source, const RecordOptions& options, const Watch& watch,
                      const std::function<Status(const DepthFrame&)>& write) {
  constexpr milliseconds kWait{100};
  Recorded recorded;
  double first_seconds = 0, silent = 0;
  while (recorded.frames < options.frames && !watch.cancelled()) {
    watch.report("record", std::max(recorded.seconds / options.seconds,
                                    static_cast<double>(recorded.frames) /
                                        static_cast<double>(options.frames)));
    const auto output = source.next(kWait);
    if (!output) return output.error();
    if (output->event == SourceEvent::kEnd) break;
    if (output->event != SourceEvent::kFrame) {
      silent += std::chrono::duration<double>(kWait).count();
      if (silent < options.patience) continue;
      return Error{ErrorCode::kNoDevice,
                   source.description() + ": gives no frame any more; plug the camera in again"};
    }
    silent = 0;
    const DepthFrame& frame = *output->frame;
    if (recorded.frames == 0) first_seconds = frame.seconds;
    if (frame.seconds - first_seconds >= options.seconds) break;
    if (const Status status = write(frame); !status) return status.error();
    ++recorded.frames;
    recorded.seconds = frame.seconds - first_seconds;
  }
  return recorded;
}

Result<Recorded> record_folder(DepthSource& source, const fs::path& path,
                               const RecordOptions& options, const Watch& watch) {
  auto writer = DepthFolderWriter::create(path, source.camera());
  if (!writer) return writer.error();
  return pump(source, options, watch,
              [&](const DepthFrame& frame) { return writer->write(frame); });
}

// Counts the frames of a finished .oni file.
Result<std::int64_t> count_frames(const std::string& path) {
  if (const Status checked = check_oni(path); !checked) return checked.error();
  auto source = open_oni_unchecked(path, {});
  if (!source) return source.error();
  RecordOptions all;
  const auto counted = pump(**source, all, {}, [](const DepthFrame&) -> Status { return {}; });
  if (!counted) return counted.error();
  return counted->frames;
}

Result<Recorded> record_oni(DepthSource& source, const fs::path& path, const RecordOptions& options,
                            const Watch& watch) {
  std::error_code ignored;
  if (fs::exists(path, ignored))
    return Error{ErrorCode::kUsage, path.string() + ": exists already; name a new file"};
  const fs::path part = fs::path(path).replace_extension(".part.oni");
  fs::remove(part, ignored);
  const auto recorded = [&]() -> Result<Recorded> {
    auto writer = create_oni(part.string(), source.camera());
    if (!writer) return writer.error();
    auto pumped = pump(source, options, watch,
                       [&](const DepthFrame& frame) { return (*writer)->write(frame); });
    (*writer)->finish();
    return pumped;
  }();
  const auto give_up = [&](Error error) {
    fs::remove(part, ignored);
    return error;
  };
  if (!recorded) return give_up(recorded.error());
  // OpenNI2's recorder does not tell when the disk is full: what it wrote is played and counted.
  const auto frames = recorded->frames > 0 ? count_frames(part.string()) : Result<std::int64_t>(0);
  if (recorded->frames == 0 || !frames || *frames != recorded->frames)
    return give_up(
        Error{ErrorCode::kIo, path.string() + ": " + (frames ? std::to_string(*frames) : "none") +
                                  " of " + std::to_string(recorded->frames) +
                                  " frames could be written; free space or choose another "
                                  "folder"});
  std::error_code code;
  fs::rename(part, path, code);
  if (code)
    return give_up(Error{ErrorCode::kIo, path.string() + ": cannot be written (" + code.message() +
                                             "); choose another folder"});
  return recorded;
}

}  // namespace

Result<Recorded> record(DepthSource& source, const std::string& path, const RecordOptions& options,
                        const Watch& watch) {
  return fs::path(path).extension() == ".oni" ? record_oni(source, path, options, watch)
                                              : record_folder(source, path, options, watch);
}

}  // namespace spool::sensor
