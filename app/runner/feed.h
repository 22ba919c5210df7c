// Sensor and vision together as the main thread sees them: states and notes out, commands in.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "app/runner/sensor_thread.h"
#include "app/runner/vision_runner.h"
#include "vision/live/vision_state.h"

namespace spool {

// All functions on the main thread.
class Feed {
 public:
  virtual ~Feed() = default;
  // The newest state since the last call, or nothing.
  [[nodiscard]] virtual VisionStatePtr poll() = 0;
  [[nodiscard]] virtual std::optional<SensorNote> note() = 0;
  // Rows of all frames since the last call, none left out, in order.
  [[nodiscard]] virtual std::vector<TrackRow> take_track() = 0;
  virtual void command(VisionCommand command) = 0;
  // What the sensor gave in the last seconds, oldest first.
  [[nodiscard]] virtual std::vector<sensor::PackedDepthPtr> last_frames() const = 0;
  virtual void pause(bool paused) = 0;  // a recording waits; a camera goes on
};

// Threads of their own for sensor and vision; what is slow drops frames.
[[nodiscard]] std::unique_ptr<Feed> make_live_feed(std::unique_ptr<sensor::DepthSource> source,
                                                   FrameProcessor processor);
// No threads: each poll() takes exactly the next frame, so that a recording gives the same pictures
// on any machine.
[[nodiscard]] std::unique_ptr<Feed> make_lock_step_feed(std::unique_ptr<sensor::DepthSource> source,
                                                        FrameProcessor processor);

}  // namespace spool
