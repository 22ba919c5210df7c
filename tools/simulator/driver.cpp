// The OpenNI2 driver plug-in: simulated cameras, and the relay that recordings pass through.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <cstdio>
#include <cstring>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>

#include "app/sensor/relay_protocol.h"
#include "tools/simulator/driver_stream.h"
#include "tools/simulator/simulator.h"

namespace spool::simulator {
namespace {

using Clock = std::chrono::steady_clock;

Clock::duration as_duration(double seconds) {
  return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

// Waits until `time`; false when asked to stop before.
bool sleep_until(Clock::time_point time, const std::stop_token& stop) {
  std::mutex mutex;
  std::condition_variable_any never;
  std::unique_lock lock(mutex);
  never.wait_until(lock, stop, time, [] { return false; });
  return !stop.stop_requested();
}

// What all openings of one simulated camera share: the scene, and a clock that runs from the first
// start of its stream on, unplugged or not.
struct SimulatedCamera {
  explicit SimulatedCamera(Simulator opened) : simulator(std::move(opened)) {}
  const Simulator simulator;
  std::mutex mutex;
  std::optional<Clock::time_point> start;
  bool plugged = true;

  Clock::time_point started() {
    const std::scoped_lock lock(mutex);
    if (!start) start = Clock::now();
    return *start;
  }
  bool is_plugged() {
    const std::scoped_lock lock(mutex);
    return plugged;
  }
};

// Serves the frame that is due by the wall clock; frames that take too long to make are left out.
class SimulatedStream final : public DepthStream {
 public:
  SimulatedStream(std::shared_ptr<SimulatedCamera> camera, std::function<void()> on_start)
      : DepthStream(
            camera->simulator.scene().sensor.camera,
            static_cast<int>(std::lround(camera->simulator.scene().sensor.frames_per_second)),
            camera->simulator.scene().sensor.mirrored),
        camera_(std::move(camera)),
        on_start_(std::move(on_start)) {}
  ~SimulatedStream() override { stop(); }

  OniStatus start() override {
    on_start_();
    thread_ = std::jthread([this](const std::stop_token& stop) { serve(stop); });
    return ONI_STATUS_OK;
  }
  void stop() override {
    if (!thread_.joinable()) return;
    thread_.request_stop();
    thread_.join();
  }

 private:
  void serve(const std::stop_token& stop) {
    const double period = 1 / camera_->simulator.scene().sensor.frames_per_second;
    const Clock::time_point start = camera_->started();
    FrameBuffers buffers;
    DepthFrame frame;
    for (std::int64_t next = 0;;) {
      const std::chrono::duration<double> since = Clock::now() - start;
      next = std::max(next, static_cast<std::int64_t>(since.count() / period));
      if (!sleep_until(start + as_duration(static_cast<double>(next) * period), stop)) return;
      if (camera_->is_plugged()) {
        camera_->simulator.frame(next, buffers, frame);
        if (stop.stop_requested()) return;
        raise(frame.depth, static_cast<std::uint64_t>(std::llround(frame.seconds * 1e6)),
              static_cast<int>(next + 1));
      }
      ++next;
    }
  }

  std::shared_ptr<SimulatedCamera> camera_;
  std::function<void()> on_start_;
  std::jthread thread_;
};

// Gives out what sensor::OniWriter pushes into it.
class RelayStream final : public DepthStream {
 public:
  explicit RelayStream(const Camera& camera) : DepthStream(camera, 30, false) {}
  OniStatus start() override { return ONI_STATUS_OK; }
  void stop() override {}
  OniBool isCommandSupported(int command) override {
    return command == sensor::kRelayPushCommand ? TRUE : FALSE;
  }
  OniStatus invoke(int command, void* data, int size) override {
    if (command != sensor::kRelayPushCommand ||
        size != static_cast<int>(sizeof(sensor::RelayFrame)))
      return ONI_STATUS_NOT_SUPPORTED;
    sensor::RelayFrame frame{};
    std::memcpy(&frame, data, sizeof frame);
    const OniVideoMode size_px = mode();
    raise({frame.depth, static_cast<std::size_t>(size_px.resolutionX) *
                            static_cast<std::size_t>(size_px.resolutionY)},
          frame.microseconds, frame.index);
    return ONI_STATUS_OK;
  }
};

// A camera with one depth sensor.
class Device final : public oni::driver::DeviceBase {
 public:
  Device(std::string uri, std::function<DepthStream*()> create)
      : uri_(std::move(uri)), create_(std::move(create)) {
    const std::unique_ptr<DepthStream> probe(create_());
    mode_ = probe->mode();
    info_ = {ONI_SENSOR_DEPTH, 1, &mode_};
  }
  const std::string& uri() const { return uri_; }
  OniStatus getSensorInfoList(OniSensorInfo** list, int* count) override {
    *list = &info_;
    *count = 1;
    return ONI_STATUS_OK;
  }
  oni::driver::StreamBase* createStream(OniSensorType type) override {
    return type == ONI_SENSOR_DEPTH ? create_() : nullptr;
  }
  void destroyStream(oni::driver::StreamBase* stream) override { delete stream; }

 private:
  std::string uri_;
  std::function<DepthStream*()> create_;
  OniVideoMode mode_{};
  OniSensorInfo info_{};
};

class Driver final : public oni::driver::DriverBase {
 public:
  explicit Driver(OniDriverServices* services) : DriverBase(services) {}

  // OpenNI2 asks this for a URI that it does not know: scenes and relays come to be by being
  // opened.
  OniStatus tryDevice(const char* uri) override {
    const std::string text = uri;
    if (text.rfind(sensor::kSimulatorScheme, 0) == 0) {
      auto opened = Simulator::open(text.substr(std::strlen(sensor::kSimulatorScheme)));
      if (!opened) {
        getServices().errorLoggerAppend("%s", opened.error().message.c_str());
        return ONI_STATUS_ERROR;
      }
      const std::scoped_lock lock(mutex_);
      cameras_[text] = std::make_shared<SimulatedCamera>(*std::move(opened));
    } else if (text.rfind(sensor::kRelayScheme, 0) != 0 || !relay_camera(text)) {
      return ONI_STATUS_NOT_SUPPORTED;
    }
    const OniDeviceInfo info = info_of(text);
    deviceConnected(&info);
    return ONI_STATUS_OK;
  }

  oni::driver::DeviceBase* deviceOpen(const char* uri, const char*) override {
    const std::string text = uri;
    if (const auto relay = relay_camera(text))
      return new Device(text, [camera = *relay] { return new RelayStream(camera); });
    const std::scoped_lock lock(mutex_);
    const auto found = cameras_.find(text);
    if (found == cameras_.end()) return nullptr;
    return new Device(text, [this, text, camera = found->second] {
      return new SimulatedStream(camera, [this, text, camera] { plan_unplugging(text, camera); });
    });
  }
  // Closing a camera that is plugged in ends its unplugging, which must not wait for shutdown():
  // there OpenNI2 holds the lock that its own notices need. Closed while it is unplugged, a camera
  // comes back.
  void deviceClose(oni::driver::DeviceBase* device) override {
    const std::string uri = static_cast<Device*>(device)->uri();
    delete device;
    std::jthread ended;  // joined after the lock is free
    const std::scoped_lock lock(mutex_);
    const auto camera = cameras_.find(uri);
    if (camera == cameras_.end() || !camera->second->is_plugged()) return;
    if (const auto thread = unplugging_.find(uri); thread != unplugging_.end()) {
      ended = std::move(thread->second);
      unplugging_.erase(thread);
      ended.request_stop();
    }
  }
  void shutdown() override { unplugging_.clear(); }

 private:
  static OniDeviceInfo info_of(const std::string& uri) {
    OniDeviceInfo info{};
    std::snprintf(info.uri, sizeof info.uri, "%s", uri.c_str());
    std::snprintf(info.vendor, sizeof info.vendor, "SpoolSight");
    std::snprintf(info.name, sizeof info.name, "%s",
                  uri.rfind(sensor::kRelayScheme, 0) == 0 ? "relay" : "simulated depth camera");
    return info;
  }

  // The camera that a relay's URI describes.
  static std::optional<Camera> relay_camera(const std::string& uri) {
    int id = 0, width = 0, height = 0;
    double hfov = 0, vfov = 0;
    long unit_um = 0;
    if (uri.rfind(sensor::kRelayScheme, 0) != 0 ||
        std::sscanf(uri.c_str() + std::strlen(sensor::kRelayScheme), "%d,%d,%d,%lf,%lf,%ld", &id,
                    &width, &height, &hfov, &vfov, &unit_um) != 6)
      return std::nullopt;
    Camera camera;
    camera.width = width;
    camera.height = height;
    camera.fx = width / (2 * std::tan(hfov / 2));
    camera.fy = height / (2 * std::tan(vfov / 2));
    camera.depth_unit_m = static_cast<double>(unit_um) * 1e-6;
    return camera.is_valid() ? std::optional(camera) : std::nullopt;
  }

  // Pulls the plug and puts it back as the scene says, on the camera's clock.
  void plan_unplugging(const std::string& uri, const std::shared_ptr<SimulatedCamera>& camera) {
    const std::scoped_lock lock(mutex_);
    if (camera->simulator.scene().unplug.empty() || unplugging_.count(uri) != 0) return;
    unplugging_[uri] = std::jthread([this, uri, camera](const std::stop_token& stop) {
      const OniDeviceInfo info = info_of(uri);
      const Clock::time_point start = camera->started(), planned = Clock::now();
      const auto set_plugged = [&](bool plugged) {
        const std::scoped_lock camera_lock(camera->mutex);
        camera->plugged = plugged;
      };
      for (const Unplugging& one : camera->simulator.scene().unplug) {
        if (start + as_duration(one.at_s + one.for_s) < planned) continue;  // before this opening
        if (!sleep_until(start + as_duration(one.at_s), stop)) return;
        set_plugged(false);
        deviceDisconnected(&info);
        if (!sleep_until(start + as_duration(one.at_s + one.for_s), stop)) return;
        set_plugged(true);
        deviceConnected(&info);
      }
    });
  }

  std::mutex mutex_;  // of what follows
  std::map<std::string, std::shared_ptr<SimulatedCamera>> cameras_;
  std::map<std::string, std::jthread> unplugging_;
};

}  // namespace
}  // namespace spool::simulator

ONI_EXPORT_DRIVER(spool::simulator::Driver)
