// A GLES 3.0 context without a window: surfaceless EGL first, an EGL device second.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "vision/core/result.h"

namespace spool::render {

// Current on the thread that made it until it is destroyed. GL objects must go before it.
class EglContext {
 public:
  // kNoDevice with one sentence where no driver gives a GLES 3.0 context.
  [[nodiscard]] static Result<EglContext> surfaceless();
  EglContext(EglContext&&) noexcept;
  EglContext& operator=(EglContext&&) noexcept;
  ~EglContext();

 private:
  struct Impl;
  explicit EglContext(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

// GL_RENDERER and GL_VERSION of the current context, for --version and reports.
[[nodiscard]] std::string gl_description();

// True where the current context's driver draws without a graphics card (Mesa's, SwiftShader).
[[nodiscard]] bool draws_in_software();

// Waits until everything asked for is drawn: for measuring only.
void finish_drawing();

}  // namespace spool::render
