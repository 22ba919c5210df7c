// Hands input out so that press and release of a finger never share a frame.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <vector>

#include "app/ui/touch_event.h"

namespace spool::ui {

// Dear ImGui 1.86 looks at the pointer once a frame: a tap that is shorter than a frame would be
// lost.
class InputQueue {
 public:
  void push(const TouchEvent& event) { events_.push_back(event); }
  // What the next frame may see, in order: at most one press or release, and the moves before it.
  [[nodiscard]] std::vector<TouchEvent> take_frame();
  [[nodiscard]] bool empty() const { return events_.empty(); }

 private:
  std::deque<TouchEvent> events_;
};

// The pointer as Dear ImGui wants it, from the first finger only (or the mouse).
struct Pointer {
  bool known = false;  // false: nothing hovers
  double x = 0, y = 0;
  bool pressed = false;
  int finger = kLeftButton;  // the one that is followed while pressed
  bool leave_next = false;   // a lifted finger hovers for the frame of its release only
};

// Follows one frame's events. A second finger takes the press away: two fingers are never a click.
void follow(Pointer& pointer, const std::vector<TouchEvent>& events);

}  // namespace spool::ui
