// Hands input out frame by frame.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/ui/input_queue.h"

namespace spool::ui {

std::vector<TouchEvent> InputQueue::take_frame() {
  std::vector<TouchEvent> batch;
  while (!events_.empty()) {
    const TouchEvent event = events_.front();
    events_.pop_front();
    batch.push_back(event);
    if (event.phase != TouchPhase::kMove && event.phase != TouchPhase::kHover) break;
  }
  return batch;
}

void follow(Pointer& pointer, const std::vector<TouchEvent>& events) {
  if (pointer.leave_next) {
    pointer.known = false;
    pointer.leave_next = false;
  }
  for (const TouchEvent& event : events) {
    const bool followed = pointer.pressed && event.id == pointer.finger;
    switch (event.phase) {
      case TouchPhase::kHover:
      case TouchPhase::kWheel:
        if (pointer.pressed) break;
        pointer.known = true;
        pointer.x = event.x;
        pointer.y = event.y;
        break;
      case TouchPhase::kDown:
        if (event.id == kRightButton) break;
        if (pointer.pressed) {  // a second finger: a gesture begins, no widget is meant
          pointer.pressed = false;
          pointer.known = false;
          break;
        }
        pointer = {true, event.x, event.y, true, event.id, false};
        break;
      case TouchPhase::kMove:
        if (!followed) break;
        pointer.x = event.x;
        pointer.y = event.y;
        break;
      case TouchPhase::kUp:
        if (!followed) break;
        pointer.x = event.x;
        pointer.y = event.y;
        pointer.pressed = false;
        pointer.leave_next = event.id >= 0;  // a mouse stays where it is
        break;
      case TouchPhase::kCancel:
        if (!followed) break;
        pointer.pressed = false;
        pointer.known = false;
        break;
    }
  }
}

}  // namespace spool::ui
