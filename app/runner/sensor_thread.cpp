// The sensor's own thread.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/runner/sensor_thread.h"

#include <chrono>
#include <utility>

namespace spool {

namespace {
constexpr std::chrono::milliseconds kSourceTimeout{100};
constexpr std::chrono::milliseconds kPauseStep{10};
}  // namespace

SensorThread::SensorThread(std::unique_ptr<sensor::DepthSource> source, Mailbox<FramePtr>& frames,
                           CommandQueue<SensorNote>& notes)
    : source_(std::move(source)),
      frames_(frames),
      notes_(notes),
      thread_([this](const std::stop_token& stop) { run(stop); }) {}

SensorThread::~SensorThread() = default;

void SensorThread::pause(bool paused) { paused_.store(paused, std::memory_order_relaxed); }

void SensorThread::run(const std::stop_token& stop) {
  // A note cannot be refused while this thread lives: the queue is closed by nobody but its owner.
  const auto tell = [this](SensorNote note) { static_cast<void>(notes_.push(std::move(note))); };
  const bool can_wait = source_->is_recording();
  while (!stop.stop_requested()) {
    if (can_wait && paused_.load(std::memory_order_relaxed)) {
      std::this_thread::sleep_for(kPauseStep);
      continue;
    }
    Result<sensor::SourceOutput> output = source_->next(kSourceTimeout);
    if (!output) {
      tell({SensorNote::Kind::kFailed, output.error()});
      return;
    }
    switch (output->event) {
      case sensor::SourceEvent::kFrame:
        frames_.put(std::move(output->frame));
        break;
      case sensor::SourceEvent::kTimeout:
        break;
      case sensor::SourceEvent::kEnd:
        tell({SensorNote::Kind::kEnded, {}});
        return;
      case sensor::SourceEvent::kUnplugged:
        tell({SensorNote::Kind::kUnplugged, {}});
        break;
      case sensor::SourceEvent::kReplugged:
        tell({SensorNote::Kind::kReplugged, {}});
        break;
    }
  }
}

}  // namespace spool
