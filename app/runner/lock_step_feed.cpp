// The feed without threads: one frame a call, every frame in order.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <chrono>
#include <deque>
#include <utility>

#include "app/runner/feed.h"

namespace spool {

namespace {

class LockStepFeed final : public Feed {
 public:
  LockStepFeed(std::unique_ptr<sensor::DepthSource> source, FrameProcessor processor)
      : source_(std::move(source)), processor_(std::move(processor)) {}

  VisionStatePtr poll() override {
    if (answer_) return std::exchange(answer_, nullptr);
    if (paused_ || over_) return nullptr;
    Result<sensor::SourceOutput> output = source_->next(std::chrono::milliseconds(1000));
    if (!output) return fail(output.error());
    switch (output->event) {
      case sensor::SourceEvent::kFrame:
        break;
      case sensor::SourceEvent::kTimeout:
      case sensor::SourceEvent::kWrongMode:
        return nullptr;
      case sensor::SourceEvent::kEnd:
        over_ = true;
        notes_.push_back({SensorNote::Kind::kEnded, {}});
        return nullptr;
      case sensor::SourceEvent::kUnplugged:
        notes_.push_back({SensorNote::Kind::kUnplugged, {}});
        return nullptr;
      case sensor::SourceEvent::kReplugged:
        notes_.push_back({SensorNote::Kind::kReplugged, {}});
        return nullptr;
    }
    ring_.add(*output->frame);
    Result<VisionStatePtr> state = processor_.process(std::move(output->frame));
    if (!state) return fail(state.error());
    track_.push_back(track_row(**state));
    return std::move(*state);
  }

  std::optional<SensorNote> note() override {
    if (notes_.empty()) return std::nullopt;
    SensorNote first = std::move(notes_.front());
    notes_.pop_front();
    return first;
  }

  std::vector<TrackRow> take_track() override { return std::exchange(track_, {}); }

  void command(VisionCommand command) override {
    if (VisionStatePtr state = obey(processor_, command)) {
      track_.push_back(track_row(*state));
      answer_ = std::move(state);
    }
  }

  std::vector<sensor::PackedDepthPtr> last_frames() const override { return ring_.frames(); }

  void pause(bool paused) override { paused_ = paused; }

 private:
  VisionStatePtr fail(Error error) {
    over_ = true;
    notes_.push_back({SensorNote::Kind::kFailed, std::move(error)});
    return nullptr;
  }

  std::unique_ptr<sensor::DepthSource> source_;
  FrameProcessor processor_;
  sensor::FrameRing ring_;
  std::deque<SensorNote> notes_;
  std::vector<TrackRow> track_;
  VisionStatePtr answer_;  // of a command, shown before the next frame
  bool paused_ = false;
  bool over_ = false;
};

}  // namespace

std::unique_ptr<Feed> make_lock_step_feed(std::unique_ptr<sensor::DepthSource> source,
                                          FrameProcessor processor) {
  return std::make_unique<LockStepFeed>(std::move(source), std::move(processor));
}

}  // namespace spool
