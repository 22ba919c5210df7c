// OpenNI2 cameras and recordings as sources of frames.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "app/sensor/camera_choice.h"
#include "app/sensor/oni_check.h"
#include "app/sensor/openni.h"
#include "app/sensor/openni_library.h"
#include "app/sensor/playback_pace.h"
#include "app/sensor/relay_protocol.h"

namespace spool::sensor {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

// "640x480 px of 1 mm".
std::string mode_text(const Camera& camera) {
  char text[64];
  std::snprintf(text, sizeof text, "%dx%d px of %g mm", camera.width, camera.height,
                1e3 * camera.depth_unit_m);
  return text;
}

class OpenniSource final : public DepthSource {
 public:
  OpenniSource(std::string name, std::unique_ptr<Lease> lease, bool is_file,
               const SourceOptions& options)
      : name_(std::move(name)),
        lease_(std::move(lease)),
        is_file_(is_file),
        first_frame_(options.first_frame),
        pace_(options.speed) {}
  ~OpenniSource() override { close(); }

  const Camera& camera() const override { return camera_; }
  std::string description() const override { return description_; }
  std::string remark() const override { return remark_; }
  void set_remark(std::string remark) { remark_ = std::move(remark); }
  bool is_recording() const override { return is_file_; }

  // Opens the device and starts its depth stream. The camera is set the first time and has to be
  // the same each time after.
  Status open(const std::string& uri) {
    close();
    if (device_.open(uri.c_str()) != openni::STATUS_OK)
      return refuse("cannot be opened" + library_says());
    if (!device_.hasSensor(openni::SENSOR_DEPTH) ||
        stream_.create(device_, openni::SENSOR_DEPTH) != openni::STATUS_OK)
      return refuse("has no depth stream" + library_says());
    if (is_file_)
      set_up_playback();
    else
      set_up_camera();
    mirrored_ = stream_.getMirroringEnabled();
    const auto camera = camera_of(stream_, mirrored_);
    if (!camera) return refuse("does not tell its image size and fields of view");
    if (camera_.width != 0 &&
        (camera->width != camera_.width || camera->height != camera_.height ||
         camera->fx != camera_.fx || camera->depth_unit_m != camera_.depth_unit_m)) {
      wrong_mode_ = mode_text(*camera) + " pictures and not " + mode_text(camera_);
      return refuse("came back as another camera");
    }
    camera_ = *camera;
    if (stream_.start() != openni::STATUS_OK)
      return refuse("does not start its depth stream" + library_says());
    const openni::DeviceInfo& info = device_.getDeviceInfo();
    uri_ = info.getUri();
    device_name_ = info.getName();
    usb_ = {info.getUsbVendorId(), info.getUsbProductId()};
    const openni::Version version = openni::OpenNI::getVersion();
    description_ = (is_file_ ? "OpenNI2 recording " + name_
                             : std::string(info.getVendor()) + " " + device_name_ + " at " + uri_) +
                   ", OpenNI " + std::to_string(version.major) + "." +
                   std::to_string(version.minor) + "." + std::to_string(version.maintenance) + "." +
                   std::to_string(version.build);
    is_open_ = true;
    return is_file_ ? await_first() : Status();
  }

  Result<SourceOutput> next(milliseconds timeout) override {
    const auto deadline = Clock::now() + timeout;
    do {
      if (is_open_ && take_notices()) {
        close();  // the frames are copies; stream and device have to go before it can come back
        return SourceOutput{SourceEvent::kUnplugged, nullptr};
      }
      if (!is_open_) return wait_for_return(deadline);
      if (!waiting_ && !read(std::min(deadline, Clock::now() + kSlice))) {
        if (failure_) return *failure_;
        if (!wrong_mode_.empty())
          return SourceOutput{SourceEvent::kWrongMode, nullptr, std::exchange(wrong_mode_, {})};
        if (ended_ && is_file_ && count_ == 0)
          return refuse("holds no depth frame that OpenNI2 can play").error();
        if (ended_) {
          stream_.stop();  // else the file's thread goes on asking for the next frame at full speed
          return SourceOutput{SourceEvent::kEnd, nullptr};
        }
        continue;
      }
      if (waiting_ && is_file_ && waiting_->index < first_frame_) waiting_.reset();
      if (waiting_ && (!is_file_ || pace_.wait_for(waiting_->seconds, deadline)))
        return SourceOutput{SourceEvent::kFrame, std::exchange(waiting_, nullptr)};
    } while (Clock::now() < deadline);
    return SourceOutput{SourceEvent::kTimeout, nullptr};
  }

