// The window: GLFW and its EGL context, nothing else.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/ui/key_press.h"
#include "app/ui/touch_event.h"
#include "vision/core/result.h"

namespace spool {

// A window with a GLES 3.0 context that is current on the thread that made it. Main thread only.
class Window {
 public:
  // kNoDevice with one sentence where there is no display or no driver for it.
  [[nodiscard]] static Result<Window> open(const std::string& title, int width, int height);
  Window(Window&&) noexcept;
  Window& operator=(Window&&) noexcept;
  ~Window();

  // Size of the picture in px (not in the desktop's own units).
  [[nodiscard]] int width() const;
  [[nodiscard]] int height() const;
  // Dots an inch of the monitor it is on, from its physical size; 0 where it does not say.
  [[nodiscard]] double dots_per_inch() const;
  [[nodiscard]] bool should_close() const;
  // Fingers and mouse since the last call, in px; waits up to `timeout_s` for something to happen.
  [[nodiscard]] std::vector<ui::TouchEvent> events(double timeout_s);
  // Keys of a real keyboard that were pressed, or held, until the last call of events().
  [[nodiscard]] std::vector<ui::KeyPress> keys();
  void swap();  // shows what was drawn

 private:
  struct Impl;
  explicit Window(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace spool
