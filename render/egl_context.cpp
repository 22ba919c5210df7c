// A GLES 3.0 context without a window: surfaceless EGL first, an EGL device second.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "render/egl_context.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdio>
#include <string_view>
#include <utility>

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GLES3/gl3.h>

namespace spool::render {

// The display stays initialised: EGL shares it in the whole process, so ending it here would end
// the contexts of others on it.
struct EglContext::Impl {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;

  Impl(EGLDisplay display_in, EGLContext context_in) : display(display_in), context(context_in) {}
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
  ~Impl() {
    assert((eglGetCurrentContext() == context || eglGetCurrentContext() == EGL_NO_CONTEXT) &&
           "a context is destroyed on the thread that made it");
    if (eglGetCurrentContext() == context) {
      eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    }
    eglDestroyContext(display, context);
  }
};

namespace {

// "eglInitialize (0x3001)": which call refused and EGL's code for why.
std::string failed_at(const char* call) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%s (EGL error 0x%04x)", call,
                static_cast<unsigned>(eglGetError()));
  return text.data();
}

bool has_extension(const char* all, std::string_view wanted) {
  if (all == nullptr) return false;
  // Names stand between blanks; one may be the beginning of another.
  std::string_view names(all);
  for (std::size_t at = names.find(wanted); at != std::string_view::npos;
       at = names.find(wanted, at + 1)) {
    const std::size_t end = at + wanted.size();
    if ((at == 0 || names[at - 1] == ' ') && (end == names.size() || names[end] == ' '))
      return true;
  }
  return false;
}

// A current context on `display`, or what failed.
Result<std::pair<EGLDisplay, EGLContext>> context_on(EGLDisplay display) {
  const auto refused = [](const char* call) {
    return Error{ErrorCode::kNoDevice, failed_at(call)};
  };
  if (display == EGL_NO_DISPLAY) return refused("eglGetPlatformDisplay");
  if (eglInitialize(display, nullptr, nullptr) != EGL_TRUE) return refused("eglInitialize");
  if (eglBindAPI(EGL_OPENGL_ES_API) != EGL_TRUE) return refused("eglBindAPI");
  constexpr std::array<EGLint, 13> kConfig{
      EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_ES3_BIT,
      EGL_RED_SIZE,     8, EGL_GREEN_SIZE,      8,
      EGL_BLUE_SIZE,    8, EGL_ALPHA_SIZE,      8,
      EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (eglChooseConfig(display, kConfig.data(), &config, 1, &count) != EGL_TRUE || count == 0) {
    return refused("eglChooseConfig");
  }
  constexpr std::array<EGLint, 5> kContext{EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION,
                                           0, EGL_NONE};
  EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, kContext.data());
  if (context == EGL_NO_CONTEXT) return refused("eglCreateContext");
  if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) != EGL_TRUE) {
    Error error = refused("eglMakeCurrent");
    eglDestroyContext(display, context);
    return error;
  }
  return std::pair{display, context};
}

// The displays of EGL's devices: what a GPU vendor's driver offers where Mesa's surfaceless is
// absent.
std::pair<EGLint, std::array<EGLDisplay, 8>> device_displays() {
  std::array<EGLDisplay, 8> displays{};
  const auto query_devices =
      reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
  std::array<EGLDeviceEXT, 8> devices{};
  EGLint count = 0;
  if (query_devices == nullptr ||
      query_devices(static_cast<EGLint>(devices.size()), devices.data(), &count) != EGL_TRUE) {
    return {0, displays};
  }
  for (EGLint i = 0; i < count; ++i) {
    const auto at = static_cast<std::size_t>(i);
    displays[at] = eglGetPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, devices[at], nullptr);
  }
  return {count, displays};
}

}  // namespace

Result<EglContext> EglContext::surfaceless() {
  const char* client = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  std::string tried;
  if (has_extension(client, "EGL_MESA_platform_surfaceless")) {
    auto made = context_on(
        eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
    if (made) return EglContext(std::make_unique<Impl>(made->first, made->second));
    tried = "surfaceless EGL failed at " + made.error().message;
  } else {
    tried = "EGL offers no surfaceless platform";
  }
  const auto [count, displays] = device_displays();
  std::string last = "EGL lists no device";
  for (EGLint i = 0; i < count; ++i) {
    auto made = context_on(displays[static_cast<std::size_t>(i)]);
    if (made) return EglContext(std::make_unique<Impl>(made->first, made->second));
    last = "EGL device " + std::to_string(i) + " failed at " + made.error().message;
  }
  return Error{ErrorCode::kNoDevice,
               "no OpenGL ES 3.0 driver for drawing: " + tried + ", " + last +
                   "; install a graphics driver, or Mesa's software one (libgl1-mesa-dri)"};
}

EglContext::EglContext(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
EglContext::EglContext(EglContext&&) noexcept = default;
EglContext& EglContext::operator=(EglContext&&) noexcept = default;
EglContext::~EglContext() = default;

std::string gl_description() {
  const auto text = [](GLenum name) {
    const auto* found = reinterpret_cast<const char*>(glGetString(name));
    return std::string(found != nullptr ? found : "unknown");
  };
  return text(GL_RENDERER) + ", " + text(GL_VERSION);
}

bool draws_in_software() {
  const std::string renderer = gl_description();
  constexpr std::array<std::string_view, 4> kNames{"llvmpipe", "softpipe", "SWR", "SwiftShader"};
  return std::any_of(kNames.begin(), kNames.end(), [&](std::string_view name) {
    return renderer.find(name) != std::string::npos;
  });
}

void finish_drawing() { glFinish(); }

}  // namespace spool::render