 private:
  static constexpr milliseconds kSlice{50};  // an unplugged device is noticed within this

  Status refuse(const std::string& why) const {
    return is_file_ ? Error{ErrorCode::kBadInput, name_ + ": " + why + "; record it again"}
                    : Error{ErrorCode::kNoDevice,
                            name_ + ": the camera " + why + "; plug it in again or try another"};
  }

  void close() {
    is_open_ = false;
    if (stream_.isValid()) stream_.stop();
    // A file's own thread walks its list of streams without a lock, at the end of the file without
    // a pause: destroying a stream meanwhile crashes it. With no stream started it looks at the
    // list for an instant every 10 ms only, so it is given the time to get there. (Closing the
    // device first would end the thread, but frees before that what the thread still hands its
    // frame to.)
    if (is_file_ && device_.isValid()) std::this_thread::sleep_for(milliseconds(50));
    if (stream_.isValid()) stream_.destroy();
    if (device_.isValid()) device_.close();
  }

  // A file's thread sets "running" when it starts: closed before that, it would run on and be
  // cancelled in the middle after 3 s. So a file counts as open once its thread has shown the first
  // frame or the end.
  Status await_first() {
    const auto deadline = Clock::now() + std::chrono::seconds(10);
    while (!waiting_ && !ended_ && Clock::now() < deadline) {
      take_notices();
      if (!read(Clock::now() + kSlice) && failure_) return *failure_;
    }
    return waiting_ || ended_ ? Status() : refuse("does not begin to play");
  }

  // Reads what OpenNI2 called out; true where this device was unplugged.
  bool take_notices() {
    bool unplugged = false;
    while (const auto notice = notices_.next(Clock::time_point())) {
      if (notice->uri != uri_) continue;
      ended_ = ended_ || notice->kind == Notices::Kind::kEnded;
      unplugged = unplugged || notice->kind == Notices::Kind::kDisconnected;
    }
    return unplugged;
  }

  void set_up_playback() {
    openni::PlaybackControl* playback = device_.getPlaybackControl();
    if (playback == nullptr) return;
    playback->setSpeed(-1);  // each frame once, when it is asked for; 0 would drop frames
    playback->setRepeatEnabled(false);
  }

  void set_up_camera() {
    if (device_.isImageRegistrationModeSupported(openni::IMAGE_REGISTRATION_OFF))
      device_.setImageRegistrationMode(openni::IMAGE_REGISTRATION_OFF);
    if (const auto mode = best_mode(stream_.getSensorInfo())) stream_.setVideoMode(*mode);
    stream_.resetCropping();
    stream_.setMirroringEnabled(false);  // many cameras mirror unless told not to
  }

