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
                           CommandQueue<SensorNote>& notes, sensor::FrameRing& ring)
    : source_(std::move(source)),
      frames_(frames),
      notes_(notes),
      ring_(ring),
      thread_([this](const std::stop_token& stop) { run(stop); }) {}

SensorThread::~SensorThread() = default;

void SensorThread::pause(bool paused) { paused_.store(paused, std::memory_order_relaxed); }

void SensorThread::run(const std::stop_token& stop) {
  // A note cannot be refused while this thread lives: the queue is closed by nobody but its owner.
  const auto tell = [this](SensorNote note) { static_cast<void>(notes_.push(std::move(note))); };
  const bool can_wait = source_->is_recording();
  const auto start = std::chrono::steady_clock::now();
  const auto now_s = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  sensor::SensorWatch watch(source_->camera(), now_s());
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
    if (!can_wait && watch.see(*output, now_s())) {
      SensorNote note;
      note.kind = SensorNote::Kind::kTrouble;
      note.trouble = watch.trouble();
      note.words = watch.words();
      tell(std::move(note));
    }
    switch (output->event) {
      case sensor::SourceEvent::kFrame:
        // Vision first: packing takes its time.
        if (can_wait || watch.is_news()) frames_.put(output->frame);
        if (watch.trouble() != sensor::SensorTrouble::kWrongMode) ring_.add(*output->frame);
        break;
      case sensor::SourceEvent::kTimeout:
      case sensor::SourceEvent::kWrongMode:
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
