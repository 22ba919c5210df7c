// A display of its own with a touch screen.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/app/e2e/touch_display.h"

#include <array>
#include <chrono>
#include <cstring>
#include <fstream>
#include <thread>

#include <sys/socket.h>
#include <sys/time.h>
#include <sys/un.h>
#include <unistd.h>

#include <xorg/xf86-input-inputtest-protocol.h>

namespace spool::test {

namespace {
using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr seconds kPatience{30};      // for a server on a busy machine
constexpr double kAxisEnd = 65535.0;  // the driver's axes, across the whole screen

Error absent(const std::string& what) { return {ErrorCode::kNoDevice, what}; }

std::string server_configuration(const std::filesystem::path& socket) {
  return R"(Section "ServerFlags"
  Option "AutoAddDevices" "false"
EndSection
Section "Device"
  Identifier "card"
  Driver "dummy"
  VideoRam 64000
EndSection
Section "Monitor"
  Identifier "glass"
  HorizSync 5-1000
  VertRefresh 5-200
  Modeline "1280x800" 83.46 1280 1344 1480 1680 800 801 804 828
EndSection
Section "Screen"
  Identifier "screen"
  Device "card"
  Monitor "glass"
  DefaultDepth 24
  SubSection "Display"
    Depth 24
    Modes "1280x800"
  EndSubSection
EndSection
Section "InputDevice"
  Identifier "fingers"
  Driver "inputtest"
  Option "SocketPath" ")" +
         socket.string() + R"("
  Option "DeviceType" "Touch"
  Option "TouchCount" "10"
EndSection
Section "ServerLayout"
  Identifier "layout"
  Screen "screen"
  InputDevice "fingers" "SendCoreEvents"
EndSection
)";
}

// Of the X Input extension; the protocol's header names them without giving them.
enum TouchType : std::uint32_t { kTouchBegin = 18, kTouchUpdate = 19, kTouchEnd = 20 };

template <class Message>
bool send_message(int socket, const Message& message) {
  return ::send(socket, &message, sizeof message, MSG_NOSIGNAL) ==
         static_cast<ssize_t>(sizeof message);
}

bool receive(int socket, void* into, std::size_t bytes) {
  return ::recv(socket, into, bytes, MSG_WAITALL) == static_cast<ssize_t>(bytes);
}

// Returns once the server has made an X event of the message.
bool send_touch(int socket, std::uint32_t finger, TouchType type, const Spot& spot) {
  xf86ITEventTouch touch{};
  touch.header = {sizeof touch, XF86IT_EVENT_TOUCH};
  touch.touchid = finger;
  touch.touch_type = type;
  touch.valuators.mask[0] = 3;  // x and y
  touch.valuators.valuators[0] = spot.x / TouchDisplay::kWidth * kAxisEnd;
  touch.valuators.valuators[1] = spot.y / TouchDisplay::kHeight * kAxisEnd;
  xf86ITEventWaitForSync wait{};
  wait.header = {sizeof wait, XF86IT_EVENT_WAIT_FOR_SYNC};
  xf86ITResponseSyncFinished finished{};
  return send_message(socket, touch) && send_message(socket, wait) &&
         receive(socket, &finished, sizeof finished);
}

}  // namespace

Result<std::unique_ptr<TouchDisplay>> TouchDisplay::start(const std::filesystem::path& folder) {
  const auto program = find_tool("Xorg");
  if (!program) return absent("Xorg is not installed: xserver-xorg-core");
  const std::filesystem::path socket = folder / "fingers.socket", configuration = folder / "x.conf",
                              log = folder / "x.log";
  std::ofstream(configuration) << server_configuration(socket);
  // Without a virtual terminal to switch to; the server says on which free display it runs.
  auto server = std::make_unique<RunningProgram>(std::vector<std::string>{
      *program, "-displayfd", "1", "-config", configuration, "-logfile", log, "-noreset",
      "-nolisten", "tcp", "-novtswitch", "-sharevts", "vt7"});
  const auto number = server->next_line(kPatience);
  if (!number) {
    std::string faults;
    std::ifstream in(log);
    for (std::string line; std::getline(in, line);) {
      if (line.find("(EE)") != std::string::npos) faults += "\n" + line;
    }
    return absent("Xorg did not start; xserver-xorg-video-dummy may not be installed" + faults);
  }
  std::unique_ptr<TouchDisplay> display(new TouchDisplay(std::move(server), ":" + *number));
  if (const Status connected = display->connect(socket); !connected) return connected.error();
  return display;
}

TouchDisplay::~TouchDisplay() {
  if (socket_ >= 0) ::close(socket_);
  // Killed, the server would leave its lock of the display's number behind.
  server_->terminate();
  static_cast<void>(server_->wait_for_end(kPatience));
}

// The driver takes one connection in the life of a server.
Status TouchDisplay::connect(const std::filesystem::path& socket) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (socket.string().size() >= sizeof address.sun_path) {
    return absent(socket.string() + " is too long for a socket's name");
  }
  std::strncpy(address.sun_path, socket.c_str(), sizeof address.sun_path - 1);
  socket_ = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  const timeval patience{kPatience.count(), 0};
  ::setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
  const auto deadline = std::chrono::steady_clock::now() + kPatience;
  while (::connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
    if (std::chrono::steady_clock::now() > deadline) {
      return absent("the input test driver opens no socket");
    }
    std::this_thread::sleep_for(milliseconds(20));
  }
  xf86ITEventClientVersion version{};
  version.header = {sizeof version, XF86IT_EVENT_CLIENT_VERSION};
  version.major = XF86IT_PROTOCOL_VERSION_MAJOR;
  version.minor = XF86IT_PROTOCOL_VERSION_MINOR;
  xf86ITResponseServerVersion answer{};
  if (!send_message(socket_, version) || !receive(socket_, &answer, sizeof answer)) {
    return absent("the input test driver refuses the protocol's version");
  }
  return {};
}

bool TouchDisplay::down(std::uint32_t finger, const Spot& spot) const {
  return send_touch(socket_, finger, kTouchBegin, spot);
}
bool TouchDisplay::move(std::uint32_t finger, const Spot& spot) const {
  return send_touch(socket_, finger, kTouchUpdate, spot);
}
bool TouchDisplay::up(std::uint32_t finger, const Spot& spot) const {
  return send_touch(socket_, finger, kTouchEnd, spot);
}

bool TouchDisplay::tap(const Spot& spot) const { return down(0, spot) && up(0, spot); }

}  // namespace spool::test
