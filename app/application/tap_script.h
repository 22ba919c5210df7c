// TAPS.json: fingers on the glass, by time, as fractions of the window (ARCHITECTURE, Command
// lines).
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "app/ui/touch_event.h"
#include "vision/core/result.h"

namespace spool {

// Events in order of time; x and y still fractions of the window.
class TapScript {
 public:
  TapScript() = default;
  // kBadInput with one sentence for a missing file, another shape, a phase that is none or a number
  // out of range.
  [[nodiscard]] static Result<TapScript> read(const std::filesystem::path& path);

  // The events up to `now_s` that were not handed out yet, in pixels of a window of this size.
  [[nodiscard]] std::vector<ui::TouchEvent> until(double now_s, double width_px, double height_px);
  [[nodiscard]] bool is_finished() const { return next_ == events_.size(); }

 private:
  std::vector<ui::TouchEvent> events_;
  std::size_t next_ = 0;
};

}  // namespace spool