  // Puts the next frame into waiting_; false where none came by `deadline`.
  bool read(Clock::time_point deadline) {
    const auto left =
        std::chrono::duration_cast<milliseconds>(deadline - Clock::now() + milliseconds(1));
    openni::VideoStream* streams[] = {&stream_};
    int ready = 0;
    const openni::Status status = openni::OpenNI::waitForAnyStream(
        streams, 1, &ready, static_cast<int>(std::max(left, milliseconds(1)).count()));
    if (status == openni::STATUS_TIME_OUT) return false;
    openni::VideoFrameRef from;
    if (status != openni::STATUS_OK || stream_.readFrame(&from) != openni::STATUS_OK) {
      failure_ = refuse("cannot be read" + library_says()).error();
      return false;
    }
    auto frame = std::make_shared<DepthFrame>();
    frame->width = camera_.width;
    frame->height = camera_.height;
    // Another program that shares the camera may set another mode.
    const auto unit = count_metres(from.getVideoMode().getPixelFormat());
    if ((unit && *unit != camera_.depth_unit_m) || !copy_depth(from, mirrored_, *frame)) {
      const Camera given{
          .width = from.getWidth(), .height = from.getHeight(), .depth_unit_m = unit.value_or(0)};
      wrong_mode_ = mode_text(given) + " pictures and not " + mode_text(camera_);
      if (is_file_) failure_ = refuse("gave " + wrong_mode_).error();
      return false;
    }
    number(from, *frame);
    waiting_ = std::move(frame);
    return true;
  }

  // A recording's frames are counted; a camera's own numbers (from 1) are kept, so that dropped
  // frames show. Both number and clock start anew when a camera comes back: then they go on from
  // where they were.
  void number(const openni::VideoFrameRef& from, DepthFrame& frame) {
    const double seconds = static_cast<double>(from.getTimestamp()) * 1e-6;
    std::int64_t index = is_file_ ? count_ : from.getFrameIndex() - 1 + index_offset_;
    if (index < next_index_) {
      index_offset_ += next_index_ - index;
      index = next_index_;
    }
    if (count_ > 0 && seconds + seconds_offset_ < last_seconds_) {
      const std::chrono::duration<double> gap = Clock::now() - last_arrival_;
      seconds_offset_ = last_seconds_ + (is_file_ ? 0 : gap.count()) - seconds;
    }
    frame.index = index;
    frame.seconds = seconds + seconds_offset_;
    next_index_ = index + 1;
    last_seconds_ = frame.seconds;
    last_arrival_ = Clock::now();
    ++count_;
  }

  // After an unplugging: opens the camera when it, or one of the same make, is connected.
  Result<SourceOutput> wait_for_return(Clock::time_point deadline) {
    while (const auto notice = notices_.next(deadline)) {
      if (notice->kind != Notices::Kind::kConnected) continue;
      const bool same_make = notice->name == device_name_ && notice->vendor == usb_.first &&
                             notice->product == usb_.second && usb_ != std::pair(0, 0);
      if (notice->uri == uri_ || same_make) candidate_ = notice->uri;
      break;
    }
    // A camera may need a moment before it can be opened: it is tried again at the next call.
    if (candidate_.empty() || !open(candidate_)) {
      if (wrong_mode_.empty()) return SourceOutput{SourceEvent::kTimeout, nullptr};
      candidate_.clear();  // it would come back the same: a person has to do something
      return SourceOutput{SourceEvent::kWrongMode, nullptr, std::exchange(wrong_mode_, {})};
    }
    candidate_.clear();
    return SourceOutput{SourceEvent::kReplugged, nullptr};
  }

  std::string name_;
  std::unique_ptr<Lease> lease_;
  bool is_file_;
  std::int64_t first_frame_;
  PlaybackPace pace_;
  Notices notices_;
  openni::Device device_;
  openni::VideoStream stream_;
  bool is_open_ = false, mirrored_ = false, ended_ = false;
  Camera camera_;
  std::string description_, remark_, uri_, device_name_;
  std::string wrong_mode_;  // how what came was other than camera_; said once
  std::pair<int, int> usb_;
  std::string candidate_;  // URI of the camera that came back
  std::shared_ptr<DepthFrame> waiting_;
  std::optional<Error> failure_;
  std::int64_t count_ = 0, next_index_ = 0, index_offset_ = 0;
  double last_seconds_ = 0, seconds_offset_ = 0;  // s
  Clock::time_point last_arrival_;
};

// True for what is in OpenNI2's list without being a camera: recordings, our simulator and relay.
bool is_no_camera(const std::string& uri) {
  std::error_code ignored;
  return uri.rfind(kRelayScheme, 0) == 0 || uri.rfind(kSimulatorScheme, 0) == 0 ||
         fs::exists(uri, ignored);
}

OpenedSource opened(std::string name, const std::string& uri, std::unique_ptr<Lease> lease,
                    bool is_file, const SourceOptions& options, std::string remark = {}) {
  auto source = std::make_unique<OpenniSource>(std::move(name), std::move(lease), is_file, options);
  source->set_remark(std::move(remark));
  if (const Status status = source->open(uri); !status) return status.error();
  return std::unique_ptr<DepthSource>(std::move(source));
}

}  // namespace

