// Where depth frames come from: a camera, a recording, a folder or the simulator, all alike.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>

#include "vision/core/camera.h"
#include "vision/core/depth_frame.h"
#include "vision/core/result.h"

namespace spool::sensor {

// What next() gave.
enum class SourceEvent {
  kFrame,      // `frame` is set
  kTimeout,    // nothing in time; ask again
  kEnd,        // a recording is over
  kUnplugged,  // the device went away; keep asking, kReplugged follows when it is back
  kReplugged,
  kWrongMode,  // a picture came that is not of camera()'s mode; `text` says how it is
};

struct SourceOutput {
  SourceEvent event = SourceEvent::kTimeout;
  std::shared_ptr<const DepthFrame> frame;
  std::string text = {};
};

// A stream of frames. One thread at a time; frames may be kept and shared between threads.
class DepthSource {
 public:
  virtual ~DepthSource() = default;

  // Intrinsics of the frames that follow; constant once opened.
  [[nodiscard]] virtual const Camera& camera() const = 0;
  // One line for people and reports: kind, device or file, driver.
  [[nodiscard]] virtual std::string description() const = 0;
  // What the user should know at once, one sentence; empty where there is nothing.
  [[nodiscard]] virtual std::string remark() const { return {}; }
  // True for a recording: frames wait for the reader and the stream ends.
  [[nodiscard]] virtual bool is_recording() const = 0;
  // The next frame or what happened instead. An Error when the source cannot go on (kBadInput for a
  // damaged file, kNoDevice for a camera that fails).
  [[nodiscard]] virtual Result<SourceOutput> next(std::chrono::milliseconds timeout) = 0;
};

struct SourceOptions {
  double speed = 0;              // recordings: 0 as fast as they are read, 1 real time, 2 twice …
  std::int64_t first_frame = 0;  // recordings: frames before it are skipped
};

// Opens "openni[:URI]", "FILE.oni", a depth folder or "simulated[:SCENE.json]" (ARCHITECTURE,
// Command lines). A sentence otherwise: kBadInput for files, kNoDevice for cameras, kUsage for a
// text that is none of these.
[[nodiscard]] Result<std::unique_ptr<DepthSource>> open_source(const std::string& text,
                                                               const SourceOptions& options = {});

// True where open_source() would take `path` as a recording (a folder with camera.json, an .oni
// file).
[[nodiscard]] bool is_recording_path(const std::string& path);

}  // namespace spool::sensor
