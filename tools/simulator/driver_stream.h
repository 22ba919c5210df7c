// A depth stream as OpenNI2's driver interface wants it: properties, and frames handed up.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <mutex>
#include <span>

#include "tools/simulator/oni_driver.h"
#include "vision/core/camera.h"

namespace spool::simulator {

// One depth stream of one size. Properties may be asked for on any thread.
class DepthStream : public oni::driver::StreamBase {
 public:
  DepthStream(const Camera& camera, int frames_per_second, bool mirrored);

  OniStatus getProperty(int property, void* data, int* size) override;
  OniStatus setProperty(int property, const void* data, int size) override;
  OniBool isPropertySupported(int property) override;

  [[nodiscard]] OniVideoMode mode() const { return mode_; }

 protected:
  // Hands a frame to OpenNI2, mirrored if that is set. `index` counts from 1 as cameras do.
  void raise(std::span<const std::uint16_t> depth, std::uint64_t microseconds, int index);

 private:
  OniVideoMode mode_;
  float horizontal_fov_rad_, vertical_fov_rad_;
  std::mutex mutex_;  // of what follows
  bool mirrored_;
  OniCropping cropping_{};
};

}  // namespace spool::simulator