OpenedSource open_openni_device(const std::string& uri) {
  auto lease = Lease::take(uri.empty() ? "openni" : uri);
  if (!lease) return lease.error();
  if (!uri.empty()) return opened("openni:" + uri, uri, *std::move(lease), false, {});
  openni::Array<openni::DeviceInfo> devices;
  openni::OpenNI::enumerateDevices(&devices);
  std::vector<PluggedCamera> cameras;
  for (int i = 0; i < devices.getSize(); ++i)
    if (const std::string found = devices[i].getUri(); !is_no_camera(found))
      cameras.push_back({found, devices[i].getName()});
  if (auto choice = choose_camera(cameras))
    return opened("openni", choice->uri, *std::move(lease), false, {}, std::move(choice->remark));
  return Error{ErrorCode::kNoDevice,
               "openni: no depth camera is found; plug one in, put its maker's OpenNI2 driver into "
               "openni2/OpenNI2/Drivers beside the programs, or use a recording"};
}

OpenedSource open_simulated(const std::string& scene) {
  const std::string path = fs::absolute(scene.empty() ? SPOOL_SAMPLE_SCENE : scene).string();
  const std::string uri = kSimulatorScheme + path;
  if (uri.size() >= ONI_MAX_STR)
    return Error{ErrorCode::kBadInput,
                 scene + ": the path is too long for OpenNI2; use a shorter one"};
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored))
    return Error{ErrorCode::kBadInput, path + ": is no scene that can be read; check the path"};
  auto lease = Lease::take(uri);
  if (!lease) return lease.error();
  auto source = opened("simulated:" + path, uri, *std::move(lease), false, {});
  if (source) return source;
  // The plug-in's own sentence names a file; without it the plug-in itself is missing.
  const std::string& says = source.error().message;
  const std::size_t quoted = says.find('(');
  if (quoted != says.npos && says.find(": ", quoted) != says.npos &&
      says.find("DeviceOpen", quoted) > says.find(": ", quoted))
    return Error{ErrorCode::kBadInput,
                 says.substr(quoted + 1, says.find(" DeviceOpen") - quoted - 1)};
  return Error{
      ErrorCode::kNoDevice,
      "simulated:" + path +
          ": does not start; libSpoolSim.so.0 has to lie in openni2/OpenNI2/Drivers beside "
          "the programs"};
}

OpenedSource open_oni_unchecked(const std::string& path, const SourceOptions& options) {
  std::error_code code;
  const std::string uri = fs::absolute(path, code).string();
  if (!fs::is_regular_file(uri, code))
    return Error{ErrorCode::kBadInput, path + ": is no file that can be read; check the path"};
  if (uri.size() >= ONI_MAX_STR)
    return Error{ErrorCode::kBadInput,
                 path + ": the path is too long for OpenNI2; use a shorter one"};
  auto lease = Lease::take(uri);
  if (!lease) return lease.error();
  return opened(path, uri, *std::move(lease), true, options);
}

OpenedSource open_oni_file(const std::string& path, const SourceOptions& options) {
  if (const Status checked = check_oni(path); !checked) return checked.error();
  return open_oni_unchecked(path, options);
}

}  // namespace spool::sensor
