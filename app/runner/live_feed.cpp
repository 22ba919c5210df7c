// The feed with threads.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include "app/runner/feed.h"

namespace spool {

namespace {

class LiveFeed final : public Feed {
 public:
  LiveFeed(std::unique_ptr<sensor::DepthSource> source, FrameProcessor processor)
      : vision_(std::move(processor), VisionPorts{frames_, states_, notes_, track_}),
        sensor_(std::move(source), frames_, notes_, ring_) {}

  VisionStatePtr poll() override { return states_.try_take().value_or(nullptr); }
  std::optional<SensorNote> note() override { return notes_.try_pop(); }
  std::vector<TrackRow> take_track() override {
    std::vector<TrackRow> rows;
    while (std::optional<TrackRow> row = track_.try_pop()) rows.push_back(*row);
    return rows;
  }
  void command(VisionCommand command) override { vision_.command(std::move(command)); }
  std::vector<sensor::PackedDepthPtr> last_frames() const override { return ring_.frames(); }
  void pause(bool paused) override { sensor_.pause(paused); }

 private:
  Mailbox<FramePtr> frames_;
  Mailbox<VisionStatePtr> states_;
  CommandQueue<SensorNote> notes_;
  CommandQueue<TrackRow> track_;
  sensor::FrameRing ring_;
  VisionRunner vision_;
  SensorThread sensor_;  // last: its thread ends first
};

}  // namespace

std::unique_ptr<Feed> make_live_feed(std::unique_ptr<sensor::DepthSource> source,
                                     FrameProcessor processor) {
  return std::make_unique<LiveFeed>(std::move(source), std::move(processor));
}

}  // namespace spool
