// Every finger on an X11 window, by a second connection that listens to XInput 2.2 touch events.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "app/ui/touch_event.h"

namespace spool {

// GLFW 3.3 knows one finger, as a mouse. While this listens GLFW gets no buttons from fingers (the
// mouse's own still arrive), so nothing comes twice. Main thread only.
class XinputTouch {
 public:
  // Nothing where the display is not X11 or knows no touch: the mouse still works.
  [[nodiscard]] static std::unique_ptr<XinputTouch> listen(unsigned long window);
  ~XinputTouch();

  // Fingers since the last call, at window coordinates; ids count from 0 while down.
  [[nodiscard]] std::vector<ui::TouchEvent> take();
  [[nodiscard]] bool is_touched() const;  // a finger is down

 private:
  struct Impl;
  explicit XinputTouch(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace spool
