// The window: GLFW and its EGL context.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/window.h"

#define GLFW_INCLUDE_NONE
#include <utility>

#include <GLFW/glfw3.h>

#include "app/xinput_touch.h"

// GLFW's header for native handles needs a package that nothing else here does.
extern "C" unsigned long glfwGetX11Window(GLFWwindow* window);

namespace spool {

namespace {
constexpr double kMmPerInch = 25.4;

struct Glfw {
  bool initialised = false;
  ~Glfw() {
    if (initialised) glfwTerminate();
  }
};
}  // namespace

struct Window::Impl {
  Glfw glfw;  // first: ends last
  GLFWwindow* window = nullptr;
  std::unique_ptr<XinputTouch> touch;
  std::vector<ui::TouchEvent> events;
  std::vector<ui::KeyPress> keys;

  ~Impl() {
    touch.reset();
    if (window != nullptr) glfwDestroyWindow(window);
  }

  // Pixels of the picture for one of the desktop's units.
  [[nodiscard]] std::pair<double, double> pixels_per_unit() const {
    int units_x = 1, units_y = 1, px = 1, py = 1;
    glfwGetWindowSize(window, &units_x, &units_y);
    glfwGetFramebufferSize(window, &px, &py);
    return {units_x > 0 ? static_cast<double>(px) / units_x : 1.0,
            units_y > 0 ? static_cast<double>(py) / units_y : 1.0};
  }

  void add(int id, ui::TouchPhase phase, double steps = 0) {
    double x = 0, y = 0;
    glfwGetCursorPos(window, &x, &y);
    const auto [sx, sy] = pixels_per_unit();
    events.push_back({id, phase, x * sx, y * sy, glfwGetTime(), steps});
  }

  static Impl& of(GLFWwindow* window) {
    return *static_cast<Impl*>(glfwGetWindowUserPointer(window));
  }

  static void on_button(GLFWwindow* window, int button, int action, int /*modifiers*/) {
    if (button != GLFW_MOUSE_BUTTON_LEFT && button != GLFW_MOUSE_BUTTON_RIGHT) return;
    of(window).add(button == GLFW_MOUSE_BUTTON_LEFT ? ui::kLeftButton : ui::kRightButton,
                   action == GLFW_PRESS ? ui::TouchPhase::kDown : ui::TouchPhase::kUp);
  }
  static void on_cursor(GLFWwindow* window, double /*x*/, double /*y*/) {
    Impl& self = of(window);
    // While a finger is down the cursor only follows it: the touch events say it better.
    if (self.touch && self.touch->is_touched()) return;
    if (glfwGetMouseButton(window, GLFW_MOUSE_BUTTON_RIGHT) == GLFW_PRESS) {
      self.add(ui::kRightButton, ui::TouchPhase::kMove);
    } else if (glfwGetMouseButton(window, GLFW_MOUSE_BUTTON_LEFT) == GLFW_PRESS) {
      self.add(ui::kLeftButton, ui::TouchPhase::kMove);
    } else {
      self.add(ui::kLeftButton, ui::TouchPhase::kHover);
    }
  }
  static void on_letter(GLFWwindow* window, unsigned int letter) {
    of(window).keys.push_back({ui::KeyPress::Kind::kLetter, static_cast<char32_t>(letter)});
  }
  static void on_key(GLFWwindow* window, int key, int /*code*/, int action, int /*modifiers*/) {
    if (action == GLFW_RELEASE) return;
    using Kind = ui::KeyPress::Kind;
    if (key == GLFW_KEY_BACKSPACE) of(window).keys.push_back({Kind::kBackspace, 0});
    if (key == GLFW_KEY_ENTER || key == GLFW_KEY_KP_ENTER)
      of(window).keys.push_back({Kind::kEnter, 0});
    if (key == GLFW_KEY_ESCAPE) of(window).keys.push_back({Kind::kEscape, 0});
  }
  static void on_scroll(GLFWwindow* window, double /*x*/, double y) {
    of(window).add(ui::kLeftButton, ui::TouchPhase::kWheel, y);
  }
};

Window::Window(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Window::Window(Window&&) noexcept = default;
Window& Window::operator=(Window&&) noexcept = default;
Window::~Window() = default;

Result<Window> Window::open(const std::string& title, int width, int height) {
  const auto refused = [](const std::string& what) {
    const char* why = nullptr;
    glfwGetError(&why);
    return Error{ErrorCode::kNoDevice, what +
                                           (why != nullptr ? std::string(" (") + why + ")" : "") +
                                           "; start it on a desktop, or add --headless --out DIR"};
  };
  auto impl = std::make_unique<Impl>();
  if (glfwInit() != GLFW_TRUE) return refused("there is no display to open a window on");
  impl->glfw.initialised = true;
  glfwWindowHint(GLFW_CLIENT_API, GLFW_OPENGL_ES_API);
  glfwWindowHint(GLFW_CONTEXT_CREATION_API, GLFW_EGL_CONTEXT_API);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 0);
  glfwWindowHint(GLFW_DEPTH_BITS, 0);  // everything is drawn elsewhere first
  glfwWindowHint(GLFW_STENCIL_BITS, 0);
  impl->window = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
  if (impl->window == nullptr) return refused("the display gives no window with OpenGL ES 3.0");
  glfwMakeContextCurrent(impl->window);
  glfwSwapInterval(1);
  glfwSetWindowUserPointer(impl->window, impl.get());
  glfwSetMouseButtonCallback(impl->window, Impl::on_button);
  glfwSetCursorPosCallback(impl->window, Impl::on_cursor);
  glfwSetScrollCallback(impl->window, Impl::on_scroll);
  glfwSetCharCallback(impl->window, Impl::on_letter);
  glfwSetKeyCallback(impl->window, Impl::on_key);
  impl->touch = XinputTouch::listen(glfwGetX11Window(impl->window));
  return Window(std::move(impl));
}

int Window::width() const {
  int width = 0, height = 0;
  glfwGetFramebufferSize(impl_->window, &width, &height);
  return width;
}

int Window::height() const {
  int width = 0, height = 0;
  glfwGetFramebufferSize(impl_->window, &width, &height);
  return height;
}

double Window::dots_per_inch() const {
  GLFWmonitor* monitor = glfwGetPrimaryMonitor();
  if (monitor == nullptr) return 0;
  int width_mm = 0, height_mm = 0;
  glfwGetMonitorPhysicalSize(monitor, &width_mm, &height_mm);
  const GLFWvidmode* mode = glfwGetVideoMode(monitor);
  if (mode == nullptr || width_mm <= 0) return 0;
  return mode->width * kMmPerInch / width_mm;
}

bool Window::should_close() const { return glfwWindowShouldClose(impl_->window) == GLFW_TRUE; }

std::vector<ui::TouchEvent> Window::events(double timeout_s) {
  // A finger wakes the touch connection and not GLFW's: look often rather than wait long.
  glfwWaitEventsTimeout(timeout_s);
  if (impl_->touch) {
    const auto [sx, sy] = impl_->pixels_per_unit();
    for (ui::TouchEvent event : impl_->touch->take()) {
      event.x *= sx;
      event.y *= sy;
      event.t_s = glfwGetTime();
      impl_->events.push_back(event);
    }
  }
  return std::exchange(impl_->events, {});
}

std::vector<ui::KeyPress> Window::keys() { return std::exchange(impl_->keys, {}); }

void Window::swap() { glfwSwapBuffers(impl_->window); }

}  // namespace spool
