// Writing .oni files by OpenNI2's own recorder.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <system_error>
#include <thread>
#include <utility>

#include "app/sensor/openni.h"
#include "app/sensor/openni_library.h"
#include "app/sensor/relay_protocol.h"

namespace spool::sensor {
namespace {

class RelayWriter final : public OniWriter {
 public:
  RelayWriter(std::string path, const Camera& camera, std::unique_ptr<Lease> lease)
      : path_(std::move(path)),
        width_(camera.width),
        height_(camera.height),
        lease_(std::move(lease)) {}
  ~RelayWriter() override { finish(); }

  Status open(const std::string& uri) {
    if (device_.open(uri.c_str()) != openni::STATUS_OK ||
        stream_.create(device_, openni::SENSOR_DEPTH) != openni::STATUS_OK)
      return Error{
          ErrorCode::kNoDevice,
          path_ + ": cannot be recorded" + library_says() +
              "; libSpoolSim.so.0 has to lie in openni2/OpenNI2/Drivers beside the programs"};
    if (recorder_.create(path_.c_str()) != openni::STATUS_OK ||
        recorder_.attach(stream_, false) != openni::STATUS_OK ||
        stream_.start() != openni::STATUS_OK || recorder_.start() != openni::STATUS_OK ||
        !wait_until_recording())
      return Error{ErrorCode::kIo, path_ + ": cannot be written" + library_says() +
                                       "; free space or choose another folder"};
    return {};
  }

  Status write(const DepthFrame& frame) override {
    if (!frame.is_consistent() || frame.width != width_ || frame.height != height_)
      return Error{ErrorCode::kBadInput,
                   path_ + ": frame " + std::to_string(frame.index) +
                       " has not the size of the camera that is recorded; start a new recording"};
    // The recorder's codec garbles the largest count it is told of, which is 65535.
    if (std::find(frame.depth.begin(), frame.depth.end(), 65535) != frame.depth.end())
      return Error{ErrorCode::kBadInput, path_ + ": frame " + std::to_string(frame.index) +
                                             " holds the count 65535, which .oni cannot hold; "
                                             "record to a depth folder"};
    RelayFrame relayed{frame.depth.data(),
                       static_cast<std::uint64_t>(std::llround(std::max(frame.seconds, 0.0) * 1e6)),
                       ++count_};
    if (stream_.invoke(kRelayPushCommand, &relayed, static_cast<int>(sizeof relayed)) !=
        openni::STATUS_OK)
      return Error{ErrorCode::kInternal, path_ + ": the relay refused a frame" + library_says()};
    return {};
  }

  void finish() override {
    if (recorder_.isValid()) {
      recorder_.stop();
      recorder_.destroy();
    }
    if (stream_.isValid()) {
      stream_.stop();
      stream_.destroy();
    }
    if (device_.isValid()) device_.close();
  }

 private:
  // The recorder starts on a thread of its own and drops, without a word, what comes before. It
  // writes a header then: once that has come to rest, frames are taken. False where nothing is
  // written.
  bool wait_until_recording() const {
    using std::chrono::milliseconds;
    std::uintmax_t size = 0;
    std::error_code ignored;
    for (int quiet = 0, tries = 0; quiet < 10 && tries < 500; ++tries) {
      std::this_thread::sleep_for(milliseconds(10));
      const std::uintmax_t now = std::filesystem::file_size(path_, ignored);
      quiet = !ignored && now > 0 && now == size ? quiet + 1 : 0;
      size = ignored ? 0 : now;
    }
    return size > 0;
  }

  std::string path_;
  int width_, height_;
  std::unique_ptr<Lease> lease_;  // outlives what follows
  openni::Device device_;
  openni::VideoStream stream_;
  openni::Recorder recorder_;
  std::int32_t count_ = 0;
};

}  // namespace

Result<std::unique_ptr<OniWriter>> create_oni(const std::string& path, const Camera& camera) {
  const auto near = [](double a, double b) { return std::abs(a - b) < 1e-6; };
  if (!camera.is_valid() || !near(camera.cx, camera.width / 2.0) ||
      !near(camera.cy, camera.height / 2.0))
    return Error{ErrorCode::kBadInput,
                 path +
                     ": .oni cannot hold a principal point away from the image's middle; record "
                     "to a depth folder"};
  if (!near(camera.depth_unit_m * 1e3, 1) && !near(camera.depth_unit_m * 1e4, 1))
    return Error{ErrorCode::kBadInput,
                 path + ": .oni holds counts of 1 mm or 0.1 mm only; record to a depth folder"};
  static std::atomic<int> id{0};  // each recording has a device of its own
  char uri[ONI_MAX_STR];
  std::snprintf(uri, sizeof uri, "%s%d,%d,%d,%.9g,%.9g,%ld", kRelayScheme, ++id, camera.width,
                camera.height, 2 * std::atan(camera.width / (2 * camera.fx)),
                2 * std::atan(camera.height / (2 * camera.fy)),
                std::lround(camera.depth_unit_m * 1e6));
  auto lease = Lease::take(uri);
  if (!lease) return lease.error();
  auto writer = std::make_unique<RelayWriter>(path, camera, *std::move(lease));
  if (const Status status = writer->open(uri); !status) return status.error();
  return std::unique_ptr<OniWriter>(std::move(writer));
}

}  // namespace spool::sensor
