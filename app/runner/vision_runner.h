// The vision thread: newest frame in, newest state out; commands in between lose nothing.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <thread>

#include "app/runner/command_queue.h"
#include "app/runner/mailbox.h"
#include "app/runner/sensor_thread.h"
#include "vision/live/frame_processor.h"

namespace spool {

// What the main thread asks of vision.
struct VisionCommand {
  enum class Kind {
    kAlign,   // `held` was seen from `T_design_camera`
    kForget,  // no alignment any more
  };
  Kind kind = Kind::kForget;
  VisionStatePtr held;
  Pose T_design_camera = Pose::Identity();
};

// What poses.csv says of one frame.
struct TrackRow {
  std::int64_t frame = 0;
  double seconds = 0;
  TrackQuality quality = TrackQuality::kUnaligned;
  Pose T_design_camera = Pose::Identity();
};
[[nodiscard]] TrackRow track_row(const VisionState& state);

// Where the runner takes from and gives to; all outlive it.
struct VisionPorts {
  Mailbox<FramePtr>& frames;
  Mailbox<VisionStatePtr>& states;
  CommandQueue<SensorNote>& notes;  // errors of single frames
  CommandQueue<TrackRow>& track;  // every frame's row, those too whose state was not taken in time
};

// Does one command; the new state of an alignment, nothing for the others. Also called without a
// thread.
[[nodiscard]] VisionStatePtr obey(FrameProcessor& processor, const VisionCommand& command);

// Runs from construction to destruction.
class VisionRunner {
 public:
  VisionRunner(FrameProcessor processor, const VisionPorts& ports);
  VisionRunner(const VisionRunner&) = delete;
  VisionRunner& operator=(const VisionRunner&) = delete;
  ~VisionRunner();

  void command(VisionCommand command);  // any thread; done before the next frame

 private:
  void run(const std::stop_token& stop);
  void publish(VisionStatePtr state);

  FrameProcessor processor_;
  VisionPorts ports_;
  CommandQueue<VisionCommand> commands_;
  std::jthread thread_;  // last: starts when all else stands
};

}  // namespace spool
