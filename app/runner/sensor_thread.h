// The sensor's own thread: hands on the newest frame, reports what else happens.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <thread>

#include "app/runner/command_queue.h"
#include "app/runner/mailbox.h"
#include "app/sensor/depth_source.h"
#include "app/sensor/frame_ring.h"
#include "app/sensor/sensor_watch.h"
#include "vision/core/depth_frame.h"
#include "vision/core/result.h"

namespace spool {

using FramePtr = std::shared_ptr<const DepthFrame>;

// What the screen has to know of the sensor's life; nothing of it is lost.
struct SensorNote {
  enum class Kind { kUnplugged, kReplugged, kTrouble, kEnded, kFailed };
  Kind kind = Kind::kEnded;
  Error error = {};  // of kFailed
  // Of kTrouble: what is wrong from now on (kNone: nothing any more), and what to do about it.
  sensor::SensorTrouble trouble = sensor::SensorTrouble::kNone;
  std::string words = {};
};

// Owns the source from construction to destruction and is the only one to call it. A camera is
// watched: frames that tell nothing are not handed on (SensorWatch). The ring keeps the last
// seconds. Ends by itself after kEnded and kFailed; the destructor ends it in any state within the
// source's timeout of 100 ms.
class SensorThread {
 public:
  SensorThread(std::unique_ptr<sensor::DepthSource> source, Mailbox<FramePtr>& frames,
               CommandQueue<SensorNote>& notes, sensor::FrameRing& ring);
  SensorThread(const SensorThread&) = delete;
  SensorThread& operator=(const SensorThread&) = delete;
  ~SensorThread();

  // A recording waits while paused; a camera goes on (its frames keep the pose known).
  void pause(bool paused);

 private:
  void run(const std::stop_token& stop);

  std::unique_ptr<sensor::DepthSource> source_;
  Mailbox<FramePtr>& frames_;
  CommandQueue<SensorNote>& notes_;
  sensor::FrameRing& ring_;
  std::atomic<bool> paused_{false};  // set by the main thread, read by the sensor's
  std::jthread thread_;              // last: starts when all else stands
};

}  // namespace spool
