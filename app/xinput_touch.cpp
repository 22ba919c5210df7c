// Every finger on an X11 window.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/xinput_touch.h"

#include <array>
#include <map>
#include <utility>

#include <X11/Xlib.h>
#include <X11/extensions/XInput2.h>

namespace spool {

struct XinputTouch::Impl {
  Display* display = nullptr;
  int opcode = 0;
  std::map<int, int> finger_of_touch;  // XInput counts touches without end

  ~Impl() {
    if (display != nullptr) XCloseDisplay(display);
  }

  // The lowest number that no finger has.
  [[nodiscard]] int free_finger() const {
    for (int finger = 0;; ++finger) {
      bool taken = false;
      for (const auto& [touch, used] : finger_of_touch) taken = taken || used == finger;
      if (!taken) return finger;
    }
  }
};

XinputTouch::XinputTouch(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
XinputTouch::~XinputTouch() = default;

std::unique_ptr<XinputTouch> XinputTouch::listen(unsigned long window) {
  if (window == 0) return nullptr;
  auto impl = std::make_unique<Impl>();
  impl->display = XOpenDisplay(nullptr);
  if (impl->display == nullptr) return nullptr;
  int event = 0, error = 0;
  if (XQueryExtension(impl->display, "XInputExtension", &impl->opcode, &event, &error) == 0)
    return nullptr;
  int major = 2, minor = 2;  // the first with touch
  if (XIQueryVersion(impl->display, &major, &minor) != Success) return nullptr;
  if (major < 2 || (major == 2 && minor < 2)) return nullptr;
  std::array<unsigned char, XIMaskLen(XI_LASTEVENT)> bits{};
  XISetMask(bits.data(), XI_TouchBegin);
  XISetMask(bits.data(), XI_TouchUpdate);
  XISetMask(bits.data(), XI_TouchEnd);
  XIEventMask mask{XIAllMasterDevices, static_cast<int>(bits.size()), bits.data()};
  if (XISelectEvents(impl->display, window, &mask, 1) != Success) return nullptr;
  XSync(impl->display, False);
  return std::unique_ptr<XinputTouch>(new XinputTouch(std::move(impl)));
}

bool XinputTouch::is_touched() const { return !impl_->finger_of_touch.empty(); }

std::vector<ui::TouchEvent> XinputTouch::take() {
  std::vector<ui::TouchEvent> out;
  while (XPending(impl_->display) > 0) {
    XEvent event;
    XNextEvent(impl_->display, &event);
    if (event.type != GenericEvent || event.xcookie.extension != impl_->opcode ||
        XGetEventData(impl_->display, &event.xcookie) == 0) {
      continue;
    }
    const auto* device = static_cast<const XIDeviceEvent*>(event.xcookie.data);
    const auto known = impl_->finger_of_touch.find(device->detail);
    ui::TouchEvent touch;
    touch.x = device->event_x;
    touch.y = device->event_y;
    if (event.xcookie.evtype == XI_TouchBegin && known == impl_->finger_of_touch.end()) {
      touch.id = impl_->free_finger();
      touch.phase = ui::TouchPhase::kDown;
      impl_->finger_of_touch[device->detail] = touch.id;
      out.push_back(touch);
    } else if (known != impl_->finger_of_touch.end()) {
      touch.id = known->second;
      touch.phase = ui::TouchPhase::kMove;
      if (event.xcookie.evtype == XI_TouchEnd) {
        touch.phase = ui::TouchPhase::kUp;
        impl_->finger_of_touch.erase(known);
      }
      out.push_back(touch);
    }
    XFreeEventData(impl_->display, &event.xcookie);
  }
  return out;
}

}  // namespace spool
