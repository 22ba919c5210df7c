// One picture's eye: turned, moved and brought closer by gestures.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/ui/gestures.h"
#include "app/ui/layout.h"
#include "render/view.h"

namespace spool {

// Pixels are the picture's own; the world is whatever frame is looked at (m).
class ViewControl {
 public:
  // Starts at `view`; `pivot_m` ahead along the optical axis lies what is turned about.
  void start(const render::View& view, double pivot_m);
  // Turns about the pivot, pans at its distance, zooms and rolls about the gesture's middle. The
  // gesture is in window pixels, `rect` where the picture stands in it.
  void apply(const ui::Gesture& gesture, const ui::Rect& rect);
  [[nodiscard]] const render::View& view() const { return view_; }
  [[nodiscard]] bool is_started() const { return started_; }

 private:
  render::View view_;
  double pivot_m_ = 1;
  bool started_ = false;
};

}  // namespace spool
