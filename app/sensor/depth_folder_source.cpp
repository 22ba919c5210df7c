// A depth folder as a source of frames.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <utility>

#include "app/sensor/depth_folder.h"
#include "app/sensor/depth_png.h"
#include "app/sensor/playback_pace.h"
#include "app/sensor/source_kinds.h"
#include "vision/core/file_io.h"

namespace spool::sensor {
namespace {

constexpr std::uint64_t kImageLimit = std::uint64_t{1} << 30;  // bytes of one packed image

class DepthFolderSource final : public DepthSource {
 public:
  DepthFolderSource(std::string path, DepthFolder folder, const SourceOptions& options)
      : path_(std::move(path)),
        folder_(std::move(folder)),
        next_(static_cast<std::size_t>(
            std::min(options.first_frame, static_cast<std::int64_t>(folder_.files.size())))),
        pace_(options.speed) {}

  const Camera& camera() const override { return folder_.camera; }
  std::string description() const override {
    return "depth folder " + path_ + ", " + std::to_string(folder_.files.size()) + " frames";
  }
  bool is_recording() const override { return true; }

  Result<SourceOutput> next(std::chrono::milliseconds timeout) override {
    const auto deadline = std::chrono::steady_clock::now() + timeout;
    if (next_ == folder_.files.size()) return SourceOutput{SourceEvent::kEnd, nullptr};
    const DepthFile& file = folder_.files[next_];
    if (!pace_.wait_for(file.seconds, deadline))
      return SourceOutput{SourceEvent::kTimeout, nullptr};
    const auto bytes = read_file(file.path, kImageLimit);
    if (!bytes) return bytes.error();
    auto depth =
        decode_depth_png(*bytes, folder_.camera.width, folder_.camera.height, file.path.string());
    if (!depth) return depth.error();
    auto frame = std::make_shared<DepthFrame>();
    frame->index = static_cast<std::int64_t>(next_++);
    frame->seconds = file.seconds;
    frame->width = folder_.camera.width;
    frame->height = folder_.camera.height;
    frame->depth = *std::move(depth);
    return SourceOutput{SourceEvent::kFrame, std::move(frame)};
  }

 private:
  std::string path_;
  DepthFolder folder_;
  std::size_t next_;
  PlaybackPace pace_;
};

}  // namespace

OpenedSource open_depth_folder(const std::string& path, const SourceOptions& options) {
  auto folder = read_depth_folder(path);
  if (!folder) return folder.error();
  return std::unique_ptr<DepthSource>(
      std::make_unique<DepthFolderSource>(path, *std::move(folder), options));
}

}  // namespace spool::sensor
