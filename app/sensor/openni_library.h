// What the OpenNI2 files share: the library's life, its notices, its images as ours.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include <OpenNI.h>

#include "vision/core/camera.h"
#include "vision/core/depth_frame.h"
#include "vision/core/result.h"

namespace spool::sensor {

// OpenNI2's own last words as one line, in brackets.
[[nodiscard]] std::string library_says();

// Keeps OpenNI2 initialised and one URI ours. OpenNI2 shares one device, and so one position in a
// recording, between all that open the same URI: a second opening is refused. Any thread.
class Lease {
 public:
  [[nodiscard]] static Result<std::unique_ptr<Lease>> take(const std::string& uri);
  ~Lease();
  Lease(const Lease&) = delete;
  Lease& operator=(const Lease&) = delete;

 private:
  explicit Lease(std::string uri) : uri_(std::move(uri)) {}
  std::string uri_;
};

// What OpenNI2 calls out, on threads of its own. Nothing of OpenNI2 may be called from there, so
// the calls only leave a note here.
class Notices final : public openni::OpenNI::DeviceConnectedListener,
                      public openni::OpenNI::DeviceDisconnectedListener,
                      public openni::OpenNI::DeviceStateChangedListener {
 public:
  enum class Kind { kConnected, kDisconnected, kEnded };
  struct Notice {
    Kind kind;
    std::string uri, name;
    int vendor = 0, product = 0;  // USB
  };

  Notices() {
    openni::OpenNI::addDeviceConnectedListener(this);
    openni::OpenNI::addDeviceDisconnectedListener(this);
    openni::OpenNI::addDeviceStateChangedListener(this);
  }
  ~Notices() {
    openni::OpenNI::removeDeviceConnectedListener(this);
    openni::OpenNI::removeDeviceDisconnectedListener(this);
    openni::OpenNI::removeDeviceStateChangedListener(this);
  }
  Notices(const Notices&) = delete;
  Notices& operator=(const Notices&) = delete;

  // The oldest note, waiting for one until `deadline`.
  std::optional<Notice> next(std::chrono::steady_clock::time_point deadline) {
    std::unique_lock lock(mutex_);
    if (!arrived_.wait_until(lock, deadline, [this] { return !notices_.empty(); }))
      return std::nullopt;
    Notice notice = std::move(notices_.front());
    notices_.pop_front();
    return notice;
  }

 private:
  void onDeviceConnected(const openni::DeviceInfo* info) override { add(Kind::kConnected, info); }
  void onDeviceDisconnected(const openni::DeviceInfo* info) override {
    add(Kind::kDisconnected, info);
  }
  void onDeviceStateChanged(const openni::DeviceInfo* info, openni::DeviceState state) override {
    if (state == openni::DEVICE_STATE_EOF) add(Kind::kEnded, info);
  }
  void add(Kind kind, const openni::DeviceInfo* info) {
    const std::scoped_lock lock(mutex_);
    notices_.push_back(
        {kind, info->getUri(), info->getName(), info->getUsbVendorId(), info->getUsbProductId()});
    arrived_.notify_all();
  }

  std::mutex mutex_;
  std::condition_variable arrived_;
  std::deque<Notice> notices_;
};

// Metres of one count; nothing for formats that are no plain distance.
[[nodiscard]] std::optional<double> count_metres(openni::PixelFormat format);

// The mode nearest to 640x480 at 30 frames a second, millimetres first: what every such camera has.
[[nodiscard]] std::optional<openni::VideoMode> best_mode(const openni::SensorInfo& info);

// Our pinhole of a depth stream; nothing where it does not tell size, format and fields of view.
[[nodiscard]] std::optional<Camera> camera_of(const openni::VideoStream& stream, bool mirrored);

// Copies a frame into the full size that `to` has: a cropped one to its place, a mirrored one
// turned back. False where it does not fit.
[[nodiscard]] bool copy_depth(const openni::VideoFrameRef& from, bool mirrored, DepthFrame& to);

}  // namespace spool::sensor
